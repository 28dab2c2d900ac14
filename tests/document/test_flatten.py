"""``situ export --flat``: the flat form and the original give the same actions at the same times.

formats.md, *Parts*: laws over generated applications with parts, and the cases by themselves.
"""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, reject, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from situ import cli
from situ.decide.trace import to_fields
from situ.document import codec
from situ.document.check import check
from situ.document.flatten import NOTHING_TAG, flatten
from situ.document.folder import load
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ.errors import UsageError
from situ.rehearse import scenario
from situ.rehearse.simulate import simulate
from situ.resources import example

AT = 'x="1" y="1" width="9" height="9"'
SCRIPT = """<spds name="s">
  <observe><data tag="busy"/></observe>
  <modules><module name="app" resources="screen speech base"/></modules>
  <situation name="busy"><condition><data tag="busy" is="true"/></condition></situation>
  <situation name="calm"><module name="app" priority="1"/></situation></spds>"""


class Livelock(Exception):
    """The application goes round without an end; how far it gets is no matter here."""


def read(text: str) -> Application:
    document, problems = codec.read(text.encode(), "a.rbd.xml")
    assert not problems, problems
    assert isinstance(document, Application)
    return document


def project(app: str, script: bool = False, **parts: str) -> Project:
    spds, _ = codec.read(SCRIPT.encode(), "s.spds.xml")
    assert isinstance(spds, Spds)
    made = Project(
        root=".",
        name="test",
        applications={"app.rbd.xml": read(f'<application name="app">{app}</application>')},
        parts={
            f"{name}.rbd.xml": read(f'<application name="{name}">{text}</application>')
            for name, text in parts.items()
        },
        spds=spds if script else None,
        spds_file="s.spds.xml" if script else None,
    )
    assert [str(one) for one in check(made) if one.severity == "error"] == []
    return made


def told(made: Project, lines: list[dict[str, Any]]) -> list[Any]:
    """Times and actions, what the resources are asked for, and what they carry out."""
    found: list[Any] = []

    def tell(events: list[Any]) -> None:
        for event in events:
            fields = to_fields(event)
            kind = fields["kind"]
            if kind == "error":
                raise Livelock
            hidden = found and found[-1].get("tag") == NOTHING_TAG
            if hidden:
                found.pop()
                assert kind == "finished"
            elif kind in ("action", "finished", "cancelled", "mapping", "acquire", "abandon"):
                drop = ("seq", "cause", "state")
                found.append({key: v for key, v in fields.items() if key not in drop})

    text = "\n".join(map(repr, lines)).replace("'", '"').replace("True", "true")
    simulate(made, scenario.parse(text.replace("False", "false").encode(), "s", ["app"]), tell=tell)
    return found


def same(made: Project, lines: list[dict[str, Any]]) -> Application:
    """The flat application, having done the same."""
    flat = flatten(made)
    assert [str(one) for one in check(flat) if one.severity == "error"] == []
    assert flat.parts == {}
    (application,) = flat.applications.values()
    assert application.always is None
    assert all(state.flow is None for state in application.states)
    # What is exported is what is read again.
    assert codec.read(codec.write(application), "a")[0] == application
    assert told(flat, lines) == told(made, lines)
    return application


# -- generated applications ------------------------------------------------------

NAMES = ("a", "b", "c", "done", "done.1", "done.2", "resumed", "timeout")
TAGS = ("t", "u")
ENDING = ("speech", "robot", "service", "movie", "launch")


