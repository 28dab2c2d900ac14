"""*Which picture?*: those of the project's media, typed to filter, and a file from elsewhere."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from PySide6.QtWidgets import QListWidgetItem, QWidget

from situ_studio.canvas.gestures import Follow
from situ_studio.canvas.menu import FollowMenu
from situ_studio.language import tr
from situ_studio.letters import px
from situ_studio.screens.media_rows import HIGH, ICON, IMPORT, KEY, MediaRows
from situ_studio.theme import Theme

WIDE = 320
ROWS = 6
"""So many are seen at the most; the others are reached by scrolling."""


def asked(kind: str) -> str:
    """What is wanted of a kind of media: ``image``, ``movie`` or ``sound``."""
    if kind == "image":
        return tr("Which picture?")
    return tr("Which movie?") if kind == "movie" else tr("Which sound?")


class MediaPicker(FollowMenu):
    """``chosen`` tells a file as the project names it, a reference or an address that was typed, or
    IMPORT.

    kind: ``image``, ``movie`` or ``sound``. names: of the files that fit, home the folder in which
    they are. now: the one that is chosen at first, of those that are there.
    """

    def __init__(
        self,
        kind: str,
        names: Iterable[str],
        home: Path | None,
        theme: Theme,
        parent: QWidget,
        now: str = "",
    ) -> None:
        choices = [Follow(IMPORT, tr("Import a file…"), "plus")]
        choices += [Follow(name, name, kind) for name in names]
        super().__init__(choices, theme, parent, asked(kind))
        self.list.setItemDelegate(MediaRows(theme, home, self.list))
        self.list.setMouseTracking(True)
        self.setFixedSize(px(WIDE), px(48) + px(HIGH) * min(ROWS, len(self.choices)))
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
        refers = typed.startswith("{") or "://" in typed
        known = {choice.key for choice in self.choices}
        if (refers or Path(typed).suffix) and typed not in known:
            self._add(typed, tr("Use {0}").format(typed), "link")
        # A picture rather than the import, which stands before them.
        self.list.setCurrentRow(1 if self.list.count() > 1 else 0)

    def _add(self, key: str, label: str, icon: str) -> None:
        item = QListWidgetItem(label)
        item.setData(KEY, key)
        item.setData(ICON, icon)
        item.setToolTip(label)
        self.list.addItem(item)
