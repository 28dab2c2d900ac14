"""The examples are whole: read, checked, saved unchanged, played, translated, and drawn."""

from __future__ import annotations

from pathlib import Path

import polib
import pytest

from situ.decide.trace import TraceEvent, to_fields
from situ.document import codec, folder
from situ.document.check import check
from situ.document.flatten import flatten
from situ.document.project import Project
from situ.document.rbd import (
    Always,
    Application,
    Button,
    Image,
    List,
    Movie,
    Sound,
    Speech,
    State,
    Text,
)
from situ.document.texts_shown import has_words, setting_texts
from situ.rehearse import scenario
from situ.rehearse.expect import Expect
from situ.rehearse.simulate import simulate

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
NAMES = ["conversation", "reception", "vitals"]
SCENARIOS = sorted(EXAMPLES.glob("*/scenarios/*.jsonl"))

# The reading of Fig. 6, all of its arrows: from, event, to.
ARROWS = """
start screenTouched intro
start humanDetected intro
intro clickContinue enter initial 1
enter initial 1 clickConfirm enter initial 2
enter initial 2 clickConfirm verify initials
verify initials clickConfirm show names
verify initials clickNo enter initial 1
show names clickYes search names
show names clickNo learn user
search names returnedWithNames names
search names returnedWithNoNames no user
names userNameSelected save profile
greeting clickContinue main menu
main menu clickMeasure measure
measure clickSPO2 SPO2
no user tryAgain enter initial 1
no user clickNo learn user
learn user clickYes first name
learn user clickNo start
first name clickConfirm last name
last name clickConfirm verify name
verify name clickYes register name
verify name clickNo first name
register name registrationComplete greeting
register name registrationIncomplete register error
register error clickContinue learn user
"""


def project(name: str) -> Project:
    loaded, problems = folder.load(EXAMPLES / name)
    assert problems == []
    assert loaded is not None
    return loaded


def application(name: str) -> Application:
    (only,) = project(name).applications.values()
    assert isinstance(only, Application)
    return only


def files(name: str) -> list[Application]:
    """The example's applications and their parts."""
    return list(project(name).flows.values())


@pytest.mark.parametrize("name", NAMES)
def test_an_example_has_no_problem(name: str) -> None:
    assert [str(p) for p in check(project(name))] == []


@pytest.mark.parametrize("file", sorted(EXAMPLES.glob("*/*.xml")), ids=lambda p: p.name)
def test_saving_an_example_changes_no_byte(file: Path) -> None:
    data = file.read_bytes()
    document, problems = codec.read(data, str(file))
    assert problems == []
    assert document is not None
    assert codec.write(document) == data


@pytest.mark.parametrize("file", SCENARIOS, ids=lambda p: f"{p.parent.parent.name}/{p.stem}")
def test_a_scenario_passes(file: Path) -> None:
    played = project(file.parent.parent.name)
    lines = scenario.load(file, [a.name for a in played.applications.values()])
    verdict = simulate(played, lines)
    assert [str(f) for f in verdict.failures] == []
    assert verdict.fulfilled > 0


def test_there_are_scenarios_for_each_example() -> None:
    assert {p.parent.parent.name for p in SCENARIOS} == set(NAMES)


def test_the_reception_has_the_states_of_the_figure_in_reading_order() -> None:
    states, (register,) = application("reception").states, project("reception").parts.values()
    assert [s.no for s in states] == [str(n) for n in range(1, 17)]
    assert states[-1].flow == "register.rbd.xml"
    assert [s.name for s in (*states[:-1], *register.states) if not s.final] == [
        *("start", "intro", "enter initial 1", "enter initial 2", "verify initials"),
        *("show names", "search names", "names", "save profile", "greeting", "main menu"),
        *("measure", "SPO2", "no user", "learn user", "first name", "last name"),
        *("verify name", "register name", "register error"),
    ]


def arrows() -> set[str]:
    """From, event, to of every state; parts entered at their start, left through their ends."""
    (outer,), parts = project("reception").applications.values(), project("reception").parts
    found: set[str] = set()
    for file in (outer, *parts.values()):
        holder = next((s for s in outer.states if s.flow and parts[s.flow] == file), None)
        for state in file.states:
            for event in state.events:
                after = file.state(event.next or "")
                if after is not None and after.final and holder is not None:
                    ends = {e.name: e.next for e in holder.events}
                    after = outer.state(ends.get(f"done.{after.no}", ends["done"]) or "")
                if after is not None and after.flow is not None:
                    after = parts[after.flow].state(parts[after.flow].start_no or "")
                found.add(f"{state.name} {event.name} {after.name if after else None}")
    return found