class Maker:
    """One project and its scenario, drawn from ``rng``."""

    def __init__(self, rng: random.Random) -> None:
        self.rng = rng
        self.ids = 0
        self.in_part = False
        self.back = rng.random() < 0.4

    def maybe(self, chance: float, text: str) -> str:
        return text if self.rng.random() < chance else ""

    def next(self, count: int) -> str:
        special = ["#again", *(["#back"] * 2 if self.back else [])]
        choice = self.rng.choice([*map(str, range(1, count + 1)), *special])
        return f' next="{choice}"'

    def when(self) -> str:
        tag, value = self.rng.choice(TAGS), self.rng.randrange(3)
        extra = self.maybe(0.2, f' within="{self.rng.choice((1, 2.5))}"')
        extra = extra or self.maybe(0.2, ' for="1.5"')
        return f'<when><data tag="{tag}" is="{value}"{extra}/></when>'

    def quick(self) -> str:
        done = self.maybe(0.3, f' done="{self.rng.choice("abc")}"')
        tag = self.rng.choice(TAGS)
        return self.rng.choice(
            (
                f'<set tag="{tag}"{done}>{self.rng.randrange(3)}</set>',
                f'<add tag="n"{done}>1</add>',
                f'<append tag="many"{done}>{self.rng.randrange(3)}</append>',
                f'<take from="many" tag="{tag}"{done}/>',
                f'<service name="s{self.rng.randrange(3)}" url="http://x/"{done}{self.failed()}/>',
                f'<launch program="g"{done}{self.failed()}/>',
                f'<service name="k" url="http://x/" keep="true"{done}/>',
            )
        )

    def failed(self) -> str:
        return self.maybe(0.3, f' failed="{self.rng.choice("abc")}"')

    def visible(self) -> str:
        done = self.maybe(0.4, f' done="{self.rng.choice("abc")}"') + self.maybe(
            0.3, ' wait="true"'
        )
        more = self.maybe(0.2, ' optional="true"')
        self.ids += 1
        return self.rng.choice(
            (
                f"<speech{done}{more}>say {self.ids}</speech>",
                f'<robot resource="base" command="c{self.ids}"{done}{more}/>',
            )
        )

    def event(self, count: int) -> str:
        if self.rng.random() < 0.15:
            return f"<event{self.next(count)}>{self.when()}</event>"
        inside = self.maybe(0.25, self.when()) + self.maybe(
            0.2, f"<say>{self.rng.choice(('yes', 'no', 'Yes!', '{t}'))}</say>"
        )
        inside += self.maybe(0.3, self.quick())
        if self.rng.random() < 0.75:
            to = self.next(count)
        else:
            to, inside = "", inside + self.maybe(0.3, "<repeat/>")
        names = NAMES[:3] if self.rng.random() < 0.6 else NAMES
        return f'<event name="{self.rng.choice(names)}"{to}>{inside}</event>'

    def ended(self, count: int) -> str:
        """What a state does when its part ends."""
        name = self.rng.choice(("done", "done", "done.1", "done.2", "done.3"))
        return f'<event name="{name}"{self.next(count)}/>'

    def events(self, count: int, most: int, more: str = "") -> str:
        found = more + "".join(self.event(count) for _ in range(self.rng.randrange(most + 1)))
        return f"<expectedevents>{found}</expectedevents>" if found else ""

    def timeout(self, count: int) -> str:
        to = self.next(count) if self.rng.random() < 0.7 else ""
        idle = self.maybe(0.3, ' idle="true"')
        return f"<timeout{to}{idle}>{self.rng.choice((0.5, 1, 1.5, 4))}</timeout>"

    def screen(self) -> str:
        self.ids += 1
        kind = self.rng.random()
        if kind < 0.15:
            return "<screen/>"
        one = (
            f'<button id="i{self.ids}" {AT} event="{self.rng.choice("abc")}">{{t}}</button>'
            if kind < 0.9
            else f'<movie id="i{self.ids}" {AT} src="m.webm" done="{self.rng.choice("abc")}"/>'
        )
        touched = self.maybe(0.3, f' touched="{self.rng.choice("abc")}"')
        return f"<screen{touched}><components>{one}</components></screen>"

    def file(self, parts: tuple[str, ...]) -> str:
        rng = self.rng
        count = rng.choice((2, 2, 3))
        text = ""
        if rng.random() < 0.6:
            text += "<always>" + self.maybe(0.3, self.timeout(count)) + self.maybe(
                0.4, self.screen()
            ) + self.events(count, 2) + "</always>"  # fmt: skip
        for no in range(1, count + 1):
            more = self.maybe(0.15, ' always="false"')
            events = 0 if self.in_part and no == count and rng.random() < 0.7 else 3
            ends = ""
            if parts and rng.random() < 0.45:
                inside = f'<flow src="{rng.choice(parts)}.rbd.xml"/>'
                ends = self.maybe(0.8, self.ended(count))
            else:
                actions = self.maybe(0.5, self.visible()) + self.maybe(0.3, self.quick())
                actions += self.maybe(0.2, self.visible())
                inside = self.maybe(0.3, self.timeout(count)) + self.maybe(0.4, self.screen())
                inside += f"<backgroundactions>{actions}</backgroundactions>" if actions else ""
            more += self.maybe(0.1, ' final="true"')
            text += f'<state no="{no}"{more}>{inside}{self.events(count, events, ends)}</state>'
        return text

    def project(self) -> Project:
        self.in_part = True
        q = self.file(())
        p = self.file(("q",))
        self.in_part = False
        return project(self.file(("p", "q")), self.rng.random() < 0.4, p=p, q=q)

    def lines(self) -> list[dict[str, Any]]:
        rng, found, at = self.rng, [], 0.0
        for _ in range(rng.randrange(5, 25)):
            at += rng.choice((0, 0.25, 0.5, 1, 2))
            verb = rng.choice(
                (
                    {"event": rng.choice(NAMES[:4])},
                    {"event": rng.choice("abc")},
                    {"set": {rng.choice(TAGS): rng.randrange(3)}},
                    {"set": {"busy": rng.random() < 0.4}},
                    {"touch": True},
                    {"finish": {"action": rng.choice(ENDING), "ok": rng.random() < 0.8}},
                    {"set": {"heard": {"text": rng.choice(("yes", "no", "1", "else"))}}},
                )
            )
            found.append({"at": at, **verb})
        return [*found, {"at": at + 5, "end": True}]


