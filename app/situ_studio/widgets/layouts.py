"""Pieces that every panel is laid out with: thin rules, and layouts that are filled anew."""

from __future__ import annotations

from PySide6.QtWidgets import QFrame, QLayout


def rule() -> QFrame:
    """A line one px high, over the whole width."""
    line = QFrame()
    line.setProperty("role", "rule")
    line.setFixedHeight(1)
    return line


def clear(layout: QLayout) -> None:
    """Takes every widget out of a layout, layouts in it included, and deletes it soon."""
    while layout.count():
        item = layout.takeAt(0)
        if item is None:
            continue
        widget, inner = item.widget(), item.layout()
        if widget is not None:
            # Hidden first: a widget without a parent would else be a window for a moment.
            widget.hide()
            widget.setParent(None)
            widget.deleteLater()
        elif inner is not None:
            clear(inner)
