"""The trace log: every event, and the robot as it was at any moment of it.

Fed by the live link, by recordings and rehearsals: all speak the same trace. No Qt, no clock: time
is the trace's own ``t``. Events are kept packed, some hundred in a block, each block with the
moment before its first event, packed too; so a moment costs the events of one block at most.
"""

from __future__ import annotations

import math
from array import array
from bisect import bisect_left, bisect_right
from collections.abc import Collection, Iterable, Iterator, Mapping
from itertools import compress
from typing import Any, overload

import msgspec
import zstandard
from msgspec import Struct

from situ.rehearse.clock import Hidden
from situ_studio.live import lanes, moment
from situ_studio.live.clock_seen import ClockSeen
from situ_studio.live.lanes import Lanes
from situ_studio.live.moment import Moment, TraceFields

BLOCK = 500
"""Events in a block: what one moment of the past costs at most, about 1 ms."""
LIMIT = 2_000_000
"""Events that are kept, about 90 MB."""
FORGOTTEN = 64
"""Parts of the limit, of which the oldest is forgotten at once: each time much is moved."""

KINDS = (
    "data", "condition", "situation", "acquire", "abandon", "lost", "connected", "authority",
    "mapping", "event", "ignored", "exit", "enter", "transition", "screen", "action", "finished",
    "cancelled", "suspend", "resume", "paused", "resumed", "deployed", "warning", "error",
)  # fmt: skip
"""Of events (formats.md, *Trace*)."""
_CODES = {kind: code for code, kind in enumerate(KINDS, 1)}

_pack = zstandard.ZstdCompressor(level=1)
_unpack = zstandard.ZstdDecompressor()
_decode = msgspec.json.Decoder(TraceFields).decode


def _packed(data: bytes) -> bytes:
    # What the library gives holds the room that the worst case needs: several times as much.
    return memoryview(_pack.compress(data)).tobytes()


class _Block(Struct, frozen=True):
    """BLOCK events, and what the robot was like before them."""

    begun: bytes
    packed: bytes

    def before(self) -> Moment:
        return moment.unpacked(_unpack.decompress(self.begun))

    def events(self) -> list[TraceFields]:
        return [_decode(line) for line in _unpack.decompress(self.packed).split(b"\n")]


class Gap(Struct, frozen=True):
    """Events that did not come, ``count`` of them: after ``t`` and before ``to``."""

    t: float
    to: float
    count: int


