"""Why? asks the documents that ran, whatever is open here."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt
from tests.gui.live.test_link import connect
from tests.gui.live.test_recordings import opened, recording, until_shown
from tests.gui.live.test_why import FLOW, Clicks, seen
from tests.rehearse.recorded_robot import Recorded, recorder

from situ.blackboard.client import connect as operator
from situ.decide import inputs
from situ.document import codec
from situ.document.condition import Condition
from situ.document.condition import Test as DataTest
from situ.document.export import deployable, without_editor
from situ.document.folder import sources
from situ.document.rbd import Application, Event, Set
from situ.document.ready import load_ready
from situ.resources import examples
from situ_studio.edits import places, project_documents
from situ_studio.edits.edit import Document, Place
from situ_studio.live.counterpart import counterpart

SHIFT = Qt.KeyboardModifier.ShiftModifier
EXAMPLES = sorted(examples())


def every_place(value: Any) -> list[Place]:
    found: list[Place] = []
    for way, member in places.members(value):
        found += [way, *((*way, *below) for below in every_place(member))]
    return found


# -- the same place in another version ------------------------------------------------------


@pytest.mark.parametrize("name", EXAMPLES)
def test_in_the_same_document_every_place_is_itself(name: str) -> None:
    project = load_ready(Path(examples()[name]))
    for file in project_documents.files(project):
        document: Any = project_documents.document(project, file)
        every = every_place(document)
        assert every
        for place in every:
            met = counterpart(document, place, document)
            # Of several that are the very same, whichever.
            assert met is not None
            assert places.get(document, met) == places.get(document, place)


def application(*events: Event) -> Application:
    flow = load_ready(Path(examples()["conversation"])).applications[FLOW]
    first = replace(flow.states[0], events=events)
    return replace(flow, states=(first, *flow.states[1:]))


OPEN = Condition((DataTest("open", "is", "true"),))
FIRST = ("state", "1", "event")


@pytest.mark.parametrize(
    ("mine", "theirs", "place", "met"),
    [
        # What stands before it counts it no further.
        ((Event("a", "2"),), (Event("b", "3"), Event("a", "2")), "0", "1"),
        # The very same goes before one that is only like it.
        (
            (Event("a", "2"), Event("a", "3")),
            (Event("a", "3"), Event("a", "2")),
            "1",
            "0",
        ),
        # With another guard it is still the event of that name.
        ((Event("a", "2"),), (Event("a", "2", when=OPEN),), "0", "0"),
        ((Event("a", "2"), Event("a", "3")), (Event("a", "2"),), "1", None),
        ((Event("a", "2"),), (Event("b", "2"),), "0", None),
        ((Event("a", "2"),), (), "0", None),
    ],
)
def test_what_has_no_name_is_the_very_same_or_the_like(
    mine: tuple[Event, ...], theirs: tuple[Event, ...], place: str, met: str | None
) -> None:
    found = counterpart(application(*mine), (*FIRST, place), application(*theirs))
    assert found == (None if met is None else (*FIRST, met))


def test_an_action_is_found_inside_of_an_event_that_stands_elsewhere() -> None:
    mine = application(Event("a", "2", actions=(Set(tag="x", text="1"),)))
    theirs = application(Event("b", "2"), Event("a", "2", actions=(Set(tag="x", text="2"),)))
    assert counterpart(mine, (*FIRST, "0", "action", "0"), theirs) == (*FIRST, "1", "action", "0")


def test_what_is_named_goes_by_its_name_and_is_lacking_where_that_is() -> None:
    script: Any = load_ready(Path(examples()["conversation"])).spds
    other = replace(
        script,
        situations=script.situations[1:],
        modules=tuple(one for one in script.modules if one.name != "nod"),
    )
    gone, kept = script.situations[0].name, script.situations[1].name
    wanted: list[tuple[Place, Place | None]] = [
        (("situation", gone), None),
        (("situation", kept, "condition"), ("situation", kept, "condition")),
        (("module", "nod", "resource", "head"), None),
        # No member of the script: a resource, or a tag that is not observed.
        (("resource", "head"), ("resource", "head")),
        (("data", "never.observed"), ("data", "never.observed")),
        ((), ()),
    ]
    for place, met in wanted:
        assert counterpart(script, place, other) == met
    # A priority by its module's name, which a cell of the matrix has.
    entry = ("situation", kept, "module", script.situations[1].entries[0].module)
    assert counterpart(script, entry, other) == entry
    bare = replace(script, situations=tuple(replace(s, entries=()) for s in script.situations))
    assert counterpart(script, entry, bare) is None


# -- in the window --------------------------------------------------------------------------


def changed(flow: Application) -> Application:
    """A way more, to a state that only this has; and *yes* counts while it is open."""
    first = flow.states[0]
    yes = next(n for n, event in enumerate(first.events) if event.name == "clickYes")
    guarded = replace(first.events[yes], when=OPEN)
    events = (Event("leave", "secret"), *first.events[:yes], guarded, *first.events[yes + 1 :])
    secret = replace(flow.states[-1], no="secret", name="hidden")
    return replace(
        flow, states=(replace(first, events=events, name="theirs"), *flow.states[1:], secret)
    )


@pytest.fixture
def two(project: Callable[[str], Path], tmp_path: Path) -> tuple[Path, Path]:
    """The project that is open, and another version of it."""
    mine, theirs = project("conversation"), tmp_path / "theirs"
    loaded = load_ready(mine)
    for file, data in deployable(loaded).items():
        (theirs / file).parent.mkdir(parents=True, exist_ok=True)
        (theirs / file).write_bytes(data)
    flow: Document = without_editor(changed(loaded.applications[FLOW]))
    (theirs / FLOW).write_bytes(codec.write(flow))
    return mine, theirs


def test_a_robot_that_runs_a_changed_flow_explains_by_its_own_guard(
    studio: Callable[..., Any], two: tuple[Path, Path], robot: Any, until: Any
) -> None:
    mine, theirs = two
    there = robot(theirs)
    it = studio(mine)
    window = it.window
    link = connect(it, there.endpoint, until)
    until(link.documents_came, lambda: link.files is not None)
    panel = window.why.panel
    with operator(there.endpoint, role="operator") as board:
        board.publish("clickYes")
        until(link.moment_changed, lambda: any(e["kind"] == "ignored" for e in link.log))
        window.open_file(FLOW)
        it.select("state", "1", "event", "0")
        window.views[FLOW].current_view().setFocus()
        it.key(Qt.Key.Key_F7, SHIFT)
        assert "but its guard did not hold: open is true" in seen(it)[0]
        assert "1 theirs" in panel.title.text()
        assert panel.more.text().endswith("; by the documents that ran, not those open here")
        # Where it goes now there is nothing here: that is said.
        board.publish("leave")
        until(link.moment_changed, lambda: link.log.now.applications["converse"].state == "secret")
        window.robot.follower.refresh()
        enter = next(e for e in link.log if e["kind"] == "enter" and e["state"] == "secret")
        window.bottom.choose("trace")
        it.settle()
        hand = Clicks(it)
        hand.row_menu(window.robot.trace, str(enter["seq"]))
        hand.choose(window.why.menus.shown, "Why?")
        assert seen(it)[-1] == "converse enters secret hidden"
        for row, near in ((-1, ()), (-2, (("state", "1"),))):
            window.say("")
            it.click_row(panel.table, panel.table.rows.index(len(panel.links) + row, 1))
            assert window.status.said.text() == f"Only what ran has that: {FLOW} here has not."
            assert window.current_view.selected == near
        window.robot.follower.viewing.follow()
        # Once it runs what is open here, that is what is asked, and of then still what ran then.
        before = link.log.now.t
        board.deploy(deployable(load_ready(mine)), "situ.toml", force_after=0)
        until(link.documents_came, lambda: 'name="theirs"' not in link.files[FLOW])
        until(link.moment_changed, lambda: link.log.lanes.deployed)
    names = [
        window.why.project_at(t).applications[FLOW].states[0].name
        for t in (before, window.robot.follower.viewing.t)
    ]
    assert names == ["theirs", "hello"]
    window.robot.disconnect_robot()


def test_a_recording_is_asked_by_the_documents_in_it_and_the_open_ones_only_where_it_has_none(
    studio: Callable[..., Any], two: tuple[Path, Path], tmp_path: Path
) -> None:
    mine, theirs = two
    it, events = opened(studio, theirs, tmp_path / "run.mcap", "conversation", "fig5.jsonl")
    window = it.window
    enter = next(e for e in events if e["kind"] == "enter" and e["state"] == "1")
    it.session.open(mine)
    it.settle()
    window.robot.open_recording(tmp_path / "run.mcap")
    until_shown(it)

    def ask() -> None:
        window.robot.follower.viewing.seek(enter["t"])
        window.open_file(FLOW)
        it.select("state", "1")
        window.views[FLOW].current_view().setFocus()
        it.key(Qt.Key.Key_F7)

    ask()
    assert seen(it)[-1].endswith("converse enters 1 theirs (the start)")
    assert "by the documents that ran" in window.why.panel.more.text()
    # What is about a way goes to that one here, though another one stands before it there.
    went = next(e for e in events if e["kind"] == "transition" and e["from"] == "1")
    window.robot.follower.viewing.seek(went["t"])
    it.select("state", "1", "event", "0")
    window.views[FLOW].current_view().setFocus()
    it.key(Qt.Key.Key_F7)
    panel = window.why.panel
    assert panel.links[-1].where == (FLOW, ("state", "1", "event", "1"))
    it.select("state", "2")
    it.click_row(panel.table, panel.table.rows.index(len(panel.links) - 1, 1))
    assert window.current_view.selected == (("state", "1", "event", "0"),)
    # What only an operator may see all of is written without documents.
    bare = recording(tmp_path / "bare.mcap", events, None)
    window.robot.open_recording(bare)
    until_shown(it)
    ask()
    assert seen(it)[-1].endswith("converse enters 1 hello (the start)")
    said = "; by the documents open here: those that ran are not known"
    assert window.why.panel.more.text().endswith(said)


def test_what_a_recorded_robot_turned_to_is_asked_from_then_on(
    studio: Callable[..., Any], two: tuple[Path, Path], tmp_path: Path
) -> None:
    mine, theirs = two
    file = tmp_path / "run.mcap"
    run = Recorded(mine, recorder(file, mine))
    run.at(2_000_000, inputs.Deploy(1, sources(load_ready(theirs)), "operator:ann", 0.0))
    run.at(4_000_000, inputs.Set({"open": True}, "operator:ann"))
    run.recorder.close()
    it = studio(mine)
    it.window.robot.open_recording(file)
    until_shown(it)
    why = it.window.why
    names = [why.project_at(t).applications[FLOW].states[0].name for t in (1.0, 2.0, 3.0)]
    assert names == ["hello", "theirs", "theirs"]
