"""What if: the core's own judgement of a script, for values and requests as given."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st

from situ.decide import inputs
from situ.decide.robot import Robot
from situ.document import codec, folder
from situ.document.project import Project
from situ.document.spds import Spds
from situ.rehearse.what_if import Answer, what_if
from situ.resources import example


def read(situations: str) -> Spds:
    text = (
        '<spds name="s"><modules><module name="m" resources="head"/></modules>'
        f'{situations}<situation name="else"/></spds>'
    )
    found, problems = codec.read(text.encode(), "s.spds.xml")
    assert isinstance(found, Spds), problems
    return found


def answer(situations: str, values: Mapping[str, Any]) -> Answer:
    return what_if(read(situations), values, {})


def test_a_value_counts_as_set_just_now_and_as_having_lasted() -> None:
    both = '<situation name="s"><condition><data tag="t" is="true" {}/></condition></situation>'
    for timing in ("", 'within="0.1"', 'for="90"', 'within="0.1" for="90"'):
        assert answer(both.format(timing), {"t": True}).situation == "s", timing
        assert answer(both.format(timing), {"t": False}).situation == "else", timing
        assert answer(both.format(timing), {}).situation == "else", timing


def test_what_is_missing_counts_as_missing_for_long() -> None:
    missing = (
        '<situation name="s"><condition><data tag="t" exists="false" for="5"/></condition>'
        "</situation>"
    )
    assert answer(missing, {}).situation == "s"
    assert answer(missing, {"t": None}).situation == "s"
    assert answer(missing, {"t": 0}).situation == "else"


def test_no_dwell_limit_or_until_of_before_keeps_a_situation() -> None:
    kept = (
        '<situation name="s" {}><condition><data tag="t" is="true"/></condition>{}</situation>'
        '<situation name="slow"><condition><data tag="u" is="true" for="60"/></condition>'
        "</situation>"
    )
    for attribute in ('dwell="2"', 'limit="2"'):
        assert answer(kept.format(attribute, ""), {"t": True}).situation == "s"
        assert answer(kept.format(attribute, ""), {"u": True}).situation == "slow"
    until = '<until><data tag="end" is="true"/></until>'
    assert answer(kept.format("", until), {"t": True}).situation == "s"
    found = answer(kept.format("", until), {"t": True, "end": True})
    assert (found.situation, found.holds) == ("else", ("s", "else"))


def test_nobody_holds_what_no_module_of_the_situation_asks_for() -> None:
    script = read('<situation name="s"><module name="m" priority="1"/></situation>')
    assert what_if(script, {}, {"m": ("head",)}).holdings["head"].module == "m"
    assert what_if(script, {}, {"other": ("head",)}).holdings["head"].module is None
    assert what_if(script, {}, {}).holdings == {}


def _conversation() -> Project:
    project, _ = folder.load(example("conversation"))
    assert project is not None
    return project


TAGS = ("hand.waving", "person.calling", "sound.slap", "speech.acceptable", "robot.stop")
CONVERSATION = _conversation()


@given(st.dictionaries(st.sampled_from(TAGS), st.booleans()))
@settings(max_examples=40, deadline=None)
def test_the_answer_is_what_a_robot_does_to_whom_the_same_is_told_at_once(
    values: dict[str, bool],
) -> None:
    script = CONVERSATION.spds
    assert script is not None
    alone = Project(root=".", name="alone", spds=script, spds_file="s.spds.xml")
    robot = Robot(alone)
    robot.step(inputs.Start(), 0)
    robot.step(inputs.Set(dict(values), "scenario"), 1)
    declared = {m.name: m.resources for m in script.modules}
    for module, resources in declared.items():
        robot.step(inputs.Acquire(module, resources), 2)
    found = what_if(script, values, declared)
    current = robot.board.look("situation")
    assert found.situation == current["name"]
    assert {r: h.module for r, h in found.holdings.items()} == {
        r: robot._world.priorities.holder(r) for r in found.holdings
    }
