"""A client and a core of different versions of Situ: docs/protocol.md, *Two sockets*."""

from __future__ import annotations

import json
from typing import Any

import pytest
from msgspec import UNSET
from tests.blackboard.test_dialog import Net
from tests.blackboard.test_vectors import vectors

import situ
from situ.blackboard import replies, wire

ADDED = {"situ", "masked"}
"""What was added to ``welcome`` since version 1 of the protocol came out."""


class Older:
    """A core from before those fields, behind another's: it does not tell them."""

    def __init__(self, hand: Any) -> None:
        self._hand = hand

    def raw(self, peer: str, body: bytes) -> bytes:
        told = json.loads(self._hand.raw(peer, body))
        return json.dumps({name: told[name] for name in told if name not in ADDED}).encode()

    def __getattr__(self, name: str) -> Any:
        return getattr(self._hand, name)


def test_a_core_tells_who_greets_it_which_situ_it_runs(hand: Any) -> None:
    assert hand.hello("chase")["situ"] == situ.__version__
    assert Net(hand).turn().dialog.situ == situ.__version__


def test_of_a_core_that_has_not_greeted_or_tells_no_version_none_is_known(hand: Any) -> None:
    assert Net(hand).dialog.situ is None
    net = Net(Older(hand)).turn()
    assert net.dialog.connected
    assert net.dialog.situ is None
    assert net.get(net.dialog.set({"x": 1})) == {"x": 1}


def test_a_client_reads_the_welcome_of_a_core_from_before_fields_were_added() -> None:
    body = next(one for one in vectors("replies") if one["re"] == "welcome")
    older = {name: value for name, value in body.items() if name not in ADDED}
    read = wire.read_reply(json.dumps(older).encode())
    assert isinstance(read, replies.Welcome)
    assert (read.situ, read.masked) == (UNSET, False)


@pytest.mark.parametrize("body", vectors("replies"), ids=lambda body: body["re"])
def test_a_client_passes_over_what_a_newer_core_answers(body: dict[str, Any]) -> None:
    newer = {**body, "mood": {"of": "the core"}}
    if "addresses" in body:
        newer["addresses"] = {**body["addresses"], "radio": None}
    assert wire.read_reply(json.dumps(newer).encode()) == wire.read_reply(json.dumps(body).encode())


@pytest.mark.parametrize("vector", vectors("notices"), ids=lambda vector: vector["topic"])
def test_a_client_passes_over_what_a_newer_core_notices(vector: dict[str, Any]) -> None:
    topic, body = vector["topic"].encode() + b"\n", vector["body"]
    newer = topic + json.dumps({**body, "mood": 1}).encode()
    assert wire.read_notice(newer) == wire.read_notice(topic + json.dumps(body).encode())


@pytest.mark.parametrize("body", vectors("requests"), ids=lambda body: body["do"])
def test_a_core_refuses_a_newer_client_s_field_and_names_it(body: dict[str, Any]) -> None:
    with pytest.raises(wire.Malformed, match="`mood`"):
        wire.read_request(json.dumps({**body, "mood": 1}).encode())
