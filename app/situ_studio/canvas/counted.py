"""What a robot has done in a state, on its card: how often it came, how long it stayed, and how
often the time ran out there before anybody did anything; and a situation, how often and how long it
was current.
"""

from __future__ import annotations

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter, QPen

from situ_studio.canvas.live import LiveScript, LiveView
from situ_studio.canvas.style import Look, whole_label
from situ_studio.wording.language import tr
from situ_studio.wording.lasting import lasting

HIGH = 18.0
"""Px of the strip that lies over the card's upper edge."""
SIGN = 12.0
GAP = 8.0


def told(live: LiveView, no: str) -> str:
    """The same in words, a line each; "" where nothing is known."""
    lines = []
    if no in live.active:
        lines.append(tr("The robot is here, since {0}.").format(_lasts(live, no)))
    if no in live.suspended:
        lines.append(tr("It is suspended: it does not hold what this state uses."))
    if no in live.counts:
        lines.append(tr("It came here {0}×.").format(live.counts[no]))
    if no in live.times:
        lines.append(tr("It was here for {0} in all.").format(lasting(round(live.times[no]))))
    if live.gave_up.get(no):
        lines.append(tr("The time ran out {0}×: nobody went on.").format(live.gave_up[no]))
    if lines and live.since:
        lines.append(tr("That is since {0}: what was before is not known here.").format(live.since))
    return "\n".join(lines)


def _lasts(live: LiveView, no: str) -> str:
    return lasting(round(live.entered.get(no, 0.0), 1))


def _pieces(look: Look, live: LiveView, no: str) -> list[tuple[str, str, str]]:
    """(icon or "", words, colour) from the left."""
    found = []
    if no in live.counts:
        found.append(("", f"{live.counts[no]}×", "text"))
    if no in live.active:
        found.append(("", _lasts(live, no), "live"))
    elif no in live.times:
        found.append(("", lasting(round(live.times[no])), "text2"))
    if live.gave_up.get(no):
        found.append(("timeout", f"{live.gave_up[no]}×", "warning"))
    return found


def paint(painter: QPainter, look: Look, live: LiveView, no: str, right: float) -> None:
    """On the upper edge of a card, as far as ``right``."""
    _paint(painter, look, _pieces(look, live, no), right, "live" if no in live.active else "")


def paint_situation(
    painter: QPainter, look: Look, live: LiveScript, name: str, right: float
) -> None:
    """On the upper edge of a situation, as far as ``right``: how often and how long it was
    current."""
    found = []
    if name in live.counts:
        found.append(("", f"{live.counts[name]}×", "text"))
    if name in live.times:
        found.append(("", lasting(round(live.times[name])), "text2"))
    _paint(painter, look, found, right)


def _paint(
    painter: QPainter, look: Look, found: list[tuple[str, str, str]], right: float, edge: str = ""
) -> None:
    # From afar it is larger: it is what is looked for then.
    scale = 1.0 if look.level == "full" else 1.7
    pieces = [
        (icon, whole_label(said, round(12 * scale), 600), color) for icon, said, color in found
    ]
    if not pieces:
        return
    high, sign, gap = HIGH * scale, SIGN * scale, GAP * scale
    wide = sum(label.width + (sign + 3 if icon else 0) for icon, label, _ in pieces)
    wide += gap * (len(pieces) + 1)
    area = QRectF(right - wide, -high / 2 - 2, wide, high)
    painter.setPen(QPen(look[edge or "card_border"], 1))
    painter.setBrush(look["card"])
    painter.drawRoundedRect(area, high / 2, high / 2)
    x = area.left() + gap
    for icon, label, color in pieces:
        if icon:
            look.icon(painter, icon, x, area.center().y() - sign / 2, sign, look[color])
            x += sign + 3
        label.draw(painter, x, area.center().y() + 4 * scale, look[color])
        x += label.width + gap
