"""What each request does, row by row of docs/protocol.md, *Requests*."""

from __future__ import annotations

from typing import Any

import pytest


@pytest.fixture
def ann(hand: Any) -> Any:
    """The core, with an operator ``ann``."""
    hand.hello("ann", role="operator", user="ann")
    return hand


def entries(hand: Any, *names: str) -> dict[str, Any]:
    found: dict[str, Any] = hand.ask("ann", "get", names=names)["entries"]
    return found


def test_a_write_of_several_tags_at_versions_is_all_or_nothing(ann: Any) -> None:
    ann.ask("ann", "set", tags={"a": 1, "b": 1})
    ann.ask("ann", "watch", patterns=["**"])
    ann.heard()
    refused = ann.ask("ann", "set", tags={"a": 2, "b": 2}, versions={"a": 1, "b": 2})
    assert (refused["code"], refused["message"]) == (
        "conflict",
        "b is at version 1, not 2: get it and try again",
    )
    assert [entries(ann, "a", "b")[tag]["value"] for tag in "ab"] == [1, 1]
    assert ann.changes() == []
    written = ann.ask("ann", "set", tags={"a": 2, "b": 2}, versions={"a": 1, "b": 1})
    assert written["versions"] == {"a": 2, "b": 2}
    assert ann.changes() == [("a", 2, 2), ("b", 2, 2)]


def test_a_tag_at_whose_version_is_looked_need_not_be_written(ann: Any) -> None:
    assert ann.ask("ann", "set", tags={"a": 1}, versions={"lock": 0})["versions"] == {"a": 1}
    ann.ask("ann", "set", tags={"lock": "ann"})
    assert ann.ask("ann", "set", tags={"a": 2}, versions={"lock": 0})["code"] == "conflict"
    # Deleted is missing, whatever its version was.
    ann.ask("ann", "set", tags={"lock": None})
    assert ann.ask("ann", "set", tags={"a": 2}, versions={"lock": 0})["versions"] == {"a": 2}


def test_only_what_changed_has_a_new_version(ann: Any) -> None:
    written = ann.ask("ann", "set", tags={"a": 1, "never.there": None})
    assert written["versions"] == {"a": 1}
    assert ann.ask("ann", "set", tags={"a": 1})["versions"] == {"a": 2}


def test_one_tag_that_may_not_be_set_keeps_the_others_from_it(ann: Any) -> None:
    assert ann.ask("ann", "set", tags={"a": 1, "robot/head": 2})["code"] == "refused"
    assert entries(ann, "a")["a"]["version"] == 0


def test_get_gives_tags_patterns_and_what_lies_inside(ann: Any) -> None:
    ann.at(0.5).ask("ann", "set", tags={"patient": {"room": 7, "Beds": ["a", "b"]}, "face.x": 1})
    ann.ask("ann", "set", tags={"face.y": 2, "face.z.deep": 3})
    ann.ask("ann", "set", tags={"face.y": None})
    found = entries(ann, "patient.room", "patient.Beds.1", "patient.none", "face.*")
    assert {name: entry["value"] for name, entry in found.items()} == {
        "patient.room": 7,
        "patient.Beds.1": "b",
        "patient.none": None,
        "face.x": 1,
    }
    inside = {"value": 7, "version": 1, "writer": "operator:ann", "time": 500_000}
    assert found["patient.room"] == inside
    assert set(entries(ann, "face.**")) == {"face.x", "face.z.deep"}


def test_who_watches_twice_is_told_once_and_unwatching_what_is_not_watched_is_no_fault(
    ann: Any,
) -> None:
    first = ann.ask("ann", "watch", patterns=["face.*", "face.*"])
    assert ann.ask("ann", "watch", patterns=["face.*"])["changes"] == first["changes"]
    ann.ask("ann", "set", tags={"face.x": 1})
    assert ann.changes() == [("face.x", 1, 1)]
    assert ann.ask("ann", "heartbeat")["changes"] == {"face.*": 1}
    assert ann.ask("ann", "unwatch", patterns=["face.*", "other.*"])["re"] == "done"
    ann.ask("ann", "set", tags={"face.x": 2})
    assert ann.changes() == []
    assert ann.ask("ann", "heartbeat")["changes"] == {}


def test_one_wrong_pattern_and_none_is_watched(ann: Any) -> None:
    assert ann.ask("ann", "watch", patterns=["face.*", "No Pattern"])["code"] == "invalid"
    assert ann.ask("ann", "heartbeat")["changes"] == {}


