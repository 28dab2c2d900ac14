"""*Which picture?*: those of the project's media, typed to filter, a file from elsewhere, or data
that names it.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from PySide6.QtWidgets import QListWidgetItem, QWidget

from situ.document.names import only_reference, references
from situ_studio.canvas.gestures import Follow
from situ_studio.canvas.menu import FollowMenu
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.screens.media_rows import HIGH, ICON, IMPORT, KEY, MediaRows
from situ_studio.wording.language import tr

WIDE = 320
DATA = "{"
"""The key of a row that leads to the data, and what is typed for the same: no file is called so."""
ROWS = 6
"""So many are seen at the most; the others are reached by scrolling."""


def names_data(src: str) -> bool:
    """Whether data names the file, or a part of its name."""
    return bool(references(src))


def asked(kind: str) -> str:
    """What is wanted of a kind of media: ``image``, ``movie`` or ``sound``."""
    if kind == "image":
        return tr("Which picture?")
    return tr("Which movie?") if kind == "movie" else tr("Which sound?")


class MediaPicker(FollowMenu):
    """``chosen`` tells a file as the project names it, a reference or an address that was typed, or
    IMPORT.

    kind: ``image``, ``movie`` or ``sound``. names: of the files that fit, home the folder in which
    they are. now: the one that is chosen at first, of those that are there. tags: the data that
    may name a file; where it does so now, data is offered at first.
    """

    def __init__(
        self,
        kind: str,
        names: Iterable[str],
        home: Path | None,
        theme: Theme,
        parent: QWidget,
        now: str = "",
        tags: Iterable[str] = (),
    ) -> None:
        first = (now,) if only_reference(now) is not None else ()
        self._data = tuple(dict.fromkeys((*first, *(f"{{{tag}}}" for tag in tags))))
        choices = [Follow(IMPORT, tr("Import a file…"), "plus")]
        if self._data:
            choices.append(Follow(DATA, tr("From data…"), "data"))
        choices += [Follow(name, name, kind) for name in names]
        super().__init__(choices, theme, parent, asked(kind))
        self.list.setItemDelegate(MediaRows(theme, home, self.list))
        self.list.setMouseTracking(True)
        most = max(len(self.choices), len(self._data) + 1)
        self.setFixedSize(px(WIDE), px(48) + px(HIGH) * min(ROWS, most))
        if names_data(now):
            self.field.setText(DATA if now in self._data else now)
        for row in range(self.list.count()):
            if self.list.item(row).data(KEY) == now:
                self.list.setCurrentRow(row)

    def _filter(self, text: str) -> None:
        """What is typed as a reference, an address, or a file that is still to come can be used."""
        typed = text.strip()
        wanted = typed.casefold().split()
        self.list.clear()
        for choice in self.choices:
            if choice.key == IMPORT or all(word in choice.label.casefold() for word in wanted):
                self._add(choice.key, choice.label, choice.icon)
        known = {choice.key for choice in self.choices}
        if typed.startswith(DATA):
            sought = typed.casefold().removeprefix(DATA).strip()
            for one in self._data:
                if sought in one.casefold():
                    self._add(one, one, "data")
                    known.add(one)
        refers = names_data(typed) or "://" in typed
        # Half a reference is one that is still being typed.
        named = refers or ("{" not in typed and Path(typed).suffix)
        if named and typed not in known:
            self._add(typed, tr("Use {0}").format(typed), "link")
        # A picture, or data, rather than what stands before them.
        keys = [self.list.item(row).data(KEY) for row in range(self.list.count())]
        first = next((row for row, key in enumerate(keys) if key not in (IMPORT, DATA)), 0)
        self.list.setCurrentRow(first)

    def _take(self, item: QListWidgetItem | None) -> None:
        if item is not None and item.data(KEY) == DATA:
            self.field.setText(DATA)
            self.field.setFocus()
        else:
            super()._take(item)

    def _add(self, key: str, label: str, icon: str) -> None:
        item = QListWidgetItem(label)
        item.setData(KEY, key)
        item.setData(ICON, icon)
        item.setToolTip(label)
        self.list.addItem(item)