@settings(
    max_examples=40,
    deadline=None,
    suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow],
)
@given(st.integers(0, 2**32))
def test_flat_and_original_give_the_same_actions_at_the_same_times(seed: int) -> None:
    maker = Maker(random.Random(seed))
    made, lines = maker.project(), maker.lines()
    try:
        same(made, lines)
    except (Livelock, UsageError):
        # What cannot be written flat is refused: those cases are below.
        reject()


# -- the cases by themselves ---------------------------------------------------------

PARTS = Path(__file__).parents[1] / "examples" / "parts"
GO = '<event name="{0}" next="{1}"/>'


def state(no: str, events: str = "", inside: str = "") -> str:
    return f'<state no="{no}">{inside}<expectedevents>{events}</expectedevents></state>'


def events(*names: str) -> list[dict[str, Any]]:
    return [{"at": at, "event": name} for at, name in enumerate(names, 1)]


def go(**to: str) -> str:
    return "".join(GO.format(name, target.replace("_", "#")) for name, target in to.items())


def says(text: str) -> str:
    return f"<backgroundactions><speech>{text}</speech></backgroundactions>"


def shows(name: str) -> str:
    return (
        f'<screen><components><button id="{name}" {AT} event="x">a</button></components></screen>'
    )


def part(name: str, inside: str = "") -> str:
    return f'<flow src="{name}.rbd.xml"/>{inside}'


def numbers(application: Application) -> list[str]:
    return [one.no for one in application.states]


def test_states_are_named_by_their_paths() -> None:
    made = project(state("5", inside=part("p")), p=state("1", go(a="2")) + state("2"))
    assert numbers(same(made, events("a"))) == ["5/1", "5/2"]


def test_an_application_without_parts_keeps_its_states_and_its_stack() -> None:
    always = "<always><expectedevents>" + go(back="_back", home="1") + "</expectedevents></always>"
    made = project(
        always + state("1", go(a="2"), says("1")) + state("2", go(a="3"), says("2"))
        + state("3", go(a="2"), says("3"))
    )  # fmt: skip
    flat = same(made, events("a", "a", "a", "a", "back", "back", "back", "back", "home", "back"))
    assert numbers(flat) == ["1", "2", "3"]


def test_ways_back_through_parts_are_states_of_their_own() -> None:
    outer = state("1", go(a="5"), says("1")) + state("2", go(a="5"), says("2"))
    outer += (
        '<state no="5">'
        + part("p", f"<expectedevents>{go(out='_back', b='2')}")
        + ("</expectedevents></state>")
    )
    made = project(outer, p=state("1", go(c="2"), says("in")) + state("2", go(back="_back")))
    flat = same(made, events("a", "c", "back", "out", "a", "b", "a", "c", "out", "a"))
    assert numbers(flat) == ["1", "5/1", "5/2", "2", "5/1~2", "5/2~2"]


def test_a_screen_kept_under_another_always_is_shown_by_copies() -> None:
    always = f"<always>{shows('above')}</always>"
    made = project(
        state("1", go(a="5"), shows("one")) + state("2", go(a="5"), shows("two"))
        + '<state no="5">' + part("p", f"<expectedevents>{go(b='2')}</expectedevents>")
        + "</state>",
        p=always + state("1"),
    )  # fmt: skip
    flat = same(made, events("a", "b", "a"))
    shown = {
        one.no: [c.id for c in one.screen.components] for one in flat.states if one.screen
    }  # fmt: skip
    assert shown["5/1"] == ["one", "above"]
    assert shown["5/1~2"] == ["two", "above"]


