"""Automatic layout: asked for, or for files without positions.

The usual way through an application runs from left to right on the grid of
mockups/tokens.md (columns 230 apart, rows 228) and wraps into bands, as text
does, so that a long application fits a window. Pure; no Qt.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from msgspec import Struct

from situ.document.rbd import Always, Application, State
from situ_studio.canvas.picture import COLUMN, FIRST, PITCH, ROW, WIDTH
from situ_studio.canvas.projection import identified, targets

BAND = 6
"""Columns side by side before the way goes on below."""
LEFT, TOP = 24.0, 52.0
GAP = ROW - 116.0
ABOVE = 48.0
"""Between the card of what every state has and the first row."""


class Shape(Struct, frozen=True):
    """All that the layout looks at. heights: of every card, in order. above: of no state.
    leads: where each leads in the usual way of things, not to itself.
    """

    heights: dict[str, float]
    leads: dict[str, list[str]]
    above: list[str]
    start: str | None


def arrange(application: Application) -> dict[str, tuple[float, float]]:
    """A place for every card, by uid; no two overlap. Ends for any graph, circles included."""
    return place(shape(application))


def shape(application: Application) -> Shape:
    cards = list(identified(application))
    by_no: dict[str, str] = {}
    for uid, value in cards:
        number = getattr(value, "no", None)
        if number is not None:
            by_no.setdefault(number, uid)
    heights = {uid: _height(value) for uid, value in cards}
    leads: dict[str, list[str]] = {
        uid: list(
            dict.fromkeys(
                by_no[t] for t in _forward(value, targets(value)) if t in by_no and by_no[t] != uid
            )
        )
        for uid, value in cards
    }
    above = [uid for uid, value in cards if not hasattr(value, "no")]
    return Shape(heights, leads, above, by_no.get(application.start_no or ""))


def place(shape: Shape, band: int = BAND) -> dict[str, tuple[float, float]]:
    """band: columns side by side."""
    heights, leads = shape.heights, shape.leads
    states = [uid for uid in heights if uid not in shape.above]
    ranks = _ranks(states, leads, shape.start)
    placed: dict[str, tuple[float, float]] = {}
    top = TOP
    for uid in shape.above:
        placed[uid] = (LEFT, top)
        top += heights[uid] + ABOVE
    lanes: dict[int, list[str]] = {}
    for uid in states:
        lanes.setdefault(ranks[uid], []).append(uid)
    order = sorted(lanes)
    for begin in range(0, len(order), band):
        columns = [lanes[r] for r in order[begin : begin + band]]
        columns = _untangle(columns, leads)
        rows = max(len(c) for c in columns)
        depths = [
            max((heights[c[i]] for c in columns if i < len(c)), default=0) for i in range(rows)
        ]
        for index, column in enumerate(columns):
            y = top
            for row, uid in enumerate(column):
                placed[uid] = (LEFT + index * COLUMN, y)
                y += depths[row] + GAP
        top += sum(d + GAP for d in depths)
    return placed


def _forward(value: object, every: list[str]) -> list[str]:
    """Without the timeout's target: where people are taken back to says little about the way."""
    timeout = getattr(value, "timeout", None)
    if timeout is not None and timeout.next is not None and len(every) > 1:
        return every[:-1]
    return every


def _ranks(states: list[str], leads: Mapping[str, list[str]], start: str | None) -> dict[str, int]:
    """Steps from the start along the way, without what closes a circle; then the unreached."""
    inner: dict[str, list[str]] = {uid: [] for uid in states}
    seen: dict[str, int] = {}
    order: list[str] = []
    roots = [start, *states] if start is not None and start in inner else states
    for root in roots:
        if root in seen:
            continue
        # Depth first without recursion: 1 while on the path, 2 when done.
        stack: list[tuple[str, int]] = [(root, 0)]
        seen[root] = 1
        while stack:
            uid, at = stack.pop()
            if at < len(leads[uid]):
                stack.append((uid, at + 1))
                follower = leads[uid][at]
                if seen.get(follower) == 1:
                    continue
                inner[uid].append(follower)
                if follower not in seen:
                    seen[follower] = 1
                    stack.append((follower, 0))
            else:
                seen[uid] = 2
                order.append(uid)
    ranks = dict.fromkeys(states, 0)
    for uid in reversed(order):
        for follower in inner[uid]:
            ranks[follower] = max(ranks[follower], ranks[uid] + 1)
    return ranks


def _untangle(columns: list[list[str]], leads: Mapping[str, list[str]]) -> list[list[str]]:
    """Each column in the order of what leads to it (barycentres, one sweep)."""
    done: list[list[str]] = []
    for index, column in enumerate(columns):
        if index:
            height = {uid: i for i, uid in enumerate(done[-1])}
            sources: dict[str, list[int]] = {}
            for uid in done[-1]:
                for follower in leads[uid]:
                    sources.setdefault(follower, []).append(height[uid])
            old = {uid: i for i, uid in enumerate(column)}
            column = sorted(
                column,
                key=lambda u: (
                    sum(sources[u]) / len(sources[u]) if u in sources else old[u],
                    old[u],
                ),
            )
        done.append(column)
    return done


def missing(
    application: Application, laid: Mapping[str, tuple[float, float]]
) -> dict[str, tuple[float, float]]:
    """Places for the cards that have none, neither in the file nor in ``laid``; by uid.

    All of them by the automatic layout where no card has a place, else below the others,
    and what every state has above them.
    """
    cards = list(identified(application))
    wanted = [u for u, v in cards if v.aside.position is None and u not in laid]
    if not wanted:
        return {}
    if not laid and all(v.aside.position is None for _, v in cards):
        return arrange(application)
    taken = [
        (*at, WIDTH, _height(value))
        for uid, value in cards
        if (at := value.aside.position or laid.get(uid)) is not None
    ]
    left = min((x for x, _, _, _ in taken), default=LEFT)
    top = min((y for _, y, _, _ in taken), default=TOP)
    below = max((y + h for _, y, _, h in taken), default=0.0) + GAP / 2
    placed: dict[str, tuple[float, float]] = {}
    for uid, value in cards:
        if uid not in wanted:
            continue
        if not hasattr(value, "no"):
            placed[uid] = (left, top - _height(value) - ABOVE)
            continue
        placed[uid] = beside(taken, left, below, _height(value))
        taken.append((*placed[uid], WIDTH, _height(value)))
    return placed


def _height(value: Always | State) -> float:
    return 62 + PITCH * max(3, len(value.events) + (value.timeout is not None))


def beside(
    taken: Iterable[tuple[float, float, float, float]],
    x: float,
    y: float,
    height: float = 116.0,
) -> tuple[float, float]:
    """A free place near x, y: there, else to the right and below. taken: x, y, width, height."""
    boxes = list(taken)

    def free(at_x: float, at_y: float) -> bool:
        return not any(
            at_x < bx + bw + 16
            and bx < at_x + WIDTH + 16
            and at_y < by + bh + 16
            and by < at_y + height + 16
            for bx, by, bw, bh in boxes
        )

    for ring in range(40):
        for across in range(ring + 1):
            spot = (x + across * COLUMN, y + (ring - across) * ROW)
            if free(*spot):
                return spot
    return x, y + 41 * ROW


def entry(x: float, y: float) -> tuple[float, float]:
    """The corner of a card whose input lies at x, y: what is dropped there meets the cursor."""
    return x, y - FIRST
