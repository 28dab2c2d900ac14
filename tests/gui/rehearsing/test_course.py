"""A rehearsal's course: the robot in virtual time, and what was done to it."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from situ.decide import inputs
from situ.decide.step import SECOND
from situ.decide.trace import to_fields
from situ.document import folder
from situ.document.folder import sources
from situ.document.project import Project
from situ.document.ready import load_ready
from situ.rehearse.scenario import parse
from situ.rehearse.simulate import Rehearsal, simulate
from situ.resources import examples
from situ_studio.rehearsing.course import Course, Version
from situ_studio.rehearsing.dials import dials
from situ_studio.rehearsing.expecting import chances, written


def ready(name: str) -> Project:
    return load_ready(Path(examples()[name]))


def again(
    course: Course, project: Project, files: dict[str, str] | None = None
) -> list[dict[str, Any]]:
    """What the simulator makes of what was done."""
    events: list[dict[str, Any]] = []
    run = Rehearsal(project, lambda came: events.extend(map(to_fields, came)), files=files)
    for one in course.done:
        run.give(one.does, one.at)
    run.advance(course.now)
    return events


def test_a_speech_ends_by_itself_and_that_counts_as_done() -> None:
    course = Course(ready("conversation"))
    assert [one.action for one in course.pending] == ["speech"]
    course.advance(20 * SECOND)
    assert course.pending == []
    assert [type(one.does) for one in course.done] == [inputs.Finish]
    assert 0 < course.done[0].at < 10 * SECOND


def test_a_service_waits_for_somebody_to_say_how_it_went() -> None:
    course = Course(ready("reception"))
    course.give(inputs.Touch())
    for event in ("Continue", "Confirm", "Confirm", "Confirm", "Yes"):
        course.give(inputs.Raise(f"click{event}"))
    pending = [one for one in course.pending if one.action == "service"]
    assert [one.name for one in pending] == ["findPatientsByInitials"]
    course.advance(course.now + SECOND)
    assert pending[0] in course.pending
    course.give(pending[0].finish(ok=False))
    assert pending[0] not in course.pending


_DEEDS = st.one_of(
    st.builds(inputs.Touch),
    st.sampled_from(["yes", "no", "repeat"]).map(inputs.Use),
    st.sampled_from(["head", "speech", "base"]).map(
        lambda resource: inputs.Acquire("transfer", (resource,))
    ),
    st.sampled_from(["transfer", "nod"]).map(inputs.Lost),
    st.booleans().map(lambda on: inputs.Set({"hand.waving": on}, "scenario")),
    st.just(inputs.Set({"heard": {"text": "yes", "confidence": 1}}, "scenario")),
)


@settings(max_examples=15, deadline=None)
@given(st.lists(st.tuples(st.integers(0, 9000), _DEEDS), max_size=8))
def test_what_was_done_gives_the_same_again(deeds: list[tuple[int, Any]]) -> None:
    course = Course(CONVERSATION)
    for wait, deed in deeds:
        course.advance(course.now + wait * 1000)
        course.give(deed)
    course.take()
    assert list(course.log) == again(course, CONVERSATION)
    # Saved with all that may be expected, it is a scenario that goes well.
    expected = chances(course.log)
    lines = parse(written(course, expected), "x.jsonl", ["converse"])
    verdict = simulate(CONVERSATION, lines)
    assert verdict.failures == []
    assert verdict.fulfilled == len(expected) > 0


def test_of_what_did_nothing_but_begin_nothing_is_expected_at_first() -> None:
    course = Course(VITALS)
    course.advance(SECOND)
    course.give(inputs.Touch())
    course.take()
    every = chances(course.log)
    assert {one.fields["application"] for one in every if one.fields["kind"] == "enter"} > {"home"}
    usual = [one for one in every if one.usual]
    assert {one.fields.get("application", "home") for one in usual} == {"home"}
    told = [one.words(VITALS) for one in usual]
    assert told[0] == "0 s: the situation is day"
    assert told[-1] == "1 s: home is in 2 room"


CONVERSATION, VITALS = ready("conversation"), ready("vitals")


@settings(max_examples=10, deadline=None)
@given(st.lists(st.tuples(st.integers(0, 6000), st.sampled_from(["in", "now", "hurry", "back"]))))
def test_versions_that_were_taken_in_and_gone_back_from_give_the_same_again(
    deeds: list[tuple[int, str]],
) -> None:
    files = sources(CONVERSATION)
    course = Course(CONVERSATION, files)
    for number, (wait, deed) in enumerate(deeds):
        course.give(inputs.Use("repeat"))
        course.advance(course.now + wait * 1000)
        if deed in ("in", "now"):
            old, new = "Did you sleep well?", f"Did you sleep well, for the {number}th time?"
            texts = {name: text.replace(old, new) for name, text in files.items()}
            project, _ = folder.load_texts(texts, CONVERSATION.root)
            assert project is not None
            course.take_in(Version(project, texts), at_once=deed == "now")
        elif deed == "hurry":
            course.hurry()
        else:
            course.go_back()
        assert course.failed is None
        assert (course.awaited is None) == (course.deployment.pending is None)
    course.advance(course.now + 20 * SECOND)
    assert course.awaited is None
    while course.can_return:
        course.go_back()
    assert course.project is CONVERSATION
    course.take()
    assert list(course.log) == again(course, CONVERSATION, files)


def test_dials_are_what_the_script_observes_and_modules_bring() -> None:
    found = {one.tag: one for one in dials(ready("conversation"))}
    assert found["hand.waving"].kind == "boolean"
    assert (found["person.direction"].kind, found["person.direction"].low) == ("number", -180)
    distance = next(one for one in dials(ready("reception")) if one.tag == "human.distance")
    assert (distance.kind, distance.unit) == ("number", "m")
    assert distance.low <= 0 < 1.5 < distance.high


def test_what_applications_set_themselves_is_no_dial_and_others_are_chosen_as_they_are_written(
    tmp_path: Path,
) -> None:
    root = tmp_path / "conversation"
    shutil.copytree(examples()["conversation"], root)
    file = root / "converse.rbd.xml"
    text = file.read_text()
    event = """<event name="notunderstood">
        <when>
          <all>
            <any><data tag="door" is="true" /><data tag="door" is="ajar" /></any>
            <data tag="asked" exists="true" />
          </all>
        </when>
        <set tag="asked">1</set>"""
    file.write_text(text.replace('<event name="notunderstood">', event, 1))
    found = {one.tag: one for one in dials(load_ready(root))}
    assert found["door"].values == ("true", "ajar")
    assert "asked" not in found


@pytest.mark.parametrize("name", sorted(examples()))
def test_a_dial_never_turns_what_the_robot_keeps_itself(name: str) -> None:
    for dial in dials(ready(name)):
        course = Course(ready(name))
        course.take()
        course.give(inputs.Set({dial.tag: 1}, "scenario"))
        warned = [e["message"] for e in course.take() if e["kind"] == "warning"]
        assert not any("kept by the runtime" in message for message in warned)
