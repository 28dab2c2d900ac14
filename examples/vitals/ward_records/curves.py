"""What was measured as a curve: SVG in the page, without a script; its words are HTML beside it,
so that they keep their size on a narrow screen."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape

from ward_records.language import say
from ward_records.store import KINDS, Reading

MOST = 30
"""So many readings of each kind."""

LINES: dict[str, tuple[str, ...]] = {
    "pressure": ("systolic", "diastolic"),
    "oxygen": ("oxygen",),
    "glucose": ("glucose",),
    "game": ("score",),
}
UNITS = {"pressure": "mmHg", "oxygen": "%", "glucose": "mmol/L", "game": ""}


def curve(
    kind: str, title: str, readings: Sequence[Reading], limits: Mapping[str, float], when: str
) -> str:
    """Of readings of one kind, the newest first; nothing where there are fewer than two.

    The readings stand at equal distances, whenever they were. ``limits`` are dashed. when: the
    times below it, as HTML.
    """
    shown = list(reversed(readings[:MOST]))
    if len(shown) < 2:
        return ""
    lines = LINES[kind]
    dashed = [limits[name] for name in _limit_names(lines) if name in limits]
    values = [one.measured[name] for one in shown for name in lines]
    low, high = _range(kind, [*values, *dashed])

    def up(value: float) -> str:
        return f"{100 - 100 * (value - low) / (high - low):.1f}"

    def across(at: int) -> str:
        return f"{3 + 94 * at / (len(shown) - 1):.1f}"

    drawn = [f'<path class="limit" d="M0 {up(one)}H100"/>' for one in dashed]
    for name in lines:
        points = [(across(at), up(one.measured[name])) for at, one in enumerate(shown)]
        drawn.append(f'<path class="line" d="M{" L".join(f"{x} {y}" for x, y in points)}"/>')
        # A line without a length has round ends, however the picture is stretched.
        for (x, y), one in zip(points, shown, strict=True):
            outside = " outside" if is_outside(name, one.measured[name], limits) else ""
            drawn.append(f'<path class="point{outside}" d="M{x} {y}h0"/>')
    last = " / ".join(f"{shown[-1].measured[name]:g}" for name in lines)
    told = say("{0}: {1} readings, the last one {2}").format(title, len(shown), last)
    legend = f'<span class="legend">{say("dashed: the limits")}</span>' if dashed else ""
    return (
        f'<figure class="curve" id="curve-{kind}"><figcaption><strong>{escape(title)}</strong> '
        f"<small>{UNITS[kind]}</small>{legend}</figcaption>"
        f'<div class="plot"><div class="scale"><span>{high:g}</span><span>{low:g}</span></div>'
        f'<svg viewBox="0 0 100 100" preserveAspectRatio="none" role="img" '
        f'aria-label="{escape(told)}">{"".join(drawn)}</svg></div>'
        f'<div class="span">{when}</div></figure>'
    )


def is_outside(name: str, value: float, limits: Mapping[str, float]) -> bool:
    return not limits.get(f"{name}_low", value) <= value <= limits.get(f"{name}_high", value)


def _limit_names(lines: Sequence[str]) -> list[str]:
    return [f"{name}_{end}" for name in lines for end in ("low", "high")]


def _range(kind: str, values: Sequence[float]) -> tuple[float, float]:
    """Round numbers below and above all of them; of a game all that can be reached."""
    if kind == "game":
        return KINDS["game"]["score"]
    step = 10 if kind == "pressure" else 5 if kind == "oxygen" else 2
    low = step * ((min(values) - step / 4) // step)
    high = step * -((-max(values) - step / 4) // step)
    return low, min(high, 100) if kind == "oxygen" else high
