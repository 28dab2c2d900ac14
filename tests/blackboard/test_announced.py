"""What robots tell the network of themselves, and what is made of it (docs/protocol.md)."""

from __future__ import annotations

import asyncio
import contextlib
import ipaddress
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from zeroconf import ServiceStateChange, Zeroconf
from zeroconf.asyncio import AsyncServiceInfo

from situ.blackboard import keys, nearby
from situ.blackboard.announced import SERVICE, Announced, fingerprint, heard, label, properties
from situ.blackboard.keys import RobotKey, new_pair
from situ.blackboard.nearby import best_first, standing
from situ.blackboard.protocol import VERSION
from situ.cli import main
from situ.errors import UsageError

AT = ("10.0.0.5",)
WARD = Announced("ward", "rob1", 5570, AT)


def as_heard(robot: Announced) -> Announced | None:
    told = {key.encode(): value for key, value in properties(robot).items()}
    return heard(robot.addresses, robot.port, told)


@given(st.text(min_size=1), st.text(), st.text(alphabet="0123456789abcdef", max_size=32))
def test_what_is_told_fits_and_is_heard(project: str, host: str, key: str) -> None:
    robot = Announced(project, host, 5570, AT, key)
    assert all(
        len(f"{name}={value!r}") and len(name) + len(value) < 255
        for name, value in properties(robot).items()
    )
    name = label(robot)
    assert len(name.encode()) < 63
    assert "." not in name
    found = as_heard(robot)
    assert found is not None
    assert (found.port, found.addresses, found.key) == (5570, AT, key)
    short = "".join(one if one.isprintable() else " " for one in project).strip()
    assert short.encode("utf-8", "replace").startswith(found.project.encode())


@given(st.dictionaries(st.binary(max_size=9), st.none() | st.binary(max_size=300)))
def test_whatever_a_stranger_tells_is_a_robot_or_none_and_one_line_of_plain_text(
    told: dict[bytes, bytes | None],
) -> None:
    found = heard(AT, 5570, {b"protocol": b"1", **told})
    if found is not None:
        for text in (found.project, found.host, found.key):
            assert text.isprintable()
            assert len(text) <= 255


def test_who_can_not_be_asked_is_none() -> None:
    assert heard((), 5570, {b"protocol": b"1"}) is None
    assert heard(AT, 0, {b"protocol": b"1"}) is None
    assert heard(AT, None, {b"protocol": b"1"}) is None
    assert heard(AT, 5570, {}) is None
    assert heard(AT, 5570, {b"protocol": b"one"}) is None
    assert heard(AT, 5570, {b"protocol": "١".encode()}) is not None


def test_what_comes_of_connecting_is_judged_by_the_keys_that_are_here() -> None:
    robot, other = new_pair("robot").public, new_pair("robot").public
    known = {"ward": RobotKey(robot, ("tcp://10.0.0.5:5570",))}
    keyed = Announced("ward", "rob1", 5570, AT, fingerprint(robot))
    moved = Announced("ward", "rob1", 5570, ("10.0.0.9",), fingerprint(robot))
    strange = Announced("ward", "rob1", 5570, ("10.0.0.9",), fingerprint(other))
    assert standing(keyed, known) == "ready"
    # The key tells which robot it is, not the address.
    assert standing(moved, known) == "ready"
    assert standing(keyed, {}) == "no-key"
    assert standing(strange, known) == "no-key"
    assert standing(WARD, {}) == "open"
    # It takes the place of one that is known, by address or by name.
    assert standing(Announced("desk", "rob1", 5570, AT, fingerprint(other)), known) == "other-key"
    assert standing(Announced("desk", "rob1", 5570, AT), known) == "other-key"
    assert standing(Announced("ward", "rob1", 5571, ("10.0.0.9",)), known) == "other-key"
    newer = Announced("ward", "rob1", 5570, AT, fingerprint(robot), VERSION + 1)
    assert standing(newer, known) == "other-version"


def test_the_address_that_we_can_reach_comes_first() -> None:
    ours = (ipaddress.IPv4Network("10.0.0.0/24"),)
    every = ("172.17.0.1", "10.0.0.5", "192.168.1.2")
    assert best_first(every, ours) == ("10.0.0.5", "172.17.0.1", "192.168.1.2")
    assert best_first(every, ()) == every


def test_a_robot_that_was_found_is_asked_with_its_own_key_wherever_it_is(tmp_path: Path) -> None:
    mine = new_pair("ann")
    first, second = new_pair("robot").public, new_pair("robot").public
    keys.new_client(tmp_path, mine, "ward", RobotKey(first, ("tcp://10.0.0.5:5570",)))
    keys._write(  # as a person puts a second robot there
        tmp_path / "robots" / "desk.toml", RobotKey(second, ("tcp://10.0.0.6:5570",)), 0o644, ""
    )
    elsewhere = "tcp://10.0.0.9:5570"
    found = keys.client_keys(elsewhere, tmp_path, robot=fingerprint(second))
    assert found is not None
    assert found.robot == second.encode()
    # At the address of another one too: then it can not be that one.
    found = keys.client_keys("tcp://10.0.0.5:5570", tmp_path, robot=fingerprint(second))
    assert found is not None
    assert found.robot == second.encode()
    for folder in (tmp_path, None):
        with pytest.raises(UsageError, match=r"no key for this robot here; situ keys add"):
            keys.client_keys(elsewhere, folder, robot="0" * 32)


