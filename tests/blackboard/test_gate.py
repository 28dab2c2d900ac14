"""What is written down of those who never came in."""

from __future__ import annotations

import logging
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest
import zmq

from situ.blackboard import keys
from situ.blackboard.gate import Gate

DEADLINE = 20_000


@pytest.fixture
def context() -> Iterator[zmq.Context[zmq.Socket[bytes]]]:
    made: zmq.Context[zmq.Socket[bytes]] = zmq.Context()
    yield made
    made.destroy(linger=0)


def told_of_a_stranger(
    context: zmq.Context[zmq.Socket[bytes]],
    folder: Path,
    log: list[logging.LogRecord],
    *,
    stays: bool,
) -> str:
    """The line of one who connects, says nothing, and goes or is sent away."""
    keys.new_robot(folder)
    gate = Gate(keys.RobotKeys(folder), context)
    guarded = context.socket(zmq.XPUB)
    guarded.setsockopt(zmq.HANDSHAKE_IVL, 50)
    gate.guard(guarded, "notifications")
    poller = zmq.Poller()
    for descriptor in gate.descriptors():
        poller.register(descriptor, zmq.POLLIN)
    stranger = socket.create_connection(
        ("127.0.0.1", guarded.bind_to_random_port("tcp://127.0.0.1")), DEADLINE
    )
    if not stays:
        stranger.close()
    gate.drain()
    while not log:
        assert poller.poll(DEADLINE), "nothing was written down"
        gate.drain()
    stranger.close()
    gate.close()
    guarded.close(0)
    (line,) = log
    return line.getMessage()


def test_who_goes_before_he_has_shown_a_key_is_not_said_to_have_had_a_wrong_one(
    context: zmq.Context[zmq.Socket[bytes]], tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    line = told_of_a_stranger(context, tmp_path / "keys", caplog.records, stays=False)
    assert 'why="it went away before it had shown a key"' in line


def test_who_stays_and_shows_no_key_is_told_so(
    context: zmq.Context[zmq.Socket[bytes]], tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    line = told_of_a_stranger(context, tmp_path / "keys", caplog.records, stays=True)
    assert 'why="it has not shown a key in time"' in line
