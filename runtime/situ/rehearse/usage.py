"""How often what a robot offers was used, how long, and where people gave up (``situ report``).

The model is Table I of the paper (seed 001), counted from traces: how often each service was used,
by place. A service is a state, or a part, a state that runs another application. A visit lasts from
leaving the application's start state until it is back there.
"""

from __future__ import annotations

import csv
import os
from collections import Counter, deque
from collections.abc import Iterator
from pathlib import Path
from typing import IO, NamedTuple, TextIO

import msgspec
from msgspec import Raw, Struct, field

from situ.document.project import Project
from situ.errors import UsageError
from situ.rehearse import recorded
from situ.rehearse.recorded import Document, Heading, Line
from situ.rehearse.ways import label

PLACE = "pose.place"
"""The tag that says where the robot is, unless another one is told."""
STEP = 5_000
"""Events between two looks at how much is read."""
OFFERING = frozenset({"button", "input", "list"})
"""Components that a person is to use."""


class Row(Struct):
    """What came of one service at one place.

    place: the value of the place's tag when it began; empty where nothing was known. times: how
    often it began; visits: in how many visits, percent: of all visits to that place. seconds: in
    all, mean: each time, both without what was suspended. timeouts: how often its timeout ended it;
    gave_up: how often of these in a visit, while there was something on the screen to be used.
    """

    project: str
    place: str
    application: str
    state: str
    name: str
    kind: str
    times: int = 0
    visits: int = 0
    percent: float = 0.0
    seconds: float = 0.0
    mean: float = 0.0
    timeouts: int = 0
    gave_up: int = 0


class Crossed(NamedTuple):
    """A transition, as it stands in a trace."""

    application: str
    source: str
    to: str
    event: str | None
    timeout: bool


class Lasted(Struct):
    """How often something was so, and how many seconds in all."""

    times: int = 0
    seconds: float = 0.0


class Seen(Struct):
    """What is looked at of a trace event."""

    seq: int
    t: float
    kind: str
    application: str = ""
    state: str = ""
    source: str | None = field(name="from", default=None)
    to: str | None = None
    event: str | None = None
    timeout: bool = False
    tag: str = ""
    value: Raw = Raw(b"null")
    components: list[_Component] = []


class _Component(Struct):
    type: str = ""


class _Key(NamedTuple):
    project: str
    place: str
    application: str
    state: str


class _Application:
    """One application in one run.

    since: of each state that it is in, its row, when it began, and how long the application had
    been suspended by then. visit, places: what this visit has used, and where; None between two.
    """

    def __init__(self, start: str | None) -> None:
        self.start = start
        self.since: dict[str, tuple[Row, float, float]] = {}
        self.rows: dict[str, Row] = {}
        self.visit: set[_Key] | None = None
        self.places: set[str] = set()
        self.offers = False
        self.suspended: float | None = None
        self.idle = 0.0

    def idle_at(self, t: float) -> float:
        return self.idle if self.suspended is None else self.idle + t - self.suspended

    def leave(self, state: str, t: float) -> None:
        row, since, idle = self.since.pop(state)
        row.seconds += t - since - (self.idle_at(t) - idle)


class _Run:
    """One runtime's trace as far as it is known. whole: from its beginning."""

    def __init__(self) -> None:
        self.project: Project | None = None
        self.name = ""
        self.seq = 0
        self.t = 0.0
        self.whole = True
        self.place = ""
        self.applications: dict[str, _Application] = {}
        self.situation: tuple[Lasted, float] | None = None

    def end_situation(self) -> None:
        if self.situation is not None:
            lasted, since = self.situation
            lasted.seconds = round(lasted.seconds + self.t - since, 6)
            self.situation = None

    def lose(self) -> None:
        """What follows is not known: what is begun ends here."""
        self.end_situation()
        for one in self.applications.values():
            for state in list(one.since):
                one.leave(state, self.t)
        self.applications.clear()
        self.whole = False