# -- who is there ------------------------------------------------------------


class Answering(AsyncServiceInfo):
    """Each that is asked answers at once."""

    def __init__(self, type_: str, name: str) -> None:
        told = dict[Any, Any](properties(WARD))
        super().__init__(type_, name, 5570, properties=told, parsed_addresses=["10.0.0.5"])

    async def async_request(self, *_: Any) -> bool:
        return True


def test_a_name_that_no_robot_can_have_takes_nobodys_place_and_steers_no_terminal(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    class Browser:
        """Has heard of five, of which one is a robot."""

        def __init__(self, zeroconf: Any, service: str, handlers: list[Any]) -> None:
            for name in ("a\x1b[2J", "a\x9b2J", "a\u202eb", "_sub", "ward at rob1"):
                for handler in handlers:
                    full = f"{name}.{SERVICE}"
                    handler(zeroconf, service, full, ServiceStateChange.Added)

        async def async_cancel(self) -> None: ...

    class Network:
        zeroconf = None

        def __init__(self, **_: Any) -> None: ...

        async def async_close(self) -> None: ...

    monkeypatch.setattr(nearby, "AsyncServiceInfo", Answering)
    monkeypatch.setattr(nearby, "AsyncServiceBrowser", Browser)
    monkeypatch.setattr(nearby, "AsyncZeroconf", Network)
    monkeypatch.setattr(nearby, "MOST", 1)
    there: list[str] = []

    async def look() -> None:
        heard_of = asyncio.Event()

        def told(name: str, _: Announced | None) -> None:
            there.append(name)
            heard_of.set()

        async with nearby.Nearby(told), asyncio.timeout(20):
            await heard_of.wait()

    asyncio.run(look())
    assert there == ["ward at rob1"]


def test_a_robot_that_can_not_be_told_of_takes_nobodys_place(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    wrong = "wrong at rob0"
    there: list[str] = []

    async def look() -> None:
        asked = asyncio.Event()

        class Torn(Answering):
            """Of one the answer can not be read."""

            def parsed_addresses(self, *given: Any) -> list[str]:
                if self.name.startswith(wrong):
                    asked.set()
                    raise ValueError("no addresses")
                return super().parsed_addresses(*given)

        monkeypatch.setattr(nearby, "AsyncServiceInfo", Torn)
        monkeypatch.setattr(nearby, "MOST", 1)
        robots = nearby.Nearby(lambda name, _: there.append(name))

        async def comes(name: str) -> None:
            full = f"{name}.{SERVICE}"
            robots._on_change(Zeroconf.__new__(Zeroconf), SERVICE, full, ServiceStateChange.Added)
            (task,) = robots._asking.values()
            await asyncio.wait({task})
            assert robots._asking == {}
            with contextlib.suppress(ValueError):
                task.result()

        await comes(wrong)
        assert asked.is_set()
        await comes("ward at rob1")

    asyncio.run(look())
    assert there == ["ward at rob1"]


# -- situ robots -------------------------------------------------------------


class Found:
    """In the place of ``Nearby``: three robots, of which one goes again."""

    def __init__(self, told: Any, interfaces: list[str]) -> None:
        assert interfaces == ["127.0.0.1"]
        self._told = told

    async def __aenter__(self) -> Found:
        self._told("desk at rob2", Announced("desk", "rob2", 5570, ("10.0.0.6",), "ab" * 16))
        self._told("ward at rob1", WARD)
        self._told("bed at rob3", WARD)
        self._told("bed at rob3", None)
        return self

    async def __aexit__(self, *_: object) -> None: ...


class Nobody(Found):
    async def __aenter__(self) -> Found:
        return self


class Shut(Found):
    async def __aenter__(self) -> Found:
        raise OSError(1, "Operation not permitted")


ROBOTS = ("robots", "--interface", "127.0.0.1", "--wait", "0.001")


def test_situ_robots_lists_who_is_there_with_what_comes_of_connecting(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(nearby, "Nearby", Found)
    assert main(ROBOTS) == 0
    assert capsys.readouterr().out.splitlines() == [
        "desk at rob2  tcp://10.0.0.6:5570  there is no key for it here",
        "ward at rob1  tcp://10.0.0.5:5570  without keys: open to everybody",
    ]
    assert main([*ROBOTS, "--json"]) == 0
    assert '"standing":"open"' in capsys.readouterr().out.splitlines()[1]


def test_situ_robots_says_that_there_is_nobody_and_what_does_not_go(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(nearby, "Nearby", Nobody)
    assert main(ROBOTS) == 0
    assert capsys.readouterr().out.startswith("no robot announces itself here")
    monkeypatch.setattr(nearby, "Nearby", Shut)
    assert main(ROBOTS) == 2
    said = capsys.readouterr().err
    assert said == "situ: the network can not be listened to: Operation not permitted\n"
