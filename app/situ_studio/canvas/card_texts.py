"""The texts of a state card, as they fit: measured once, drawn by ``cards.CardItem``."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt

from situ_studio.canvas.picture import FIRST, PITCH, WIDTH, Card, Exit
from situ_studio.canvas.style import Label

PICTURE = QRectF(8, 54, 48, 31)
NAME_PIXELS = (14, 13, 12)
"""Heights of a name's letters, the first that fits."""


def full_texts(card: Card) -> tuple[dict[str, Label], tuple[str, ...]]:
    """The labels of a card at its full size by what they are, and the icons there is room for.

    ``no``, ``name`` and ``line``; ``exit <id>`` and, where it fits, ``phrase <id>``; ``chip <n>``.
    """
    number = Label(card.no, 12, 600)
    left = 36.0 + max(0.0, number.width - 12) if card.no else 30.0
    right = WIDTH - 10 - (18 if card.kind in ("start", "end", "part") else 0)
    right -= 17 if card.mark else 0
    laid = {
        "no": number,
        "name": _name(card.name, right - left),
        "line": Label(card.line, 12, 400, WIDTH - 26 - 8),
    }
    room_icons = WIDTH - 16.0
    for index, leaving in enumerate(card.exits):
        room = WIDTH - 12 - 8 - before_name(leaving)
        y = FIRST + PITCH * index
        if y < PICTURE.bottom() + 6 and card.screen is not None:
            room -= PICTURE.width() + 2
        label = Label(leaving.label, 12, 400 if leaving.timeout else 500, room)
        laid[f"exit {leaving.id}"] = label
        if 84 < y < 114:
            room_icons = min(room_icons, WIDTH - 12 - label.width - before_name(leaving) - 14)
        spare = room - label.width
        if leaving.phrase and not label.cut:
            phrase = Label(f"“{leaving.phrase}”", 11, 400, max(0.0, spare - 8))
            if not phrase.cut:
                laid[f"phrase {leaving.id}"] = phrase
    count = max(0, int((room_icons + 5) / 19))
    icons = card.icons[:count]
    at = 0.0
    for index, chip in enumerate(card.chips):
        label = Label(chip, 10, 500, 64)
        if at + label.width + 10 > 96:
            label = Label(f"+{len(card.chips) - index}", 10, 500)
            laid[f"chip {index}"] = label
            break
        laid[f"chip {index}"] = label
        at += label.width + 14
    return laid, icons


def large_texts(card: Card, pixels: int) -> tuple[Label, Label, Label | None]:
    """Number and name; a name that has no room beside the number takes a second line."""
    number = Label(card.no, pixels - 3, 600)
    chip = max(30.0, number.width + 12) + 10 if card.no else 0.0
    room = card.width - chip - 20 - (26 if card.mark else 0)
    first = Label(card.name, pixels, 600, room)
    if not first.cut:
        return number, first, None
    said = card.name.split()
    count = len(said) - 1
    while count > 0 and Label(" ".join(said[:count]), pixels, 600, room).cut:
        count -= 1
    if count == 0:
        return number, first, None
    rest = Label(" ".join(said[count:]), pixels, 600, card.width - 22)
    return number, Label(" ".join(said[:count]), pixels, 600, room), rest


def before_name(leaving: Exit) -> float:
    """Room for what stands before an exit's name: a clock or a shield, and a problem's sign."""
    return 16.0 * bool(leaving.timeout or leaving.guard) + 16.0 * bool(leaving.mark.sign)


def _name(name: str, room: float) -> Label:
    """A state's name: a little smaller before it is cut, and then in its middle."""
    for pixels in NAME_PIXELS:
        label = Label(name, pixels, 600, room, Qt.TextElideMode.ElideMiddle)
        if not label.cut:
            break
    return label