class Usage:
    """Counts over any number of traces, one event at a time; ``rows`` is what came of it, and
    ``crossed`` and ``situations``, by name, once these were asked for.

    Events that several recordings of one runtime share count once, if the recordings come in
    their order.
    """

    def __init__(self, place: str = PLACE) -> None:
        self._place = place
        self._runs: dict[str, _Run] = {}
        self._run = _Run()
        self._rows: dict[_Key, Row] = {}
        self._visits: Counter[tuple[str, str, str]] = Counter()
        self._parts: set[_Key] = set()
        self.crossed: Counter[Crossed] = Counter()
        self.situations: dict[str, Lasted] = {}

    def begin(self, name: str, project: Project | None = None, runtime: str = "") -> None:
        """Another trace. name: of what ran; runtime: empty where it is a run of its own."""
        self._run = self._runs.setdefault(runtime or f"trace {len(self._runs)}", _Run())
        self._run.name, self._run.project = name, project

    def add(self, seen: Seen) -> None:
        """The next event."""
        run = self._run
        if seen.seq <= run.seq:
            return
        if seen.seq != run.seq + 1:
            run.lose()
        run.seq, run.t = seen.seq, seen.t
        count = _COUNT.get(seen.kind)
        if count is not None:
            count(self, run, seen)

    def rows(self) -> list[Row]:
        """By project, place, application and state, in the order in which they came; all that is
        still going on ends with its trace."""
        for run in self._runs.values():
            run.lose()
        for key, row in self._rows.items():
            visits = self._visits[key[:3]]
            row.percent = round(100 * row.visits / visits, 1) if visits else 0.0
            row.seconds = round(row.seconds, 3)
            row.mean = round(row.seconds / row.times, 3)
            row.kind = "part" if key in self._parts else "state"
        return sorted(self._rows.values(), key=lambda r: (r.project, r.place, r.application))

    # -- the kinds that count ------------------------------------------------

    def _data(self, run: _Run, seen: Seen) -> None:
        if seen.tag == self._place:
            value = msgspec.json.decode(seen.value)
            told = value if isinstance(value, str) else bytes(seen.value).decode()
            run.place = "" if value is None else told

    def _enter(self, run: _Run, seen: Seen) -> None:
        one = self._application(run, seen)
        if one.start is None and run.whole:
            # The first state that a trace from its beginning enters.
            one.start = seen.state
        key = _Key(run.name, run.place, seen.application, seen.state)
        if (row := self._rows.get(key)) is None:
            row = self._rows[key] = Row(*key, _name(run, seen), "state")
        row.times += 1
        one.since[seen.state] = row, seen.t, one.idle_at(seen.t)
        one.rows[seen.state] = row
        above = seen.state.rpartition("/")[0]
        if above in one.rows:
            held = one.rows[above]
            self._parts.add(_Key(held.project, held.place, held.application, held.state))
        if seen.state.partition("/")[0] == one.start:
            one.visit = None
            return
        if one.visit is None:
            one.visit, one.places = set(), set()
        if run.place not in one.places:
            one.places.add(run.place)
            self._visits[key[:3]] += 1
        if key not in one.visit:
            one.visit.add(key)
            row.visits += 1

    def _exit(self, run: _Run, seen: Seen) -> None:
        one = self._application(run, seen)
        if seen.state in one.since:
            one.leave(seen.state, seen.t)

    def _transition(self, run: _Run, seen: Seen) -> None:
        one = self._application(run, seen)
        ends = seen.source or "", seen.to or ""
        self.crossed[Crossed(seen.application, *ends, seen.event, seen.timeout)] += 1
        if seen.timeout and seen.source in one.rows:
            row = one.rows[seen.source]
            row.timeouts += 1
            row.gave_up += one.offers and one.visit is not None

    def _situation(self, run: _Run, seen: Seen) -> None:
        run.end_situation()
        if seen.to is not None:
            lasted = self.situations.setdefault(seen.to, Lasted())
            lasted.times += 1
            run.situation = lasted, seen.t

    def _screen(self, run: _Run, seen: Seen) -> None:
        one = self._application(run, seen)
        one.offers = any(component.type in OFFERING for component in seen.components)

    def _suspend(self, run: _Run, seen: Seen) -> None:
        one = self._application(run, seen)
        one.idle, one.suspended = one.idle_at(seen.t), seen.t

    def _resume(self, run: _Run, seen: Seen) -> None:
        one = self._application(run, seen)
        one.idle, one.suspended = one.idle_at(seen.t), None

    def _application(self, run: _Run, seen: Seen) -> _Application:
        name = seen.application
        if name not in run.applications:
            every = run.project.applications.values() if run.project is not None else ()
            start = next((one.start_no for one in every if one.name == name), None)
            run.applications[name] = _Application(start)
        return run.applications[name]