def test_an_event_goes_to_one_application_or_to_all(ann: Any) -> None:
    assert ann.ask("ann", "publish", event="go", application="lamp")["code"] == "refused"
    assert ann.ask("ann", "publish", event="go", application="desk")["re"] == "done"
    assert entries(ann, "application/desk.state")["application/desk.state"]["value"] == "2"
    assert ann.ask("ann", "publish", event="asked")["re"] == "done"
    assert entries(ann, "application/desk.state")["application/desk.state"]["value"] == "1"


def test_asking_for_authority_replaces_what_was_asked_before(ann: Any) -> None:
    ann.hello("carry", resources=["base", "head"])
    granted = ann.ask("carry", "acquire", resources=["base", "head"])
    assert granted["holds"] == ["base", "head"]
    assert granted["seq"] == ann.ask("carry", "heartbeat")["seq"]
    assert ann.ask("carry", "acquire", resources=["head"])["holds"] == ["head"]
    ann.hello("chase", resources=["head"])
    assert ann.ask("chase", "acquire", resources=["head"])["holds"] == ["head"]
    # All or nothing, but for what is optional.
    assert ann.ask("carry", "acquire", resources=["base", "head"])["holds"] == []
    granted = ann.ask("carry", "acquire", resources=["base"], optional=["head"])
    assert granted["holds"] == ["base"]


def test_some_or_all_of_it_is_given_back(ann: Any) -> None:
    ann.hello("carry", resources=["base", "head"])
    ann.ask("carry", "acquire", resources=["base", "head"])
    assert ann.ask("carry", "abandon", resources=["head"])["holds"] == ["base"]
    ann.ask("carry", "acquire", resources=["base", "head"])
    assert ann.ask("carry", "abandon")["holds"] == []
    # Giving back what one has not is no fault.
    assert ann.ask("carry", "abandon", resources=["head"])["holds"] == []


def test_a_command_counts_while_it_is_good_and_the_resource_held(ann: Any) -> None:
    def moves() -> Any:
        return entries(ann, "robot/head")["robot/head"]["value"]

    ann.hello("chase", resources=["head"])
    # Commanding what is not held is no fault, and moves nothing.
    assert ann.ask("chase", "command", resource="head", value=1)["re"] == "done"
    assert moves() is None
    ann.ask("chase", "acquire", resources=["head"])
    ann.ask("chase", "command", resource="head", value=2, **{"for": 0.5})
    assert moves() == 2
    ann.at(0.499999)
    assert moves() == 2
    ann.at(0.5)
    assert moves() is None
    ann.ask("chase", "command", resource="head", value=3)
    ann.ask("chase", "abandon")
    assert moves() is None
    assert ann.ask("chase", "command", resource="base", value=1)["code"] == "refused"


def test_a_module_tells_of_itself_later_and_keeps_its_description(ann: Any) -> None:
    ann.hello("eyes", description="Sees.", provides=[{"data": "face.x"}])
    offer = {"data": "face.direction", "type": "number", "unit": "deg"}
    told = ann.ask("eyes", "disclose", requires=[{"module": "ears"}], provides=[offer])
    assert told["re"] == "done"

    def state() -> dict[str, Any]:
        states = ann.ask("ann", "modules")["modules"]
        return next(one for one in states if one["name"] == "eyes")

    assert (state()["description"], state()["provides"]) == ("Sees.", [offer])
    assert state()["requires"] == [{"module": "ears"}]
    wanted = ann.ask("ann", "modules")["wanted"]
    assert {"data": None, "module": "ears", "by": ["eyes"]} in wanted
    ann.ask("eyes", "disclose", description="Sees far.", requires=[{"data": "light"}])
    assert (state()["description"], state()["requires"]) == ("Sees far.", [{"data": "light"}])


def test_a_session_that_says_goodbye_is_over_at_once(ann: Any) -> None:
    ann.hello("chase", resources=["head"])
    ann.ask("chase", "acquire", resources=["head"])
    ann.heard()
    assert ann.ask("chase", "bye")["re"] == "done"
    (passed,) = ann.heard()
    assert (passed.resource, passed.source, passed.to) == ("head", "chase", None)
    assert ann.ask("chase", "heartbeat")["code"] == "session"
    assert ann.hello("chase", resources=["head"])["re"] == "welcome"