def listed(application: Application, no: str) -> dict[str | None, list[str]]:
    """The events of a state with what is said for them."""
    found = application.state(no)
    assert found is not None
    return {event.name: [say.text for say in event.says] for event in found.events}


def test_what_an_earlier_event_always_takes_is_left_out_but_for_its_phrases() -> None:
    always = '<always><expectedevents><event name="home" next="1"><say>home</say></event>'
    own = '<event name="home" next="2"/><event name="a" next="2"><say>yes</say></event>'
    made = project(
        f"{always}</expectedevents></always>" + state("1", own, says("1")) + state("2")
    )  # fmt: skip
    flat = same(made, [{"at": 1, "set": {"heard": {"text": "home"}}}, {"at": 3, "end": True}])
    assert listed(flat, "1") == {"home": ["home"], "a": ["yes"]}
    assert listed(flat, "2") == {"home": ["home"]}
    assert len(flat.states[0].events) == 2


@pytest.mark.parametrize("phrase", ["Yes!", "{name}", "hai"])
def test_phrases_that_another_event_between_may_take_stay_where_they_are(phrase: str) -> None:
    always = f'<always><expectedevents><event name="home" next="1"><say>{phrase}</say></event>'
    own = '<event name="home" next="1"/><event name="a" next="2"><say>yes</say></event>'
    made = project(
        f"{always}</expectedevents></always>" + state("1", own, says("1")) + state("2")
    )  # fmt: skip
    made = replace(made, languages=("en", "ja"), texts={"ja": {"yes": "Hai"}})
    flat = same(made, [{"at": 1, "set": {"heard": {"text": "yes"}}}, {"at": 3, "end": True}])
    assert [event.name for event in flat.states[0].events] == ["home", "a", "home"]


def test_the_end_of_a_part_is_expected_only_where_it_may_be_told() -> None:
    outer = '<state no="5">' + part("p", "<expectedevents>" + GO.format("done", "6"))
    outer += "</expectedevents></state>" + state("6")
    ends = state("2", "", '<timeout next="1">5</timeout>') + state("3") + state("4")
    made = project(outer, p=state("1", go(a="2", b="3", c="4"), says("1")) + ends)
    flat = same(made, events("b"))
    assert [no for no in numbers(flat) if any("flat-" in str(n) for n in listed(flat, no))] == [
        *("5/3", "5/4")
    ]


def test_the_end_of_a_part_that_goes_on_is_expected_there_too() -> None:
    always = "<always><expectedevents>" + go(back="_back", again="_again", b="1")
    outer = '<state no="5">' + part("p", "<expectedevents>" + GO.format("done", "6"))
    outer += "</expectedevents></state>" + state("6")
    end = '<state no="2"><backgroundactions><set tag="t" done="b">1</set></backgroundactions>'
    made = project(
        outer, p=f"{always}</expectedevents></always>" + state("1", go(a="2")) + f"{end}</state>"
    )
    flat = same(made, events("a"))
    assert "flat-export.done.5/2" in listed(flat, "5/1")


@pytest.mark.parametrize("place", ["parts", "reception"])
def test_a_flat_form_has_no_warning_that_the_original_has_not(place: str) -> None:
    made, _ = load(PARTS if place == "parts" else example(place))
    assert made is not None
    assert {one.code for one in check(flatten(made))} <= {one.code for one in check(made)}


def test_an_end_of_a_part_that_nobody_expects_is_meant_as_in_its_file() -> None:
    flat = same(project(state("5", inside=part("p")), p=state("1", go(a="2")) + state("2")), [])
    assert [one.final for one in flat.states] == [False, True]


def test_an_event_from_outside_that_is_called_done_is_no_end() -> None:
    outer = (
        '<state no="5">'
        + part("p", f"<expectedevents>{GO.format('done.2', '6')}")
        + ("</expectedevents></state>" + state("6"))
    )
    inner = state("1", go(a="2") + GO.format("done.2", "3"), says("1")) + state("2") + state("3")
    made = project(outer, p=inner)
    same(made, events("done.2", "x"))
    same(made, events("a"))


def test_the_same_component_of_two_files_gets_another_name_below() -> None:
    made = project(
        f"<always>{shows('home')}</always>" + state("5", inside=part("p")),
        p=state("1", "", shows("home")),
    )
    (application,) = flatten(made).applications.values()
    screen = application.states[0].screen
    assert screen is not None
    assert [one.id for one in screen.components] == ["home~2", "home"]


