"""How a file that was taken away was open, so that undo shows it as it was."""

from __future__ import annotations

from typing import TYPE_CHECKING

from msgspec import Struct

from situ_studio.views.showing import Shown, shown

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow


class Left(Struct, frozen=True):
    """One tab in which a file was, by itself or as a part on the way.

    group: of tabs, from the left. place: of the tab. way: its own file first. chosen: whether it
    was shown there. how: the file was shown, if it was.
    """

    group: int
    place: int
    way: tuple[str, ...]
    chosen: bool
    how: Shown | None


def left(window: MainWindow, file: str) -> tuple[Left, ...]:
    """Of every tab with that file; the current group's come last."""
    found = []
    for at, group in enumerate(window.sides.groups):
        view = group.views.get(file)
        how = group.waiting.get(file) if view is None else shown(view)
        for place, tab in enumerate(group.tabs.files()):
            way = group.ways.get(tab, (tab,))
            if file in way:
                found.append(Left(at, place, way, tab == group.tabs.chosen_file, how))
    current = window.sides.groups.index(window.sides.current)
    return tuple(sorted(found, key=lambda one: (one.group == current, one.chosen)))


def open_again(window: MainWindow, file: str, every: tuple[Left, ...]) -> None:
    """Shows a file that is there again where it was; the last of its tabs is shown in any case."""
    sides = window.sides
    for one in every:
        tab = one.way[0]
        if any(window.session.document(other) is None for other in one.way):
            continue
        group = sides.groups[one.group] if one.group < len(sides.groups) else sides.add()
        sides.enter(group)
        if tab not in group.tabs.files():
            if tab != file:
                continue
            window.open_files.add_tab(tab)
            group.tabs.put(tab, one.place)
        if one.how is not None and file not in group.views:
            group.waiting[file] = one.how
        group.ways[tab] = one.way
        if one.chosen or one is every[-1]:
            window.tabs.choose(tab)
