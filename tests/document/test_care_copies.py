"""What is private is not copied to where it is not: what is told, and what is left alone."""

from __future__ import annotations

import pytest
from tests.document.care_projects import BUTTON, TOUCHED, always, state, told, whole

TAKES = '<event name="go">{}</event>'
LIST = '<list id="names" x="10" y="30" width="80" height="40" items="user.names" {}/>'
PRESSED = '<button id="b" x="35" y="75" width="30" height="15" {}>OK</button>'


def found(
    acts: str = "", screen: str = BUTTON, rest: str = "", pattern: str = "user.**"
) -> list[tuple[str, ...]]:
    project = whole(
        rest + state(screen, acts=acts, events=TOUCHED),
        private=(pattern,),
        tags={"user.name": "Ann", "user.age": 81, "user.names": []},
    )
    return [problem.place for problem in told(project, "private-copied")]


@pytest.mark.parametrize(
    ("acts", "is_told"),
    [
        ('<set tag="who">{user.name}</set>', True),
        ('<set tag="greeting">Hello {user.name}!</set>', True),
        ('<set tag="initial">{user.names.0}</set>', True),
        ('<add tag="ages">{user.age}</add>', True),
        ('<append tag="visitors">{user.name}</append>', True),
        ('<take from="user.names" tag="next"/>', True),
        # Within what is private it stays.
        ('<set tag="user.last">{user.name}</set>', False),
        ('<take from="user.names" tag="user.next"/>', False),
        ('<append tag="user.names">{user.name}</append>', False),
        # What is not private goes where it will.
        ('<set tag="who">{guest.name}</set>', False),
        ('<take from="names" tag="next"/>', False),
        ('<add tag="visits">1</add>', False),
        ('<set tag="who">user.name</set>', False),
        # Nor is it kept by who is told of it.
        ('<message topic="nurse/call"><param name="who">{user.name}</param></message>', False),
    ],
)
def test_a_private_value_that_an_action_puts_into_a_public_tag_is_told(
    acts: str, is_told: bool
) -> None:
    assert found(acts) == ([("state", "1", "action", "0")] if is_told else [])


@pytest.mark.parametrize(
    ("screen", "is_told"),
    [
        (LIST.format('tag="chosen" event="go"'), True),
        (LIST.format('tag="user.chosen" event="go"'), False),
        (LIST.format('event="go"'), False),
        (PRESSED.format('event="go" tag="chosen" value="{user.name}"'), True),
        (PRESSED.format('event="go" tag="chosen" value="yes"'), False),
        (PRESSED.format('event="go" tag="chosen"'), False),
        (PRESSED.format('event="go"'), False),
    ],
)
def test_so_is_one_that_a_person_chooses(screen: str, is_told: bool) -> None:
    name = "names" if "<list" in screen else "b"
    assert found(screen=screen) == ([("state", "1", "screen", name)] if is_told else [])


def test_it_is_told_of_events_and_of_what_every_state_has_too() -> None:
    put = TAKES.format('<set tag="who">{user.name}</set>')
    assert found(rest=always(events=put)) == [("always", "event", "0", "action", "0")]


def test_nothing_is_told_where_nothing_is_private() -> None:
    acts = '<set tag="who">{user.name}</set>'
    assert told(whole(state(BUTTON, acts=acts, events=TOUCHED)), "private-copied") == []
    assert found(acts, pattern="name") == []