_COUNT = {
    "data": Usage._data,
    "enter": Usage._enter,
    "exit": Usage._exit,
    "transition": Usage._transition,
    "screen": Usage._screen,
    "situation": Usage._situation,
    "suspend": Usage._suspend,
    "resume": Usage._resume,
}


def _name(run: _Run, seen: Seen) -> str:
    """The state's label; empty without a project."""
    return "" if run.project is None else label(run.project, seen.application, seen.state)


def write_csv(rows: list[Row], out: TextIO) -> None:
    """One line a row, below the names of its fields."""
    table = csv.writer(out, lineterminator="\n")
    table.writerow(Row.__struct_fields__)
    table.writerows(msgspec.structs.astuple(row) for row in rows)


def count(usage: Usage, path: str | Path, project: Project | None = None) -> None:
    """As ``counting``, to the end."""
    deque(counting(usage, path, project), maxlen=0)


def counting(usage: Usage, path: str | Path, project: Project | None = None) -> Iterator[float]:
    """Adds a recording (MCAP) or a trace of JSON lines, event by event, and tells after each
    ``STEP`` of them how much of the file is read, from 0 to 1.

    project: what ran, where the file itself does not hold it. Raises UsageError where it can not
    be read or is neither.
    """
    try:
        with open(path, "rb") as file:
            size = max(os.fstat(file.fileno()).st_size, 1)
            is_recording = recorded.is_recording(file.read(len(recorded.MAGIC)))
            file.seek(0)
            add = _count_recording if is_recording else _count_lines
            for _ in add(usage, file, path, project):
                yield min(file.tell() / size, 1.0)
    except (OSError, ValueError) as error:
        raise UsageError(f"{path}: {getattr(error, 'strerror', None) or error}") from None


def _count_lines(
    usage: Usage, file: IO[bytes], path: str | Path, project: Project | None
) -> Iterator[None]:
    usage.begin(project.name if project is not None else "", project)
    last = 0
    for number, line in enumerate(iter(file.readline, b""), 1):
        if line.strip():
            try:
                seen = _decode(line)
            except (msgspec.DecodeError, UnicodeDecodeError) as error:
                raise UsageError(f"{path}:{number}: not an event of a trace: {error}") from None
            if seen.seq <= last:
                raise UsageError(
                    f"{path}:{number}: seq {seen.seq} after {last}: give one run's trace"
                )
            last = seen.seq
            usage.add(seen)
        if number % STEP == 0:
            yield


def _count_recording(
    usage: Usage, file: IO[bytes], path: str | Path, project: Project | None
) -> Iterator[None]:
    heading, documents = Heading(), []
    begun = False
    for number, piece in enumerate(recorded.pieces(file, str(path)), 1):
        if isinstance(piece, Heading):
            heading = piece
        elif isinstance(piece, Document):
            documents.append(piece)
        elif isinstance(piece, Line):
            if not begun:
                held = project or recorded.loaded(heading, documents)
                usage.begin(heading.project, held, heading.runtime)
                begun = True
            try:
                usage.add(_decode(piece.text))
            except msgspec.DecodeError as error:
                raise UsageError(f"{path}: not an event of a trace: {error}") from None
        if number % STEP == 0:
            yield


_decode = msgspec.json.Decoder(Seen).decode