def test_ways_back_of_any_length_through_parts_are_refused() -> None:
    always = "<always><expectedevents>" + go(back="_back") + "</expectedevents></always>"
    inner = state("1", go(a="2")) + state("2", go(a="3")) + state("3", go(a="2"))
    with pytest.raises(UsageError, match=r"app\.rbd\.xml: cannot be exported flat: .* #back"):
        flatten(project(state("5", inside=part("p")), p=always + inner))


def test_a_name_that_would_be_several_is_refused() -> None:
    when = '<when><data tag="application/app.state" is="5/1"/></when>'
    outer = state("1", go(a="5"), shows("one")) + state("2", go(a="5"), shows("two"))
    outer += '<state no="5">' + part("p", f"<expectedevents>{go(b='2')}</expectedevents>")
    outer += "</state>"
    inner = f"<always>{shows('above')}</always>" + state("1", f'<event name="x">{when}</event>')
    with pytest.raises(UsageError, match="several names"):
        flatten(project(outer, p=inner))


def test_a_resumed_that_leaves_a_screen_not_yet_shown_is_refused() -> None:
    always = f"<always>{shows('home')}</always>"
    outer = always + state("1", go(resumed="5"), shows("one")) + state("5", "", part("p"))
    with pytest.raises(UsageError, match="resumed leaves state 1 before its screen"):
        flatten(project(outer, script=True, p=state("1")))


def test_a_resumed_that_leaves_a_screen_without_always_above_it_is_written() -> None:
    made = project(
        state("1", go(resumed="5"), shows("one")) + state("5", "", part("p")),
        script=True,
        p=state("1"),
    )
    busy = [{"at": at, "set": {"busy": at == 1}} for at in (1, 2)]
    assert numbers(same(made, [*busy, {"at": 3, "end": True}])) == ["1", "5/1"]


def movie(name: str) -> str:
    return f'<screen><components><movie id="{name}" {AT} src="m.webm"/></components></screen>'


MOVIES = {
    "would begin again with the start state": {
        "app": f"<always>{movie('m')}</always>"
        + state("1", go(a="5"))
        + state("5", go(b="1"), part("p")).replace('no="5"', 'no="5" always="false"'),
        "p": state("1"),
    },
    "is kept in state 5/1, where another": {
        "app": state("1", go(a="5"), movie("m")) + state("5", "", part("p")),
        "p": f"<always>{shows('above')}</always>" + state("1"),
    },
    "two components of state 5/1 are m": {
        "app": f"<always>{shows('m')}</always>" + state("5", "", part("p")),
        "p": state("1", "", movie("m")),
    },
}


@pytest.mark.parametrize("why", MOVIES)
def test_a_movie_that_would_begin_again_or_be_called_otherwise_is_refused(why: str) -> None:
    files = MOVIES[why]
    with pytest.raises(UsageError, match=why):
        flatten(project(files["app"], p=files["p"]))


def test_the_example_is_exported_whole_and_flat(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["export", str(PARTS), "-o", str(tmp_path / "whole")]) == 0
    assert {one.name for one in (tmp_path / "whole").iterdir()} == {
        "situ.toml", "visit.rbd.xml", "register.rbd.xml", "confirm.rbd.xml",
    }  # fmt: skip
    assert cli.main(["export", "--flat", str(PARTS), "-o", str(tmp_path / "flat")]) == 0
    assert {one.name for one in (tmp_path / "flat").iterdir()} == {"situ.toml", "visit.rbd.xml"}
    assert capsys.readouterr() == ("", "")
    flat, problems = load(tmp_path / "flat")
    original, _ = load(PARTS)
    assert [one for one in problems if one.severity == "error"] == []
    assert flat is not None
    assert original is not None
    lines: list[dict[str, Any]] = [
        {"at": 1, "event": "clickStart"},
        {"at": 2, "use": {"component": "field", "value": "Ann"}},
        {"at": 3, "event": "clickNo"},
        {"at": 4, "use": {"component": "field", "value": "Anna"}},
        {"at": 5, "event": "clickYes"},
        {"at": 60, "event": "clickStart"},
        {"at": 100, "end": True},
    ]
    assert told(flat, lines) == told(original, lines)


def test_the_scenario_of_the_example_passes() -> None:
    script = str(PARTS / "scenarios" / "visit.jsonl")
    assert cli.main(["simulate", str(PARTS), "--script", script]) == 0
