"""Below a script's modules: those that it does not name yet, to be dragged or added."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from PySide6.QtCore import QMimeData, QModelIndex, Qt, Signal
from PySide6.QtGui import QKeyEvent, QStandardItem, QStandardItemModel
from PySide6.QtWidgets import QLabel, QListView, QSizePolicy, QVBoxLayout, QWidget

from situ_studio.kinds import MODULE_MIME
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.lists import COUNT, DETAIL, ICON, MARKS, PLACE, RowDelegate
from situ_studio.project.known_modules import Known
from situ_studio.wording.language import tr

HIGH = 44
"""Px of a row."""


def words(one: Known) -> str:
    """All that a module tells of itself: what it does, needs and provides."""
    module = one.module
    lines = [module.description] if module.description else []
    if one.present:
        lines.append(tr("Connected to the robot now."))
    if module.resources:
        lines.append(tr("Moves or uses: {0}").format(", ".join(module.resources)))
    needs = [need.data or need.module or "" for need in module.requires]
    if needs:
        lines.append(tr("Needs: {0}").format(", ".join(needs)))
    gives = [
        f"{p.data} ({p.unit or p.type})" if p.unit or p.type else p.data for p in module.provides
    ]
    if gives:
        lines.append(tr("Provides: {0}").format(", ".join(gives)))
    return "\n".join(lines)


class _Modules(QStandardItemModel):
    """A drag carries a module's name as ``MODULE_MIME``."""

    def mimeTypes(self) -> list[str]:
        return [MODULE_MIME]

    def mimeData(self, indexes: Sequence[QModelIndex]) -> QMimeData:
        data = QMimeData()
        data.setData(MODULE_MIME, indexes[0].data(PLACE).encode())
        return data


class _List(QListView):
    wanted = Signal(str)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.currentIndex().isValid():
            self.wanted.emit(self.currentIndex().data(PLACE))
        else:
            super().keyPressEvent(event)


class MoreModules(QWidget):
    """Tells in ``wanted`` which module is to be added to the script. Hidden where there is none."""

    wanted = Signal(str)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "panel")
        self._shown: tuple[Known, ...] = ()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 8, 0, 0)
        column.setSpacing(2)
        # Never higher than its rows: the heading would stand far above them.
        column.setSizeConstraint(QVBoxLayout.SizeConstraint.SetMinAndMaxSize)
        self.title = QLabel(self.tr("Not in this script"))
        self.title.setProperty("role", "dim")
        self.title.setContentsMargins(12, 0, 8, 0)
        self.title.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        column.addWidget(self.title)
        self.list = _List()
        self.list.setAccessibleName(self.title.text())
        self.list.setEditTriggers(QListView.EditTrigger.NoEditTriggers)
        self.list.setDragEnabled(True)
        self.list.setMouseTracking(True)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setToolTip(self.tr("Drag a module onto a situation, or press Enter to add it."))
        self._delegate = RowDelegate(theme, 22, self.list)
        self.list.setItemDelegate(self._delegate)
        self._model = _Modules(self)
        self.list.setModel(self._model)
        self.list.wanted.connect(self.wanted)
        self.list.doubleClicked.connect(lambda index: self.wanted.emit(index.data(PLACE)))
        column.addWidget(self.list)
        self.hide()

    def set_theme(self, theme: Theme) -> None:
        self._delegate.set_theme(theme)
        self.list.viewport().update()

    def show_modules(self, modules: Iterable[Known]) -> None:
        """Those that are connected stand first."""
        shown = tuple(sorted(modules, key=lambda one: (not one.present, one.module.name)))
        if shown == self._shown:
            return
        self._shown = shown
        self._model.clear()
        for one in shown:
            self._model.appendRow(self._row(one))
        self.list.setMaximumHeight(px(HIGH) * len(shown))
        self.list.setMinimumHeight(px(HIGH))
        self.setVisible(bool(shown))

    def _row(self, one: Known) -> QStandardItem:
        module = one.module
        item = QStandardItem(module.name)
        icon = "state" if one.application else "module"
        otherwise = self.tr("an application of this project")
        if not one.application:
            otherwise = self.tr("tells nothing of itself")
        item.setData(module.name, PLACE)
        item.setData((icon, icon), ICON)
        item.setData(" ".join(module.resources), COUNT)
        item.setData(module.description or otherwise, DETAIL)
        item.setData((("link", "live"),) if one.present else (), MARKS)
        said = words(one)
        item.setToolTip(said)
        item.setAccessibleText(f"{module.name}. {said}".replace("\n", " "))
        return item
