"""A sheet onto which tags, pictures and movies are dropped too."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QMimeData, QPointF, Qt, Signal
from PySide6.QtGui import QDragEnterEvent, QDragMoveEvent, QDropEvent

from situ_studio.screens.media_import import kind_of
from situ_studio.screens.sheet import Sheet
from situ_studio.screens.tag_chips import TAG


class DesignerSheet(Sheet):
    """Places are percent of the screen."""

    tag_dropped = Signal(str, float, float)
    files_dropped = Signal(tuple, float, float)
    """Paths of files that the robot's page can show, and where."""
    unshown_dropped = Signal(str)
    """A file that it can not show: its path."""

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        self._welcome(event)

    def dragMoveEvent(self, event: QDragMoveEvent) -> None:
        self._welcome(event)

    def _welcome(self, event: QDragMoveEvent) -> None:
        data = event.mimeData()
        if data.hasFormat(TAG) or files_in(data):
            event.setDropAction(Qt.DropAction.CopyAction)
            event.accept()
        elif isinstance(event, QDragEnterEvent):
            super().dragEnterEvent(event)
        else:
            super().dragMoveEvent(event)

    def dropEvent(self, event: QDropEvent) -> None:
        data, at = event.mimeData(), self._percent(event.position())
        files = files_in(data)
        if not data.hasFormat(TAG) and not files:
            super().dropEvent(event)
            return
        event.setDropAction(Qt.DropAction.CopyAction)
        event.accept()
        self.setFocus()
        if data.hasFormat(TAG):
            self.tag_dropped.emit(bytes(data.data(TAG).data()).decode(), *at)
            return
        shown = tuple(file for file in files if kind_of(file))
        if shown:
            self.files_dropped.emit(shown, *at)
        else:
            self.unshown_dropped.emit(str(files[0]))

    def _percent(self, at: QPointF) -> tuple[float, float]:
        return at.x() / self.width() * 100, at.y() / self.height() * 100


def files_in(data: QMimeData) -> tuple[Path, ...]:
    """The files that are dragged or on the clipboard."""
    return tuple(Path(url.toLocalFile()) for url in data.urls() if url.isLocalFile())
