"""Conditions and actions in plain words, as canvas, diff and why say them."""

from __future__ import annotations

import pytest

from situ.document import words
from situ.document.condition import Condition, Group
from situ.document.condition import Test as Single
from situ.document.rbd import Message, Param, Robot, Speech, State


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ('["a", 1]', "a, 1"),
        ("[]", ""),
        ("not a list", "not a list"),
        ('"a"', '"a"'),
    ],
)
def test_a_list_is_told_member_by_member_and_what_is_none_as_it_is_written(
    value: str, said: str
) -> None:
    assert words.predicate(Single("t", "in", value)).endswith(said)


def test_an_empty_list_and_an_empty_text_can_be_seen() -> None:
    assert words.predicate(Single("t", "is", "[ ]")).endswith("[ ]")
    assert words.predicate(Single("t", "is", "")).endswith("empty")


def test_no_condition_is_nothing() -> None:
    assert words.condition(None) == ""
    assert words.condition(Condition((Single("t", "is", "1"),))) == "t is 1"


def test_a_group_is_in_brackets_where_it_could_be_read_otherwise() -> None:
    one, two = Single("a", "is", "1"), Single("b", "is", "2")
    alone = Group("all", (one,))
    either = Group("any", (one, two))
    assert words.condition(Condition((alone, two))) == "a is 1 and b is 2"
    assert words.condition(Condition((either, two))) == "(a is 1 or b is 2) and b is 2"
    nested = Group("all", (either,))
    assert words.condition(Condition((nested, two))) == "(a is 1 or b is 2) and b is 2"
    assert (
        words.condition(Condition((Group("none", (one,)), two))) == "(none of: a is 1) and b is 2"
    )


def test_a_state_called_by_its_number_is_named_once() -> None:
    assert words.state(State(no="2", name="state 2")) == "2"
    assert words.state(State(no="2")) == "2"
    assert words.state(State(no="2", name="state 3")) == "2 state 3"
    assert words.state(State(no="6", name="show names")) == "6 show names"
    # Of a state in a part, too.
    assert words.numbered("4/2", "state 2") == "4/2"
    assert words.numbered("4/2", "look") == "4/2 look"


def test_an_action_is_told_by_what_it_does() -> None:
    assert words.action(Speech(text="Hello")) == "Hello"
    assert words.action(Message(topic="nurse/call", text="Come")) == "Come"
    robot = Robot(resource="base", command="goto", params=(Param("place", "lobby"),))
    assert words.action(robot) == "goto lobby"
