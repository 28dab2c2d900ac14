"""From card to card without a mouse: by direction, in order, by the first letter. Pure; no Qt."""

from __future__ import annotations

from collections.abc import Mapping, Sequence


def beside(
    spots: Mapping[str, tuple[float, float]], here: str, across: int, down: int
) -> str | None:
    """The card next to ``here`` in a direction (1, 0 is right); None where none lies there.

    spots: the cards' middles.
    """
    x, y = spots[here]
    best: tuple[float, str] | None = None
    for uid, (other_x, other_y) in spots.items():
        ahead = (other_x - x) * across + (other_y - y) * down
        aside = abs((other_x - x) * down) + abs((other_y - y) * across)
        if uid == here or ahead <= 4 or aside > ahead * 2:
            continue
        if best is None or ahead + 2 * aside < best[0]:
            best = ahead + 2 * aside, uid
    return best[1] if best is not None else None


def onwards(order: Sequence[str], here: str | None, by: int) -> str | None:
    """The card ``by`` further in the order of the document, round its end; None in an empty one."""
    if not order:
        return None
    if here is None:
        return order[0 if by > 0 else -1]
    return order[(order.index(here) + by) % len(order)]


def beginning(names: Mapping[str, tuple[str, ...]], here: str | None, letter: str) -> str | None:
    """The next card after ``here`` one of whose names begins with the letter."""
    order = list(names)
    first = order.index(here) + 1 if here is not None else 0
    for uid in order[first:] + order[:first]:
        if any(name.casefold().startswith(letter.casefold()) for name in names[uid]):
            return uid
    return None
