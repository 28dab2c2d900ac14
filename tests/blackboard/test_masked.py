"""What is private is shown to no viewer, and in the trace to no module (docs/security.md)."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import pytest

from situ.blackboard import wire
from situ.blackboard.topics import MASKED, is_open
from situ.decide.masking import HIDDEN
from situ.document.project import Project

Hand = Any


@pytest.fixture
def hand(ward: Project, make_hand: Callable[..., Hand]) -> Hand:
    made: Hand = make_hand(ward)
    made.hello("ann", role="operator", user="ann")
    return made


def masked(hand: Hand) -> list[dict[str, Any]]:
    """The notices since the last call that are for those from whom something is hidden."""
    notices, hand.notices = hand.notices, []
    return [json.loads(one.partition(b"\n")[2]) for one in notices if one.startswith(MASKED)]


def test_a_viewer_gets_and_watches_nothing_private(hand: Hand) -> None:
    assert hand.hello("tablet", role="viewer")["masked"]
    hand.ask("ann", "set", tags={"user.name": "Bea", "greeting": "Hello Bea!", "mood": "good"})
    shown = {"user.name": HIDDEN, "greeting": HIDDEN, "mood": "good"}
    for ask in ({"do": "get", "names": list(shown)}, {"do": "watch", "patterns": list(shown)}):
        entries = hand.ask("tablet", **ask)["entries"]
        assert {tag: entry["value"] for tag, entry in entries.items()} == shown
    masked(hand)
    hand.ask("ann", "set", tags={"user.name": "Cyd", "greeting": "Cyd?", "mood": "bad"})
    told = {one["tag"]: one["value"] for one in masked(hand)}
    assert told == {"user.name": HIDDEN, "greeting": HIDDEN, "mood": "bad"}
    hand.ask("ann", "set", tags={"user.name": None})
    assert [one["value"] for one in masked(hand)] == [None]


def test_a_module_needs_the_values_of_tags(hand: Hand) -> None:
    assert hand.hello("nod")["masked"]
    hand.ask("nod", "watch", patterns=["user.name"])
    hand.ask("ann", "set", tags={"user.name": "Bea"})
    assert hand.changes() == [("user.name", "Bea", 2)]
    assert hand.ask("nod", "get", names=["user.name"])["entries"]["user.name"]["value"] == "Bea"
    assert masked(hand) == []


@pytest.mark.parametrize("who", [{"role": "viewer"}, {"module": "eyes"}])
def test_the_trace_is_masked_as_it_comes_and_as_it_was(who: dict[str, str], hand: Hand) -> None:
    hand.ask("ann", "set", tags={"user.name": "Bea", "greeting": "Hello Bea!"})
    hand.ask("ann", "set", tags={"user.name": None})
    hand.hello("eyes", **who)
    past = hand.ask("eyes", "trace", since=1)["events"]
    masked(hand)
    hand.ask("ann", "set", tags={"user.name": "Cyd", "greeting": "Hello Bea and Cyd!"})
    (now,) = masked(hand)
    told = [*past, *now["events"]]
    assert [one["seq"] for one in told] == list(range(1, len(told) + 1))
    values = [one["value"] for one in told if one.get("tag") in ("user.name", "greeting")]
    # What was private stays so after it was deleted, for who comes later too.
    assert values == [HIDDEN, HIDDEN, HIDDEN, None, HIDDEN, HIDDEN]
    assert "Ann" not in json.dumps(told)


def test_what_was_private_while_nobody_looked_is_known_too(hand: Hand) -> None:
    hand.hello("tablet", role="viewer")
    hand.ask("ann", "set", tags={"user.name": "Dee"})
    hand.ask("ann", "set", tags={"user.name": None, "greeting": "Hello Dee!"})
    entries = hand.ask("tablet", "get", names=["greeting"])["entries"]
    assert entries["greeting"]["value"] == HIDDEN


def test_messages_and_what_people_may_say_are_masked_for_a_viewer(hand: Hand) -> None:
    hand.hello("tablet", role="viewer")
    masked(hand)
    hand.ask("ann", "publish", event="go")
    (message,) = masked(hand)
    assert (message["topic"], message["value"]) == ("desk/busy", {"user": HIDDEN})


def test_an_operator_is_shown_everything(hand: Hand) -> None:
    assert not hand.hello("bob", role="operator", user="bob")["masked"]
    hand.ask("bob", "watch", patterns=["user.*"])
    hand.ask("bob", "trace")
    hand.ask("ann", "set", tags={"user.name": "Bea"})
    assert hand.ask("bob", "get", names=["user.name"])["entries"]["user.name"]["value"] == "Bea"
    said = b"".join(hand.notices)
    assert said.count(b'"Bea"') == 2
    assert MASKED not in said


def test_where_nothing_is_private_nothing_is_masked(make_hand: Callable[..., Hand]) -> None:
    hand = make_hand()
    assert not hand.hello("tablet", role="viewer")["masked"]
    hand.ask("tablet", "watch", patterns=["user.*"])
    hand.ask("tablet", "trace")
    hand.ask("tablet", "bye")
    hand.hello("tablet", role="viewer")
    assert masked(hand) == []
    assert hand.ask("tablet", "get", names=["user.name"])["entries"]["user.name"]["value"] == "Ann"


def test_after_a_kill_it_is_hidden_from_the_same(
    hand: Hand, ward: Project, make_hand: Callable[..., Hand]
) -> None:
    hand.hello("tablet", role="viewer")
    hand.ask("tablet", "watch", patterns=["user.*"])
    hand.ask("tablet", "trace")
    hand.ask("ann", "set", tags={"user.name": "Bea"})
    after = make_hand(ward, begin=False)
    after.robot.restore(hand.robot.snapshot())
    after.sessions.restore(hand.sessions.state(), [], 0)
    after.hello("ann", role="operator", user="ann")
    after.ask("ann", "set", tags={"user.name": "Cyd", "greeting": "Hello Bea!"})
    said = masked(after)
    assert [one["on"] for one in said] == ["events", "change"]
    assert "Cyd" not in json.dumps(said)
    assert "Bea" not in json.dumps(said)


def test_where_another_project_hides_more_the_session_begins_anew(
    lab: Project, ward: Project, make_hand: Callable[..., Hand]
) -> None:
    hand = make_hand(lab)
    hand.hello("tablet", role="viewer")
    hand.core.project = ward
    assert hand.ask("tablet", "get", names=["user.name"])["code"] == "session"
    assert hand.hello("tablet", role="viewer")["masked"]
    assert hand.ask("tablet", "get", names=["user.name"])["entries"]["user.name"]["value"] == HIDDEN


@pytest.mark.parametrize(
    ("role", "topic", "may"),
    [
        ("viewer", b"", False),
        ("viewer", b"t:user.", False),
        ("viewer", b"m:", False),
        ("viewer", b"x:screen\n", False),
        ("viewer", b"q:face\n", False),
        ("viewer", b"trace\n", False),
        ("viewer", b"mask", False),
        ("viewer", b"masked:trace\n", True),
        ("viewer", b"masked:t:", True),
        ("viewer", b"a:head\n", True),
        ("viewer", b"echo:1\n", True),
        ("viewer", b"end\n", True),
        ("module", b"", False),
        ("module", b"t", False),
        ("module", b"trace", False),
        ("module", b"trace\n", False),
        ("module", b"t:user.name\n", True),
        ("module", b"masked:trace\n", True),
        ("operator", b"", True),
        ("operator", b"trace\n", True),
    ],
)
def test_who_may_hear_which_topics(role: str, topic: bytes, may: bool) -> None:
    assert is_open(role, topic) == may


def test_a_masked_notice_is_read_as_any_other(hand: Hand) -> None:
    hand.hello("tablet", role="viewer")
    hand.ask("tablet", "watch", patterns=["user.*"])
    hand.ask("ann", "set", tags={"user.name": "Bea"})
    (notice,) = [one for one in hand.notices if one.startswith(MASKED)]
    assert notice.startswith(b"masked:t:user.name\n")
    assert wire.read_notice(notice).value == HIDDEN  # type: ignore[union-attr]
