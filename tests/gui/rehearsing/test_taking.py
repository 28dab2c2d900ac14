"""An edit is taken into a rehearsal that runs, by the rules of a deploy."""

from __future__ import annotations

from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from situ.decide.step import SECOND
from situ.document.diff import Change, compare
from situ.document.project import Project
from situ.document.rbd import Event
from situ.rehearse.scenario import load
from situ_studio.rehearsing import taking_notice
from situ_studio.rehearsing.saving import SavingScenario

FILE = "converse.rbd.xml"
SPEECH = SECOND * 5
"""Longer than what is said first."""


def edit(used: Any, number: int, **changes: Any) -> None:
    """One of the states becomes another, as one step."""
    session = used.studio.session
    document = session.document(FILE)
    states = list(document.states)
    states[number] = replace(states[number], **changes)
    session.commit(FILE, replace(document, states=tuple(states)), "edit")
    used.studio.settle()


def reword(used: Any, number: int, text: str) -> None:
    """One of the states says something else."""
    state = used.studio.session.document(FILE).states[number]
    edit(used, number, actions=(replace(state.actions[0], text=text),))


def rename(used: Any, number: int, name: str) -> None:
    """The same by hands."""
    used.studio.select("state", str(number))
    used.studio.key(Qt.Key.Key_F2)
    used.studio.type(name)
    used.studio.key(Qt.Key.Key_Return)


def test_an_edit_is_taken_in_when_no_action_runs_and_gone_back_from(desk: Any) -> None:
    used = desk("conversation")
    notice, says = used.desk.notice, used.desk.says
    assert not notice.isVisible()
    reword(used, 1, "How was your night?")
    assert notice.words.text().splitlines() == [
        "The project has changed since.",
        "– state sleep, speech: “Did you sleep well?” → “How was your night?”",
    ]
    used.studio.click(notice.take)
    assert "speech in state 1 of converse" in notice.words.text()
    assert not notice.take.isVisible()
    # What is said is said to its end, and the robot is where it was.
    used.go_on(5)
    assert notice.words.text() == "It goes on with your changes."
    assert used.state == "1"
    assert used.side.running.course.now == SPEECH
    used.touch("YES")
    assert says.words.text() == "“How was your night?”"

    # Undone in the drawing, it is offered as any other edit; gone back from, it is as before.
    used.studio.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert notice.words.text().startswith("The project has changed since.")
    assert notice.take.isVisible()
    used.studio.click(notice.back)
    assert not notice.isVisible()
    assert used.state == "2"
    used.touch("Repeat")
    assert says.words.text() == "“Did you sleep well?”"


def test_what_has_changed_is_found_once_not_again_with_every_event(
    desk: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    used = desk("conversation")
    compared: list[Project] = []

    def counting(before: Project, after: Project) -> list[Change]:
        compared.append(after)
        return compare(before, after)

    monkeypatch.setattr(taking_notice, "compare", counting)
    reword(used, 1, "How was your night?")
    used.touch("YES")
    used.go_on(5)
    assert compared == [used.studio.session.project]
    # Another edit is another change, and so is what runs.
    before = used.studio.session.document(FILE).states[0].actions[0].text
    reword(used, 0, "Good morning.")
    assert len(used.desk.notice.words.text().splitlines()) == 3
    used.studio.click(used.desk.notice.take)
    used.studio.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert used.desk.notice.words.text().splitlines()[1:] == [
        f"– state hello, speech: “Good morning.” → “{before}”"
    ]


def test_what_waits_is_run_at_once_where_somebody_wants_it(desk: Any) -> None:
    used = desk("conversation")
    notice = used.desk.notice
    reword(used, 0, "Good morning.")
    used.studio.click(notice.take)
    used.studio.click(notice.hurry)
    assert notice.words.text() == "It goes on with your changes."
    # That is the words' end: the state has them no longer.
    assert used.desk.says.words.text() == "The robot says nothing"
    used.touch("Repeat")
    assert used.desk.says.words.text() == "“Good morning.”"


def test_what_goes_wrong_is_gone_back_from_with_why(desk: Any) -> None:
    used = desk("conversation")
    used.go_on(5)
    states = used.window.current_document.states
    for number, to in ((1, "3"), (2, "2")):
        edit(used, number, events=(Event(None, to), *states[number].events))
    used.studio.click(used.desk.notice.take)
    used.touch("YES")
    assert "it went wrong, and what ran before runs again" in used.desk.notice.words.text()
    assert "again: livelock: more than 100 events" in used.desk.notice.words.text()
    assert not used.desk.notice.back.isVisible()
    assert used.side.running.course.project is not used.studio.session.project


def test_keys_take_in_and_what_can_not_run_is_not_taken(desk: Any) -> None:
    used = desk("conversation")
    used.go_on(5)
    take = used.window.actions_.actions["rehearse.take"]
    back = used.window.actions_.actions["rehearse.back"]
    assert not take.isEnabled()
    # A card that was moved changes nothing that runs.
    aside = used.window.current_document.states[1].aside
    edit(used, 1, aside=replace(aside, attributes=()))
    assert used.side.running.course.project is not used.studio.session.project
    assert not used.desk.notice.isVisible()
    assert not take.isEnabled()
    held = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
    rename(used, 1, "hi")
    assert take.isEnabled()
    used.studio.key(Qt.Key.Key_F5, held)
    assert used.side.running.course.project is used.studio.session.project
    assert not take.isEnabled()
    assert back.isEnabled()
    states = used.window.current_document.states
    edit(used, 0, events=(replace(states[0].events[0], next="77"), *states[0].events[1:]))
    running = used.side.running.course.project
    used.studio.key(Qt.Key.Key_F5, held)
    assert used.side.running.course.project is running
    assert used.window.bottom.current == "problems"
    used.studio.key(Qt.Key.Key_F5, Qt.KeyboardModifier.ShiftModifier)
    assert not take.isEnabled()
    assert not back.isEnabled()


def test_data_of_the_changes_are_turned_and_a_scenario_says_that_changes_came_on_the_way(
    desk: Any,
) -> None:
    used = desk("conversation")
    used.go_on(5)
    session = used.studio.session
    file = session.project.spds_file
    script = session.document(file)
    observed = replace(script.observe[0], tag="weather.tomorrow")
    session.commit(file, replace(script, observe=(*script.observe, observed)), "observe")
    assert "weather.tomorrow" not in used.desk.dials
    used.studio.click(used.desk.notice.take)
    assert used.desk.dials["weather.tomorrow"].isVisible()
    used.touch("YES")
    used.studio.click(used.desk.clock.save)
    (saving,) = used.window.findChildren(SavingScenario)
    assert saving.on_the_way.isVisible()
    QTest.keyClicks(saving.name, "on the way")
    used.studio.click(saving.keep)
    kept = session.root / "scenarios" / "on the way.jsonl"
    done = [type(line.does).__name__ for line in load(kept)]
    assert "Use" in done
    assert "Deploy" not in done
