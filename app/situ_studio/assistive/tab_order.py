"""Where Tab and F6 go: widget by widget as one reads, panel by panel round the window.

Forms are built anew at each selection, and Qt's own order is that of building.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtWidgets import QApplication, QScrollArea, QWidget

BEHIND = "behind"
"""The property of a widget that lies across others: Tab comes to it right behind this one."""
REASONS = {1: Qt.FocusReason.TabFocusReason, -1: Qt.FocusReason.BacktabFocusReason}


def reading_order(areas: Sequence[QRect]) -> list[int]:
    """Positions of the areas line by line, from left to right in each.

    Two share a line where the middle of one lies between the upper and lower edge of the other.
    """
    waiting = sorted(range(len(areas)), key=lambda i: (areas[i].center().y(), areas[i].left()))
    ordered: list[int] = []
    while waiting:
        first = areas[waiting[0]]
        here = range(first.top(), max(first.bottom(), first.top()) + 1)
        # One without any height is in no line but its own.
        line = [i for i in waiting if i == waiting[0] or areas[i].center().y() in here]
        ordered += sorted(line, key=lambda i: areas[i].left())
        waiting = [i for i in waiting if i not in line]
    return ordered


def stops(panel: QWidget) -> list[QWidget]:
    """The widgets of a panel at which Tab stops, as one reads."""
    every = [w for w in (panel, *panel.findChildren(QWidget)) if _stops_at(w)]
    # What scrolls is one only where nothing in it is: it lies beside all that it holds.
    found = [w for w in every if not (isinstance(w, QScrollArea) and _holds(w, every))]
    across = [w for w in found if w.property(BEHIND) in found]
    lying = [w for w in found if w not in across]
    areas = [QRect(w.mapTo(panel, QPoint()), w.size()) for w in lying]
    ordered = [lying[i] for i in reading_order(areas)]
    for widget in reversed(across):
        ordered.insert(ordered.index(widget.property(BEHIND)) + 1, widget)
    return ordered


def _holds(widget: QWidget, others: Iterable[QWidget]) -> bool:
    return any(widget.isAncestorOf(other) for other in others)


def _stops_at(widget: QWidget) -> bool:
    takes = widget.focusPolicy() & Qt.FocusPolicy.TabFocus
    return bool(takes) and widget.isVisible() and widget.isEnabled() and not widget.focusProxy()


def next_stop(panels: Iterable[QWidget], home: QWidget, way: int) -> bool:
    """Moves the focus one widget on (1) or back (-1), round the end; False where none takes it.

    From what is no panel, such as a field over the window that closes, it goes to ``home``.
    """
    every = [w for panel in panels if panel.isVisible() for w in stops(panel)]
    here = _now(every)
    return _focus(every if here >= 0 else stops(home) or every, here, 1 if here < 0 else way)


def next_panel(panels: Iterable[QWidget], way: int) -> bool:
    """Moves the focus to the first widget of the next panel that has one."""
    firsts: list[QWidget] = []
    here = -1
    for panel in panels:
        inside = stops(panel) if panel.isVisible() else []
        if inside:
            if _now(inside) >= 0:
                here = len(firsts)
            firsts.append(inside[0])
    return _focus(firsts, here, way)


def _now(every: Sequence[QWidget]) -> int:
    """The position of what has the focus, or holds it; -1 where none does."""
    focus = QApplication.focusWidget()
    for index, widget in enumerate(every):
        if focus is not None and (widget is focus or widget.isAncestorOf(focus)):
            return index
    return -1


def _focus(every: Sequence[QWidget], here: int, way: int) -> bool:
    if not every:
        return False
    at = here + way if here >= 0 else (0 if way > 0 else -1)
    every[at % len(every)].setFocus(REASONS[way])
    _bring(QApplication.focusWidget())
    return True


def _bring(widget: QWidget | None) -> None:
    """It is seen: what scrolls does that by itself only where the focus was in it before."""
    around = widget.parentWidget() if widget is not None else None
    while widget is not None and around is not None:
        if isinstance(around, QScrollArea):
            around.ensureWidgetVisible(widget)
        around = around.parentWidget()