@pytest.mark.parametrize("arrow", ARROWS.strip().split("\n"))
def test_the_reception_has_every_arrow_of_the_figure(arrow: str) -> None:
    assert arrow in arrows()


def test_nobody_is_left_alone_with_a_state() -> None:
    """Every state but the first can be waited out, and shows the way home, parts included."""
    first, *others = application("reception").states
    assert not first.always
    (register,) = project("reception").parts.values()
    for state in (*others, *register.states):
        assert state.always
        if state.flow is None and not state.final:
            assert state.timeout is not None
            assert state.timeout.next is not None


def test_a_part_of_an_example_is_rehearsed_by_itself() -> None:
    part, problems = folder.load(EXAMPLES / "reception" / "register.rbd.xml")
    assert problems == []
    assert part is not None
    assert [str(p) for p in check(part)] == []
    verdict = simulate(part, scenario.load(EXAMPLES / "reception" / "register.jsonl", ["register"]))
    assert [str(f) for f in verdict.failures] == []
    assert verdict.fulfilled > 0


def test_the_flat_reception_does_the_same() -> None:
    flat = flatten(project("reception"))
    assert [str(p) for p in check(flat)] == []
    whole = project("reception")
    for file in sorted((EXAMPLES / "reception" / "scenarios").iterdir()):
        assert done(flat, file) == done(whole, file)


def done(played: Project, file: Path) -> list[tuple[object, ...]]:
    """When which action began or ended, but for what the flat form adds."""
    written = scenario.load(file, ["reception"])
    lines = [line for line in written if not isinstance(line.does, Expect)]
    found: list[tuple[object, ...]] = []

    def tell(events: list[TraceEvent]) -> None:
        for event in events:
            fields = to_fields(event)
            if fields["kind"] in ("action", "finished", "cancelled"):
                found.append(tuple(fields.get(k) for k in ("t", "kind", "action", "name", "text")))

    simulate(played, lines, tell=tell)
    return [one for one in found if one[2] != "clear"]


def test_targets_and_texts_are_large_enough_for_old_hands_and_eyes() -> None:
    """A 10-inch screen is 215 by 135 mm: 12 mm are 5.6 % of the width, 8.9 % of the height."""
    for name in NAMES:
        owners: list[State | Always] = [s for app in files(name) for s in app.states]
        owners += [app.always for app in files(name) if app.always is not None]
        screens = [owner.screen for owner in owners if owner.screen is not None]
        for component in (c for screen in screens for c in screen.components):
            assert component.x + component.width <= 100
            assert component.y + component.height <= 100
            if isinstance(component, Text | Button | List):
                assert component.size is not None
                assert component.size >= 6
            if isinstance(component, Button):
                assert component.width >= 5.6
                assert component.height >= 8.9


@pytest.mark.parametrize("name", NAMES)
def test_every_text_is_translated(name: str) -> None:
    texts: set[str] = set()
    for owner in (one for app in files(name) for one in (app.always, *app.states)):
        if owner is None:
            continue
        for component in owner.screen.components if owner.screen else ():
            if isinstance(component, Text | Button):
                texts.add(component.text)
            elif isinstance(component, List):
                texts.add(component.label)
        for action in getattr(owner, "actions", ()):
            if isinstance(action, Speech):
                texts.add(action.text)
        texts |= {say.text for event in owner.events for say in event.says}
    project, _ = folder.load(EXAMPLES / name)
    assert project is not None
    texts |= {one.text for one in setting_texts(project.settings)}
    every = polib.pofile(str(EXAMPLES / name / "texts" / "ja.po"))
    # How the voice says a word is no text.
    entries = [e for e in every if e.msgctxt != "reading"]
    assert {text for text in texts if has_words(text)} <= {e.msgid for e in entries} <= texts
    assert [e.msgid for e in entries if not e.msgstr or e.fuzzy] == []


def test_a_translation_keeps_every_reference() -> None:
    for name in NAMES:
        for entry in polib.pofile(str(EXAMPLES / name / "texts" / "ja.po")):
            assert sorted(_references(entry.msgid)) == sorted(_references(entry.msgstr))


def _references(text: str) -> list[str]:
    return [part.split("}")[0] for part in text.split("{")[1:]]


def test_all_media_are_used_and_all_that_is_used_is_there() -> None:
    used: set[str] = set()
    for state in (state for app in files("reception") for state in app.states):
        if state.screen is not None:
            used |= {state.screen.background} if state.screen.background else set()
            used |= {c.src for c in state.screen.components if isinstance(c, Image | Movie)}
        used |= {a.src for a in state.actions if isinstance(a, Sound)}
    assert used == {p.name for p in (EXAMPLES / "reception" / "media").iterdir()}
