"""Durable tags: what is kept of them, and when it is acknowledged (formats.md, ``[durable]``)."""

from __future__ import annotations

import contextlib
import queue
import resource
import shutil
import sqlite3
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import msgspec
import pytest

from situ.blackboard.core import Held, Outgoing
from situ.blackboard.journal import FILE, Durable, DurableTags, patterns
from situ.decide.effects import Changed
from situ.document.project import Project, Setting
from situ.errors import UsageError

DEADLINE = 20.0


def changed(tag: str, value: Any, version: int, writer: str = "nod") -> Changed:
    return Changed(tag, value, version, writer, 0)


def kept(store: DurableTags, *changes: Changed) -> str | None:
    """Keeps the changes together and waits; why they could not be, or None."""
    told: queue.Queue[str | None] = queue.Queue()
    store.keep(changes, told.put)
    return told.get(timeout=DEADLINE)


@contextlib.contextmanager
def opened(folder: Path, *patterns: str, **options: Any) -> Iterator[DurableTags]:
    store = DurableTags(folder, patterns or ("pill.*",), **options)
    try:
        yield store
    finally:
        store.close()


@pytest.mark.parametrize("sync", [False, True])
def test_what_was_kept_is_there_when_the_process_is_gone(tmp_path: Path, sync: bool) -> None:
    dead = tmp_path / "dead"
    dead.mkdir()
    with opened(tmp_path, sync=sync) as store:
        value = {"at": "08:00", "n": [1, 2.5, 10**30, None, "é"]}
        assert kept(store, changed("pill.a", value, 3), changed("pill.b", True, 1, "x")) is None
        # The files as they lie there while it still runs: so a kill would leave them.
        for file in tmp_path.glob(f"{FILE}*"):
            shutil.copy(file, dead)
    with opened(dead) as again:
        assert again.restored == {"pill.a": (value, 3, "nod"), "pill.b": (True, 1, "x")}


@pytest.mark.parametrize(("sync", "level"), [(False, "NORMAL"), (True, "FULL")])
def test_only_with_sync_the_disk_is_waited_for(tmp_path: Path, sync: bool, level: str) -> None:
    # SQLite's documentation: in WAL mode FULL alone syncs each commit.
    with opened(tmp_path, sync=sync) as store:
        ((found,),) = store._db.execute("PRAGMA synchronous")
    assert ("OFF", "NORMAL", "FULL")[found] == level


def test_the_last_version_counts_and_a_deletion_is_kept(tmp_path: Path) -> None:
    with opened(tmp_path) as store:
        kept(store, changed("pill.a", 1, 1), changed("pill.b", 1, 1), changed("pill.a", 2, 2))
        kept(store, changed("pill.b", None, 2))
    with opened(tmp_path) as again:
        assert again.restored == {"pill.a": (2, 2, "nod"), "pill.b": (None, 2, "nod")}


def test_closing_keeps_what_still_waits(tmp_path: Path) -> None:
    told: list[str | None] = []
    with opened(tmp_path) as store:
        for version in range(1, 201):
            store.keep([changed("pill.a", version, version)], told.append)
    assert told == [None] * 200
    with opened(tmp_path) as again:
        assert again.restored["pill.a"] == (200, 200, "nod")


def test_what_is_durable_no_longer_is_not_restored(tmp_path: Path) -> None:
    with opened(tmp_path, "pill.*", "lamp") as store:
        kept(store, changed("pill.a", 1, 1), changed("lamp", "on", 1))
    with opened(tmp_path, "lamp") as again:
        assert again.restored == {"lamp": ("on", 1, "nod")}


def test_what_the_runtime_itself_keeps_is_never_durable() -> None:
    durable = Durable(["**"])
    kept_by_us = ("situation", "listen", "clock.time", "robot/head", "module/m/head")
    assert [tag for tag in kept_by_us if durable[tag]] == []
    assert durable["pill.a"]
    assert durable["service/find"]


