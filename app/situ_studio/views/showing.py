"""What a window shows of its project, as a value: to be shown again by another window, and when
the project is opened the next time (kept in the settings, never in the project's files)."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
from msgspec import Struct
from msgspec.structs import replace
from PySide6.QtCore import QEvent, QSettings
from PySide6.QtWidgets import QApplication

from situ_studio.edits import places
from situ_studio.edits.edit import Document, Place
from situ_studio.files.claim import key
from situ_studio.project.undo import Looking
from situ_studio.welcome.recent import recent

if TYPE_CHECKING:
    from situ_studio.views.document_view import DocumentView
    from situ_studio.window.main_window import MainWindow
    from situ_studio.window.sides import Group


KEPT = "shown"
"""Where the settings keep it."""


class Shown(Struct, frozen=True):
    """How one document is shown: as which view, what is selected, where the canvas looks.

    shares: how a person has divided the room, by view.
    """

    mode: str
    selected: tuple[Place, ...] = ()
    looking: Looking | None = None
    shares: dict[str, list[int]] = {}


class Open(Struct, frozen=True):
    """One group of tabs.

    ways: of each tab the files from its own to the part that is shown in it. tab: the chosen
    one. documents: by file, those that have been shown.
    """

    ways: tuple[tuple[str, ...], ...] = ()
    tab: str | None = None
    documents: dict[str, Shown] = {}


class Showing(Struct, frozen=True):
    """Everything that is open.

    groups: from the left, one or two. current: which of them has the focus. widths: of them, in
    px. panel: at the bottom; welcome: the welcome page is shown.
    """

    groups: tuple[Open, ...] = ()
    current: int = 0
    widths: tuple[int, ...] = ()
    panel: str = "problems"
    folded: bool = False
    welcome: bool = False


def showing(window: MainWindow) -> Showing:
    """What ``window`` shows now."""
    sides = window.sides
    return Showing(
        tuple(_open(window, group) for group in sides.groups),
        sides.groups.index(sides.current),
        sides.sizes(),
        window.bottom.current,
        window.bottom.is_folded,
        window.stack.currentIndex() == 0,
    )


def keep(settings: QSettings, window: MainWindow) -> None:
    """Keeps how the window's project is shown, for when it is opened again; of those that were
    open lately. A window that was not seen yet has shown nothing."""
    project = window.session.project
    if project is None or project.toml is None or not window.isVisible():
        return
    root = window.session.root
    known = {key(Path(path)) for path in recent(settings)} | {key(root)}
    settings.beginGroup(KEPT)
    for other in settings.childKeys():
        if other not in known:
            settings.remove(other)
    settings.setValue(key(root), msgspec.json.encode(showing(window)).decode())
    settings.endGroup()


def recall(settings: QSettings, window: MainWindow) -> None:
    """Shows the window's project as it was shown the last time, if that is known."""
    if window.session.project is None:
        return
    try:
        kept = str(settings.value(f"{KEPT}/{key(window.session.root)}", ""))
        wanted = msgspec.json.decode(kept, type=Showing)
    except msgspec.MsgspecError:
        return
    # Where a canvas looks hangs on its size, which it has once it is laid out.
    QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)
    show_again(window, replace(wanted, welcome=False))


def _open(window: MainWindow, group: Group) -> Open:
    return Open(
        tuple(window.parts.way_of(file, group) for file in group.tabs.files()),
        group.tabs.chosen_file,
        group.waiting | {file: shown(view) for file, view in group.views.items()},
    )


def shown(view: DocumentView) -> Shown:
    """How the document of ``view`` is shown now."""
    return Shown(view.shown_as, view.selected, view.call("looking"), view.shares)


def show_as(view: DocumentView, document: Document, how: Shown) -> None:
    """Shows the document of ``view`` as it was shown, as far as what was selected is there."""
    view.set_shares(how.shares)
    view.set_mode(how.mode)
    view.select(tuple(p for p in how.selected if places.get(document, p) is not None))
    if how.looking is not None:
        view.call("look_at", how.looking)


def show_again(window: MainWindow, wanted: Showing) -> None:
    """Shows in ``window`` what is there of ``wanted``; its project is open already."""
    sides = window.sides
    there = [one for one in wanted.groups if any(_is_there(window, way) for way in one.ways)]
    for at, one in enumerate(there):
        sides.enter(sides.groups[at] if at < len(sides.groups) else sides.add())
        _show_group(window, one)
    sides.set_sizes(wanted.widths)
    if wanted.current < len(sides.groups):
        sides.enter(sides.groups[wanted.current])
    window.bottom.choose(wanted.panel)
    window.bottom.set_folded(wanted.folded)
    if wanted.welcome:
        window.welcoming.show()
    elif window.current_view is not None:
        window.current_view.current_view().setFocus()


def _is_there(window: MainWindow, way: tuple[str, ...]) -> bool:
    return window.session.document(way[0]) is not None or window.pages.has(way[0])


def _show_group(window: MainWindow, wanted: Open) -> None:
    group = window.sides.current
    # A document is shown as it was once it is shown: not all of them at the start.
    group.waiting = dict(wanted.documents)
    for file, view in group.views.items():
        document, how = window.session.document(file), group.waiting.pop(file, None)
        if document is not None and how is not None:
            show_as(view, document, how)
    for way in wanted.ways:
        if _is_there(window, way):
            window.open_files.add_tab(way[0])
    for place, way in enumerate(wanted.ways):
        if way[0] in window.tabs.files():
            window.tabs.put(way[0], place)
    for file in window.tabs.files():
        if file not in {way[0] for way in wanted.ways}:
            window.open_files.close(file)
    group.ways = {way[0]: way for way in wanted.ways}
    chosen = wanted.tab if wanted.tab in window.tabs.files() else window.tabs.files()[0]
    window.tabs.choose(chosen)


def show_beside(window: MainWindow, file: str, moved: bool = False) -> None:
    """Shows a tab of the current group in the other one too, as it is shown here.

    moved: it goes there, unless it is the only one of the window.
    """
    here = window.sides.current
    way = window.parts.way_of(file)
    documents = _open(window, here).documents
    moved = moved and (len(here.tabs.files()) > 1 or len(window.sides.groups) > 1)
    there = window.sides.other or window.sides.add()
    if moved:
        window.open_files.close(file)
    window.sides.enter(there)
    window.open_files.add_tab(way[0])
    there.ways[way[0]] = way
    there.waiting |= {f: how for f, how in documents.items() if f in way and f not in there.views}
    window.tabs.choose(way[0])
    if window.current_view is not None:
        window.current_view.current_view().setFocus()