class TraceLog:
    """A sequence of trace events, as they came; ``limit`` and some are kept.

    Events come in order of ``seq``; one that was seen before is passed over, so that a link that
    came back may send its backlog again. Time does not go back: an event that says so counts as of
    the one before. ``now`` is the robot after the last and knows of all, ``lanes`` is everything
    over time.
    """

    def __init__(self, limit: int = LIMIT, block: int = BLOCK) -> None:
        self._limit, self._size = limit, block
        self.clear()

    def clear(self) -> None:
        """Another run of the runtime: its ``seq`` begins anew."""
        self.now = self._told = Moment()
        self.lanes = Lanes()
        self._blocks: list[_Block] = []
        self._open: list[TraceFields] = []
        self._lines: list[bytes] = []
        self._open_before = Moment()
        self._times: array[float] = array("d")
        self._codes = bytearray()
        self._firsts: list[int] = []
        # By tag and time: a link that came back tells most of it again.
        self._standing: dict[tuple[str, float], tuple[Any, str | None]] = {}
        self.clock = ClockSeen()
        self._seq = 0
        self.gone = 0
        """How many of the first are not kept any more."""
        self.late = 0
        """How many were before the first that came."""
        self.gaps: list[Gap] = []
        """What did not come between two that did, as far as they are kept."""
        self._unpacked: tuple[int, list[TraceFields]] = (-1, [])
        self._shown: tuple[int, Moment] = (-1, self.now)

    @property
    def seq(self) -> int:
        """The seq of the last event; 0 before the first."""
        return self._seq

    # -- what comes in ---------------------------------------------------------------

    def add(self, events: Iterable[TraceFields]) -> list[TraceFields]:
        """Takes what is new and gives it back."""
        seq, new = self._seq, []
        for event in events:
            if event["seq"] > seq:
                seq = event["seq"]
                new.append(event)
        self._take(zip(new, map(msgspec.json.encode, new), strict=True))
        return new

    def add_lines(self, lines: Iterable[bytes]) -> bool:
        """Takes events as JSON, one each, up to the first whose ``seq`` is below that of the one
        before: False where there is one, for it is of another run.

        Raises msgspec.DecodeError, and KeyError where a field is missing; the log is of no use
        then.
        """
        return self._take((_decode(line), line) for line in lines)

    def _take(self, pairs: Iterable[tuple[TraceFields, bytes]]) -> bool:
        # A million of them come at once: what is the same for all is looked up once.
        seq, now, told, over_time = self._seq, self.now, self._told, self.lanes
        on_moment, on_lanes, code = moment.ACCEPT.get, lanes.TAKE.get, _CODES.get
        begins = not self._times
        t = -math.inf if begins else self._times[-1]
        whole = True
        for event, line in pairs:
            before = seq + 1
            if event["seq"] == seq:
                continue
            if event["seq"] < seq:
                whole = False
                break
            if event["t"] < t:
                event = {**event, "t": t}
                line = msgspec.json.encode(event)
            if event["seq"] > before:
                self._miss(Gap(t, event["t"], event["seq"] - before))
            seq, kind, t = event["seq"], event["kind"], event["t"]
            accept = on_moment(kind)
            if accept is not None:
                accept(now, event)
                if told is not now:
                    accept(told, event)
            take = on_lanes(kind)
            if take is not None:
                take(over_time, event)
            self._times.append(t)
            self._codes.append(code(kind, 0))
            self._open.append(event)
            self._lines.append(line)
            if len(self._open) == self._size:
                self._come_to(seq, t)
                self._close()
        if self._times:
            self._come_to(seq, t)
        if begins and self._times:
            self.lanes.start = self._times[0]
        return whole

    def _miss(self, gap: Gap) -> None:
        if self._times:
            self.gaps.append(gap)
        else:
            self.late = gap.count

    def _come_to(self, seq: int, t: float) -> None:
        self._seq, self.now.t, self._told.t, self.lanes.end = seq, t, t, t

    def _close(self) -> None:
        """The open block is full: it is packed."""
        lines = b"\n".join(self._lines)
        if lines.count(b"\n") >= len(self._lines):
            # JSON may have line breaks, if ours has none.
            lines = b"\n".join(map(msgspec.json.encode, self._open))
        self._firsts.append(self._open[0]["seq"])
        before = moment.packed(self._open_before)
        self._blocks.append(_Block(_packed(before), _packed(lines)))
        self._open, self._lines, self._open_before = [], [], self._told.copy()
        many = max(1, self._limit // self._size // FORGOTTEN)
        if len(self._times) > self._limit + many * self._size:
            self._forget(many)

    def _forget(self, blocks: int) -> None:
        """The oldest go, and the cursor's places go down by as many events."""
        events = blocks * self._size
        del self._blocks[:blocks]
        del self._firsts[:blocks]
        del self._times[:events]
        del self._codes[:events]
        self.gone += events
        self.late += sum(gap.count for gap in self.gaps if gap.to <= self._times[0])
        self.gaps = [gap for gap in self.gaps if gap.to > self._times[0]]
        self.lanes.forget(self._times[0])
        self._unpacked, self._shown = (-1, []), (-1, self.now)

    def stand(self, entries: Mapping[str, tuple[Any, str | None, float]]) -> None:
        """What stands on the blackboard: tag to (value, writer, time in seconds).

        Fills in what the trace does not tell: the runtime's own tags, and all that was written
        before the events that are still to be had.
        """
        if self._told is self.now:
            self._told = self.now.copy()
        for tag, (value, writer, t) in entries.items():
            self._standing[tag, t] = (value, writer)
            self.now.stand(tag, value, writer, t)
            self.lanes.stand(tag, value, writer, t)

    def keep_clock(self, writes: Iterable[Hidden]) -> None:
        """Writes of ``clock.…``, which no trace tells."""
        self.clock.add(writes)
        self.clock.put(self.now, math.inf)

    @property
    def lacks(self) -> int:
        """How many events were before the first that is kept."""
        return self.late + self.gone

    @property
    def unknown(self) -> list[Gap]:
        """All stretches of time of which events are not known, the beginning too."""
        lacks = self.lacks
        return [*([Gap(-math.inf, self.lanes.start, lacks)] if lacks else []), *self.gaps]

    # -- what there is ---------------------------------------------------------------

    def __len__(self) -> int:
        return len(self._times)

    @overload
    def __getitem__(self, index: int) -> TraceFields: ...

    @overload
    def __getitem__(self, index: slice) -> list[TraceFields]: ...

    def __getitem__(self, index: int | slice) -> TraceFields | list[TraceFields]:
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        place = index if index >= 0 else len(self) + index
        if not 0 <= place < len(self):
            raise IndexError(index)
        return self._block(place // self._size)[place % self._size]

    def __iter__(self) -> Iterator[TraceFields]:
        for number in range(len(self._blocks) + 1):
            yield from self._block(number)

    def time(self, index: int) -> float:
        """When the event of that place happened."""
        return self._times[index]

    def place(self, seq: int) -> int | None:
        """Where the event of that seq is; None where it is not kept. Blocks are looked into only
        where some of theirs never came.
        """
        begins = [self._open[0]["seq"]] if self._open else []
        number = bisect_right(self._firsts, seq) - 1
        if begins and seq >= begins[0]:
            number = len(self._blocks)
        if number < 0 or seq > self._seq:
            return None
        starts = [*self._firsts[number : number + 2], *begins, self._seq + 1]
        first, behind = int(starts[0]), int(starts[1])
        begun = number * self._size
        if behind - first == min(self._size, len(self) - begun):
            return begun + seq - first
        block = self._block(number)
        near = bisect_left(block, seq, key=_seq_of)
        return begun + near if near < len(block) and block[near]["seq"] == seq else None

    def kind(self, place: int) -> str:
        """The kind of the event there, without looking at it; "" where it is none of ``KINDS``."""
        code = self._codes[place]
        return KINDS[code - 1] if code else ""

    def of_kinds(self, kinds: Collection[str], since: int = 0) -> array[int]:
        """The places of all events of these kinds, from ``since`` on."""
        wanted = bytearray(256)
        for kind in kinds:
            wanted[_CODES[kind]] = 1
        mask = self._codes[since:].translate(wanted)
        return array("L", compress(range(since, len(self)), mask))

    def count(self, t: float) -> int:
        """How many of the kept events had happened at ``t``."""
        return bisect_right(self._times, t)

    def earlier(self, t: float) -> int:
        """How many of the kept events had happened before ``t``."""
        return bisect_left(self._times, t)

    def at(self, t: float) -> Moment:
        """The robot as it was at ``t``, all events of that time included. Not to be changed.

        Before the first event that is kept it is as before that.
        """
        return self.after(self.count(t))

    def after(self, count: int) -> Moment:
        """The robot after so many of the kept events."""
        if count >= len(self):
            return self.now
        number = count // self._size
        begun = number * self._size
        shown, then = self._shown
        if begun <= shown <= count:
            begun = shown
        else:
            then = self._before(number)
        if begun < count:
            then = then.copy()
            for event in self._block(number)[begun % self._size : count % self._size]:
                then.take(event)
        self._shown = (count, then)
        return self._with_standing(then)

    def _with_standing(self, then: Moment) -> Moment:
        """With what the trace does not tell but stood there by then."""
        told = [(at, s) for at, s in self._standing.items() if at[1] <= then.t]
        if not told and not self.clock:
            return then
        whole = then.copy()
        self.clock.put(whole, then.t)
        for (tag, t), (value, writer) in told:
            whole.stand(tag, value, writer, t)
        return whole

    def _before(self, number: int) -> Moment:
        last = number == len(self._blocks)
        return self._open_before if last else self._blocks[number].before()

    def _block(self, number: int) -> list[TraceFields]:
        if number == len(self._blocks):
            return self._open
        if self._unpacked[0] != number:
            self._unpacked = (number, self._blocks[number].events())
        return self._unpacked[1]


def _seq_of(event: TraceFields) -> int:
    return int(event["seq"])