def test_what_settings_change_is_durable_too() -> None:
    settings = (Setting("morning", "Morning round", "time"),)
    project = Project(root=".", name="ward", durable=("pill.*",), settings=settings)
    assert patterns(project) == ("pill.*", "morning")


def test_the_file_is_nobody_else_s_to_read(tmp_path: Path) -> None:
    with opened(tmp_path) as store:
        kept(store, changed("pill.a", 1, 1))
        modes = {file.name: file.stat().st_mode & 0o777 for file in tmp_path.iterdir()}
    assert modes == {FILE: 0o600, f"{FILE}-wal": 0o600}


def test_a_damaged_file_is_set_aside_and_told(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    (tmp_path / FILE).write_bytes(b"no database " * 1000)
    with opened(tmp_path) as store:
        assert store.restored == {}
        assert kept(store, changed("pill.a", 1, 1)) is None
    (said,) = caplog.messages
    assert f"{tmp_path / FILE}: file is not a database; it is set aside" in said
    assert (tmp_path / f"{FILE}.damaged-1").read_bytes().startswith(b"no database")
    assert not (tmp_path / f"{FILE}.damaged-2").exists()


def test_a_file_with_a_torn_page_is_set_aside_too(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    with opened(tmp_path) as store:
        kept(store, *(changed(f"pill.p{n}", "x" * 500, 1) for n in range(100)))
    file = tmp_path / FILE
    data = bytearray(file.read_bytes())
    data[8192:12288] = b"\xff" * 4096
    file.write_bytes(data)
    with opened(tmp_path) as again:
        assert again.restored == {}
    assert "is set aside" in caplog.text


def test_a_value_that_can_not_be_read_costs_only_its_own_tag(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    with opened(tmp_path) as store:
        kept(store, changed("pill.a", 1, 1), changed("pill.b", 2, 1))
    with contextlib.closing(sqlite3.connect(tmp_path / FILE)) as db, db:
        db.execute("UPDATE entries SET value = '{' WHERE tag = 'pill.a'")
    with opened(tmp_path) as again:
        assert again.restored == {"pill.b": (2, 1, "nod")}
    assert "pill.a can not be read" in caplog.text


@pytest.mark.parametrize(
    ("script", "said"),
    [("BEGIN EXCLUSIVE", "database is locked"), ("PRAGMA user_version = 2", "by a newer situ")],
)
def test_what_is_not_damage_is_refused_and_left_alone(
    tmp_path: Path, script: str, said: str
) -> None:
    with opened(tmp_path) as store:
        kept(store, changed("pill.a", 1, 1))
    with contextlib.closing(sqlite3.connect(tmp_path / FILE, isolation_level=None)) as db:
        db.execute("PRAGMA journal_mode = DELETE")
        db.execute(script)
        with pytest.raises(UsageError, match=said):
            DurableTags(tmp_path, ["pill.*"])
    assert [file.name for file in tmp_path.glob("*damaged*")] == []


def test_what_a_full_disk_refused_is_kept_when_there_is_room_again(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    with opened(tmp_path) as store:
        kept(store, changed("pill.a", 1, 1))
        resource.setrlimit(resource.RLIMIT_FSIZE, (40_000, before[1]))
        try:
            why = kept(store, changed("pill.a", "x" * 100_000, 2))
            assert kept(store, changed("pill.b", "x" * 100_000, 1)) is not None
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, before)
        assert why is not None
        assert kept(store, changed("pill.c", 1, 1)) is None
    with opened(tmp_path) as again:
        versions = {tag: version for tag, (_, version, _) in again.restored.items()}
    assert versions == {"pill.a": 2, "pill.b": 1, "pill.c": 1}
    # Told once when it begins, and once when it is over.
    first, last = caplog.messages
    assert first.endswith("; durable tags are not kept")
    assert last.endswith(": durable tags are kept again")


# -- in a core ---------------------------------------------------------------------


class Room:
    """Stands in for the disk."""

    def __init__(self) -> None:
        self.durable = Durable(["pill.*", "visits"])
        self.full = False

    def refusal(self, tags: Any) -> str | None:
        return "the disk is full" if self.full and any(self.durable[t] for t in tags) else None


@pytest.fixture
def room() -> Room:
    return Room()


@pytest.fixture
def desk(room: Room, make_hand: Callable[..., Any]) -> Any:
    hand = make_hand(durability=room)
    hand.hello("ann", role="operator", user="ann")
    return hand


def said(hand: Any, *requests: dict[str, Any]) -> Outgoing:
    """What leaves after requests that came together."""
    for request in requests:
        hand.sessions.receive("ann", msgspec.json.encode(request), hand.now)
    out: Outgoing = hand.sessions.take()
    return out


def set_(number: int, **tags: Any) -> dict[str, Any]:
    return {"do": "set", "id": number, "tags": {t.replace("_", "."): v for t, v in tags.items()}}


def test_only_what_acknowledges_durable_tags_waits_and_goes_together(desk: Any) -> None:
    out = said(desk, set_(1, pill_a=1), set_(2, lamp=1), set_(3, pill_b=2, lamp=2))
    assert [msgspec.json.decode(body)["id"] for _, body in out.replies] == [2]
    assert [held.request for held in out.held] == [1, 3]
    assert [(c.tag, c.value, c.version, c.writer) for c in out.durable] == [
        ("pill.a", 1, 1, "operator:ann"),
        ("pill.b", 2, 1, "operator:ann"),
    ]


def test_a_deletion_is_kept_and_one_of_nothing_needs_no_keeping(desk: Any) -> None:
    assert said(desk, set_(1, pill_a=None)).held == []
    said(desk, set_(2, pill_a=1))
    out = said(desk, set_(3, pill_a=None))
    assert [(c.value, c.version) for c in out.durable] == [(None, 2)]
    assert len(out.held) == 1


def test_on_a_full_disk_nothing_is_set_and_the_rest_goes_on(desk: Any, room: Room) -> None:
    room.full = True
    refused = desk.ask("ann", "set", tags={"lamp": 1, "pill.a": 1})
    assert (refused["re"], refused["code"], refused["message"]) == (
        "refused",
        "refused",
        "the disk is full",
    )
    assert desk.ask("ann", "set", tags={"lamp": 2})["versions"] == {"lamp": 1}


def test_what_could_not_be_kept_after_all_is_no_acknowledgement() -> None:
    reply = msgspec.json.decode(Held("ann", b"written", 7).no("disk I/O error"))
    assert (reply["re"], reply["id"], reply["code"]) == ("refused", 7, "refused")
    assert "disk I/O error" in reply["message"]
    assert "set it again" in reply["message"]


def test_what_applications_set_is_kept_too(desk: Any) -> None:
    out = said(desk, {"do": "publish", "id": 1, "event": "go"})
    assert [(c.tag, c.value, c.writer) for c in out.durable] == [("visits", 1, "desk")]
    # Nobody is told that it is kept.
    assert (len(out.replies), out.held) == (1, [])


def test_tags_of_the_project_and_what_is_restored_are_not_kept_once_more(
    lab: Any, make_hand: Callable[..., Any], room: Room
) -> None:
    room.durable = Durable(["**"])
    hand = make_hand(durability=room, begin=False)
    hand.sessions.start(restored={"pill.a": (1, 4, "nod"), "pill.b": (None, 2, "nod")})
    assert lab.tags
    assert hand.sessions.take().durable == []
    hand.hello("ann", role="operator", user="ann")
    assert [c.version for c in said(hand, set_(1, pill_a=2)).durable] == [5]


def test_the_room_is_looked_at_only_for_durable_tags(tmp_path: Path) -> None:
    asked: list[Path] = []

    def free(folder: Path) -> int:
        asked.append(folder)
        return 999_999

    with opened(tmp_path, free=free) as store:
        assert store.refusal(["lamp", "x"]) is None
        assert asked == []
        words = store.refusal(["lamp", "pill.a"])
        assert words is not None
        assert words.startswith("pill.a is durable and can not be kept: the disk of ")
        assert asked == [tmp_path]
