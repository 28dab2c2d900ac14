"""The bytes of version 1, in both directions; docs/protocol.md names every message and field."""

from __future__ import annotations

import json
import random
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any, get_args

import msgspec
import pytest
from msgspec import Struct

from situ.blackboard import notices, protocol, replies, topics, wire

ROOT = Path(__file__).parent.parent
DOCUMENT = (ROOT.parent / "docs" / "protocol.md").read_text("utf-8")


def vectors(name: str) -> list[Any]:
    found: list[Any] = json.loads((ROOT / "vectors" / f"{name}.json").read_text("utf-8"))
    return found


def kinds(base: type[Struct]) -> dict[str, type[Struct]]:
    return {str(kind.__struct_config__.tag): kind for kind in base.__subclasses__()}


@pytest.mark.parametrize("body", vectors("requests"), ids=lambda body: body["do"])
def test_a_request_reads_and_writes_as_its_vector(body: dict[str, Any]) -> None:
    read = wire.read_request(json.dumps(body).encode())
    assert json.loads(wire.encode(read)) == body


@pytest.mark.parametrize("body", vectors("replies"), ids=lambda body: body["re"])
def test_a_reply_reads_and_writes_as_its_vector(body: dict[str, Any]) -> None:
    read = wire.read_reply(json.dumps(body).encode())
    assert json.loads(wire.encode(read)) == body


@pytest.mark.parametrize("vector", vectors("notices"), ids=lambda vector: vector["topic"])
def test_a_notice_reads_and_writes_as_its_vector(vector: dict[str, Any]) -> None:
    topic = vector["topic"].encode() + b"\n"
    frame = topic + json.dumps(vector["body"]).encode()
    read = wire.read_notice(frame)
    assert json.loads(wire.notice(topic, read)[len(topic) :]) == vector["body"]


@pytest.mark.parametrize("vector", vectors("malformed"), ids=lambda vector: vector["body"][:40])
def test_a_malformed_request_is_told_in_one_line(vector: dict[str, Any]) -> None:
    with pytest.raises(wire.Malformed) as caught:
        wire.read_request(vector["body"].encode())
    assert caught.value.id == vector["id"]
    assert "docs/protocol.md" in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("vector", vectors("topics"), ids=lambda vector: vector["pattern"])
def test_a_pattern_is_subscribed_to_by_its_beginning(vector: dict[str, str]) -> None:
    subscribed = {"changes": topics.changes, "messages": topics.messages}
    assert subscribed[vector["of"]](vector["pattern"]).decode() == vector["subscribe"]


def test_every_message_has_a_vector() -> None:
    asked = {body["do"] for body in vectors("requests")}
    answered = {body["re"] for body in vectors("replies")}
    told = {vector["body"]["on"] for vector in vectors("notices")}
    assert asked == kinds(protocol.Request).keys()
    assert answered == kinds(replies.Reply).keys()
    assert told == kinds(notices.Notice).keys()


def test_every_request_has_its_reply() -> None:
    assert set(replies.REPLIES) == set(protocol.Request.__subclasses__())


@pytest.mark.parametrize("base", [protocol.Request, replies.Reply, notices.Notice])
def test_the_document_has_a_row_for_every_message_with_all_its_fields(base: type[Struct]) -> None:
    for tag, kind in kinds(base).items():
        row = re.search(rf"^\| `{tag}` \|.*$", DOCUMENT, re.MULTILINE)
        assert row is not None, f"docs/protocol.md has no row for {tag}"
        shared = {"id", "at"} if base is protocol.Request else {"id"}
        for name in set(kind.__struct_encode_fields__) - shared:
            assert f"`{name}`" in row[0], f"docs/protocol.md does not tell of {name} in {tag}"


def test_the_document_names_every_code() -> None:
    for code in get_args(replies.Code):
        assert f"`{code}`" in DOCUMENT, code


def test_mutated_requests_are_always_answered(make_hand: Callable[..., Any]) -> None:
    hand = make_hand()
    hand.hello("nod")
    chance = random.Random(5570)
    bodies = [json.dumps(body).encode() for body in vectors("requests")]
    for _ in range(2000):
        body = bytearray(chance.choice(bodies))
        for _ in range(chance.randint(1, 4)):
            cut = chance.randrange(len(body) + 1)
            piece = bytes(chance.randrange(256) for _ in range(chance.randint(0, 3)))
            body[cut : cut + chance.randint(0, 3)] = piece
        hand.raw("nod", bytes(body))
    hand.hello("chase")
    assert hand.ask("chase", "set", tags={"still.here": True})["re"] == "written"


@pytest.mark.parametrize(
    "body",
    [
        b'{"do":"set","id":1,"tags":{"x":' + b"[" * 100_000 + b"]" * 100_000 + b"}}",
        b'{"do":"set","id":1,"tags":{"x":"\xff\xfe"}}',
        b'{"do":"set","id":1,"tags":{"x":"\\ud800"}}',
        b'{"do":"set","id":1,"tags":{"x":1e999}}',
        b'{"do":"get","id":1,"names":["' + b"a." * 100_000 + b'a"]}',
        b"\0" * 1000,
    ],
    ids=["deep", "not-utf-8", "half-a-character", "too-large", "long-name", "nul"],
)
def test_hostile_bodies_are_answered_and_do_no_harm(hand: Any, body: bytes) -> None:
    hand.hello("nod")
    answer = msgspec.json.decode(hand.raw("nod", body))
    assert answer["re"] == "refused"
    assert hand.ask("nod", "heartbeat")["re"] == "alive"
