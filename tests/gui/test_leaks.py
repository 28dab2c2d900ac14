"""Documents that are closed leave no items, widgets or threads, though a reader heard them."""

from __future__ import annotations

import gc
import threading
import weakref
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import shiboken6
from PySide6.QtCore import QEvent, QObject
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QApplication

Start = Callable[..., Any]
Copy = Callable[[str], Path]
KEPT = "AccessibleViewer"
"""Qt keeps what its factory was given; it holds nothing of the drawing any more."""


def hear(part: Any) -> int:
    """Everything below a part of the accessible tree is asked for; how much there is."""
    inner = [part.child(i) for i in range(part.childCount())]
    return len(inner) + sum(hear(one) for one in inner)


def ours() -> Counter[str]:
    """How many objects of the studio and its canvas there are, by type."""
    gc.collect()
    found: Counter[str] = Counter()
    for one in gc.get_objects():
        module = str(type(one).__module__)
        if module.startswith(("situ_studio", "NodeGraphQt")) and type(one).__name__ != KEPT:
            found[type(one).__name__] += 1
    return found


def test_opening_and_closing_documents_leaves_nothing(studio: Start, project: Copy) -> None:
    used = studio()
    window = used.window
    threads = threading.active_count()
    paths = [project("reception"), project("conversation")]
    counts: list[Counter[str]] = []
    children: list[int] = []
    for turn in range(6):
        window.open_project(paths[turn % 2])
        for file in window.tabs.files():
            window.open_file(file)
            for mode in ("outline", "graph"):
                window.show_mode(mode)
                used.settle()
            assert hear(QAccessible.queryAccessibleInterface(window.current_view.canvas.viewer)) > 5
            if len(window.tabs.files()) > 1:
                window.open_files.close(file)
                used.settle()
        if turn % 2:
            counts.append(ours())
            children.append(len(window.findChildren(QObject)))
    # The first turns fill caches, which have limits.
    more = {name: (counts[1][name], counts[2][name]) for name in counts[2] - counts[1]}
    grown = {name: pair for name, pair in more.items() if pair[1] > pair[0] + 1}
    assert not grown
    assert children[1] == children[2]
    assert threading.active_count() == threads


def test_a_closed_window_leaves_no_drawing(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    viewer = used.window.current_view.canvas.viewer
    hear(QAccessible.queryAccessibleInterface(viewer))
    kept = weakref.ref(viewer)
    used.window.close()
    used.window.deleteLater()
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert not shiboken6.isValid(viewer)
    del viewer, used
    gc.collect()
    assert kept() is None
