"""What a window shows of its project, as a value: to be shown again by another window."""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec import Struct

from situ_studio import places
from situ_studio.edit import Place
from situ_studio.session import Looking

if TYPE_CHECKING:
    from situ_studio.window import MainWindow


class Shown(Struct, frozen=True):
    """How one document is shown: as what, what is selected, where the canvas looks.

    mode: ``graph``, ``split`` or ``outline``.
    """

    mode: str
    selected: tuple[Place, ...] = ()
    looking: Looking | None = None


class Showing(Struct, frozen=True):
    """Everything that is open.

    ways: of each tab the files from its own to the part that is shown in it. tab: the chosen
    one. documents: by file, those that have been shown. panel: at the bottom; welcome: the
    welcome page is shown.
    """

    ways: tuple[tuple[str, ...], ...] = ()
    tab: str | None = None
    documents: dict[str, Shown] = {}
    panel: str = "problems"
    folded: bool = False
    welcome: bool = False


def showing(window: MainWindow) -> Showing:
    """What ``window`` shows now."""
    return Showing(
        tuple(window.parts.way_of(file) for file in window.tabs.files()),
        window.tabs.chosen_file,
        {
            file: Shown(view.shown_as, view.selected, view.call("looking"))
            for file, view in window.views.items()
        },
        window.bottom.current,
        window.bottom.is_folded,
        window.stack.currentIndex() == 0,
    )


def show_again(window: MainWindow, wanted: Showing) -> None:
    """Shows in ``window`` what is there of ``wanted``; its project is open already."""
    session = window.session
    for way in wanted.ways:
        if session.document(way[0]) is not None:
            window.open_file(way[0])
    for place, way in enumerate(wanted.ways):
        if way[0] in window.tabs.files():
            window.tabs.put(way[0], place)
    for file in window.tabs.files():
        if file not in {way[0] for way in wanted.ways}:
            window.close_file(file)
    last = [way for way in wanted.ways if way[0] == wanted.tab]
    for way in (*(way for way in wanted.ways if way[0] != wanted.tab), *last):
        if session.document(way[0]) is not None:
            window.tabs.choose(way[0])
            for depth in range(1, len(way) + 1):
                _show_document(window, way[:depth], wanted.documents.get(way[depth - 1]))
    window.bottom.choose(wanted.panel)
    window.bottom.set_folded(wanted.folded)
    if wanted.welcome:
        window.show_welcome()


def _show_document(window: MainWindow, way: tuple[str, ...], how: Shown | None) -> None:
    if window.session.document(way[-1]) is None:
        return
    window.parts.show_way(way)
    view, document = window.current_view, window.current_document
    if how is None or view is None or document is None:
        return
    window.show_mode(how.mode)
    window.select_all(tuple(p for p in how.selected if places.get(document, p) is not None))
    if how.looking is not None:
        view.call("look_at", how.looking)
