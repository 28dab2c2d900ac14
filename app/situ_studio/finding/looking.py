"""A window's finding: in the whole project, usages of a name, and its renaming everywhere."""

from __future__ import annotations

import re
from collections.abc import Collection
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtGui import QCursor

from situ_studio.canvas.gestures import Follow
from situ_studio.canvas.menu import FollowMenu
from situ_studio.edits import mentions, renames
from situ_studio.edits.mentions import Role
from situ_studio.finding import search
from situ_studio.panels.finding import Finding

if TYPE_CHECKING:
    from situ_studio.looks.theme import Theme
    from situ_studio.window.main_window import MainWindow

_AROUND = (('"', '"'), ("{", "}"), ("{", "."), (":", '"'))
"""What stands around a name in the files beside the documents."""
_STATE = re.compile(r'"(?:state|from|to)": *"([^"]+)"')
"""A state in a scenario: its number, or those on the way into a part."""
_ICONS = {"event": "event", "tag": "data", "state": "state", "media": "image"}


class FindingSide(QObject):
    """Fills the panel *Find*, and renames what was chosen."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._index = mentions.Index()
        self._home = ""
        self.panel = Finding(window.theme)
        window.bottom.add("find", self.tr("Find"), self.panel)
        self.panel.asked.connect(self._find)
        self.panel.chosen.connect(self._go)
        self.panel.left.connect(self._leave)
        window.session.changed.connect(self._again)
        window.session.opened.connect(self.panel.field.clear)

    def set_theme(self, theme: Theme) -> None:
        self.panel.set_theme(theme)

    # -- finding ------------------------------------------------------------------------

    def open(self, query: str = "") -> None:
        """Shows the panel, with the cursor in its field."""
        self._home = self._window.current_file or ""
        self._window.bottom.choose("find")
        self.panel.look_for(query or self.panel.query)
        self._again()

    def _again(self) -> None:
        if self._window.bottom.current == "find":
            self._find(self.panel.query)

    def _find(self, query: str) -> None:
        project = self._window.session.project
        if project is None:
            return
        documents = mentions.documents(project)
        self.panel.show_hits(
            search.search(documents, self._index.every(project), query, self._home)
        )

    def _go(self, hit: search.Hit) -> None:
        self._window.go_to(hit.file, hit.place)

    def _leave(self) -> None:
        view = self._window.current_view
        if view is not None:
            view.current_view().setFocus()

    # -- usages -----------------------------------------------------------------------------

    def _written(self) -> tuple[tuple[Role, str], ...]:
        view, document = self._window.current_view, self._window.current_document
        if view is None or document is None or len(view.selected) != 1:
            return ()
        return mentions.names_of(document, view.selected[0])

    def can_find_usages(self) -> bool:
        return bool(self._written())

    def can_rename(self) -> bool:
        return any(role in renames.ROLES for role, _ in self._written())

    def names(self) -> tuple[tuple[Role, str], ...]:
        """What can be looked for of the selected thing; a tag without its fields."""
        found, project = self._written(), self._window.session.project
        if project is None or not any(role == "tag" for role, _ in found):
            return found
        known = mentions.tags(list(self._index.every(project)), project)
        return tuple(
            dict.fromkeys((r, mentions.tag_of(n, known) if r == "tag" else n) for r, n in found)
        )

    def find_usages(self) -> None:
        """Every place that mentions the selected thing; asks which name where it has several."""
        self._choose(self.names(), self.tr("Usages of what?"), self._usages)

    def _usages(self, role: Role, name: str) -> None:
        self.open(search.exact(role, name))

    def _choose(self, offered: tuple[tuple[Role, str], ...], asked: str, then: object) -> None:
        assert callable(then)
        if len(offered) == 1:
            then(*offered[0])
        elif offered:
            choices = [
                Follow(str(i), search.exact(r, n), _ICONS.get(r, "search"))
                for i, (r, n) in enumerate(offered)
            ]
            menu = FollowMenu(choices, self._window.theme, self._window, asked)
            menu.chosen.connect(lambda key: then(*offered[int(key)]))
            menu.popup(QCursor.pos())

    # -- another name everywhere ---------------------------------------------------------------

    def renamable(self) -> tuple[tuple[Role, str], ...]:
        """What of the selected thing can be renamed everywhere."""
        return tuple((r, n) for r, n in self.names() if r in renames.ROLES)

    def rename_everywhere(self) -> None:
        self._choose(self.renamable(), self.tr("Rename what?"), self._rename)

    def _rename(self, role: Role, old: str) -> None:
        window, project = self._window, self._window.session.project
        title = self.tr("Rename everywhere")
        label = self.tr("Another name for the {0} {1}").format(renames.called(role), old)
        new = window.dialogs.name(title, label, old)
        if new is None or new == old or project is None:
            return
        every = list(self._index.every(project))
        try:
            renamed = renames.rename(project, every, role, old, new)
        except ValueError as error:
            window.say(str(error))
            return
        view = window.current_view
        selected = view.selected if view is not None else ()
        looking = view.call("looking") if view is not None else None
        first = {f: d for f, d in renamed.changed.items() if f == window.current_file}
        text = self.tr("Rename {0} {1} to {2}").format(renames.called(role), old, new)
        if not window.session.commit_all({**first, **renamed.changed}, text, selected, looking):
            window.say(self.tr("A document with errors mentions {0}: mend it first.").format(old))
            return
        where = self.tr("{0} places follow.") if renamed.count > 1 else self.tr("1 place follows.")
        said = where.format(renamed.count)
        still = still_saying(Path(project.root), old)
        if still:
            said += " " + self.tr("Not here: {0}.").format(", ".join(still))
        if renamed.left:
            said += " " + self.tr("Look at the patterns of clear too.")
        window.say(said)


def still_saying(root: Path, name: str) -> list[str]:
    """The files beside the documents that mention a name: settings, scenarios, translations."""
    every = [root / "situ.toml", *root.glob("scenarios/*.jsonl"), *root.glob("texts/*.po")]
    found = []
    for file in sorted(f for f in every if f.is_file()):
        text = file.read_text(encoding="utf-8", errors="replace")
        if any(f"{before}{name}{after}" in text for before, after in _AROUND):
            found.append(file.relative_to(root).as_posix())
    return found


def scenarios_with(root: Path, numbers: Collection[str], inside: bool = False) -> list[str]:
    """The scenarios that name one of these states: of an application, or (inside) of its parts."""
    found = []
    for file in sorted(root.glob("scenarios/*.jsonl")):
        paths = _STATE.findall(file.read_text(encoding="utf-8", errors="replace"))
        ways = (path.split("/") for path in paths)
        if any(set(way[1:] if inside else way[:1]) & set(numbers) for way in ways):
            found.append(file.stem)
    return found
