"""A sheet onto which tags, pictures and movies are dropped too."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QMimeData, Qt, Signal
from PySide6.QtGui import QDragEnterEvent, QDragMoveEvent, QDropEvent, QPainter

from situ.document import rbd
from situ_studio.looks.theme import CAPTION, font
from situ_studio.screens import placing
from situ_studio.screens.media_import import kind_of
from situ_studio.screens.sheet import Sheet
from situ_studio.screens.tag_chips import TAG
from situ_studio.screens.templates import TEMPLATE, read


class DesignerSheet(Sheet):
    """Places are percent of the screen."""

    tag_dropped = Signal(str, float, float)
    files_dropped = Signal(tuple, float, float)
    """Paths of files that the robot's page can show, and where."""
    template_dropped = Signal(object)
    """A template, for the state that is shown."""
    unshown_dropped = Signal(str)
    """A file that it can not show: its path."""

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        self._welcome(event)

    def dragMoveEvent(self, event: QDragMoveEvent) -> None:
        self._welcome(event)

    def _welcome(self, event: QDragMoveEvent) -> None:
        data = event.mimeData()
        if data.hasFormat(TAG) or data.hasFormat(TEMPLATE) or files_in(data):
            event.setDropAction(Qt.DropAction.CopyAction)
            event.accept()
        elif isinstance(event, QDragEnterEvent):
            super().dragEnterEvent(event)
        else:
            super().dragMoveEvent(event)

    def dropEvent(self, event: QDropEvent) -> None:
        data, at = event.mimeData(), self.scale.percent(event.position())
        files, template = files_in(data), read(bytes(data.data(TEMPLATE).data()))
        if not data.hasFormat(TAG) and not files and template is None:
            super().dropEvent(event)
            return
        event.setDropAction(Qt.DropAction.CopyAction)
        event.accept()
        self.setFocus()
        if template is not None:
            self.template_dropped.emit(template)
            return
        if data.hasFormat(TAG):
            self.tag_dropped.emit(bytes(data.data(TAG).data()).decode(), *at)
            return
        shown = tuple(file for file in files if kind_of(file))
        if shown:
            self.files_dropped.emit(shown, *at)
        else:
            self.unshown_dropped.emit(str(files[0]))

    # -- what is not there ---------------------------------------------------------------

    def missing(self) -> dict[str, str]:
        """The pictures and movies of the screen whose files are not there: id to file."""
        found = {}
        for one in self.components:
            src = one.src if isinstance(one, rbd.Image | rbd.Movie) else ""
            if src and "{" not in src and "://" not in src and not self._is_there(src):
                found[one.id] = src
        return found

    def _is_there(self, src: str) -> bool:
        return self._media is not None and (self._media / src).is_file()

    def paint_marks(self) -> None:
        super().paint_marks()
        missing = self.missing()
        if not missing:
            return
        painter = QPainter(self)
        painter.setFont(font(CAPTION, 500))
        painter.setPen(self._theme.color("error" if self._theme.name == "light" else "error_soft"))
        for one in self.components:
            if one.id in missing:
                area = self.area(placing.box_of(one)).adjusted(4, 4, -4, -4)
                cut, wide = painter.fontMetrics().elidedText, int(area.width())
                lines = (missing[one.id], self.tr("missing"))
                said = "\n".join(cut(line, Qt.TextElideMode.ElideRight, wide) for line in lines)
                below = Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignBottom
                painter.drawText(area, int(below), said)
        painter.end()


def files_in(data: QMimeData) -> tuple[Path, ...]:
    """The files that are dragged or on the clipboard."""
    return tuple(Path(url.toLocalFile()) for url in data.urls() if url.isLocalFile())
