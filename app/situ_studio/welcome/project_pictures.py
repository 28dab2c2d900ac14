"""Projects as the welcome page shows them: a picture of their drawing, and what is in it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import shiboken6
from msgspec import Struct
from PySide6.QtCore import QCoreApplication, QObject, QRectF, Qt, QTimer
from PySide6.QtGui import QPainter, QPainterPath, QPaintEvent
from PySide6.QtWidgets import QWidget

from situ.document import folder
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ.errors import SituError
from situ_studio.files.opening import is_large
from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.welcome import thumbnail
from situ_studio.wording.language import count, tr

SMALL = 0.3
"""The scale of a small picture."""


class Example(Struct, frozen=True):
    """An example as its card shows it. about: one sentence, from its own files."""

    name: str
    about: str
    project: Project

    @property
    def document(self) -> Application | Spds | None:
        """What its picture shows."""
        return first_document(self.project)


def first_document(project: Project) -> Application | Spds | None:
    """What a project's picture shows: its script where it has one, else its first application."""
    if project.spds is not None:
        return project.spds
    return next(iter(project.applications.values()), None)


def project_picture(path: str) -> Application | Spds | None:
    """What the picture of the project in a folder shows; None of one that is large, or unread."""
    if is_large(Path(path)):
        return None
    try:
        project, _ = folder.load(Path(path))
    except SituError:
        return None
    return first_document(project) if project is not None else None


def facts(document: Application | Spds | None) -> str:
    """``20 states`` or ``5 situations, 7 modules``."""
    said = QCoreApplication.translate
    if isinstance(document, Application):
        return count(
            len(document.states), said("Status", "{0} state"), said("Status", "{0} states")
        )
    if isinstance(document, Spds):
        parts = (
            count(
                len(document.situations),
                said("Status", "{0} situation"),
                said("Status", "{0} situations"),
            ),
            count(
                len(document.modules), said("Status", "{0} module"), said("Status", "{0} modules")
            ),
        )
        return tr(", ").join(parts)
    return ""


class Picture(QWidget):
    """What a document looks like."""

    def __init__(self, theme: Theme, document: Application | Spds | None = None) -> None:
        super().__init__()
        self._theme, self.document = theme, document
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)

    def show_document(self, document: Application | Spds | None) -> None:
        self.document = document
        self.update()

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.update()

    def paint_document(self, painter: QPainter, rect: QRectF, routed: bool) -> None:
        if isinstance(self.document, Application):
            thumbnail.paint_application(painter, rect, self.document, self._theme, routed)
        elif isinstance(self.document, Spds):
            thumbnail.paint_script(painter, rect, self.document, self._theme)


class LargePicture(Picture):
    """The upper half of an example's card."""

    def __init__(self, theme: Theme, document: Application | Spds | None) -> None:
        super().__init__(theme, document)
        self.setFixedHeight(px(176))

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        rect = QRectF(self.rect())
        shape = QPainterPath()
        shape.addRoundedRect(rect.adjusted(0, 0, 0, 8), 7, 7)
        painter.setClipRect(rect)
        painter.fillPath(shape, self._theme.color("canvas"))
        self.paint_document(painter, rect.adjusted(24, 16, -24, -16), True)
        painter.setPen(self._theme.color("line"))
        painter.drawLine(rect.bottomLeft(), rect.bottomRight())
        painter.end()


class SmallPicture(Picture):
    """At the left of a card; an icon where there is no document to be seen."""

    def __init__(self, theme: Theme, icon: str) -> None:
        super().__init__(theme)
        self._icon = icon
        self.setFixedSize(px(60), px(40))

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        rect = QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5)
        painter.setPen(self._theme.color("line"))
        painter.setBrush(self._theme.color("canvas"))
        painter.drawRoundedRect(rect, 4, 4)
        if self.document is None:
            at = QRectF(0, 0, 18, 18)
            at.moveCenter(rect.center())
            icons.paint(painter, self._icon, at, self._theme.color("text3"))
        else:
            # Drawn larger than it is seen: a script's rows have a least height.
            painter.translate(rect.topLeft())
            painter.scale(SMALL, SMALL)
            whole = QRectF(0, 0, rect.width() / SMALL, rect.height() / SMALL)
            self.paint_document(painter, whole.adjusted(12, 12, -12, -12), False)
        painter.end()


class SmallPictures(QObject):
    """Reads the projects that small pictures show, one at a time, so that ``page`` is there at
    once and never stands still; none while it is not seen.

    read: gives what the picture of the project at a path shows; it may take its time.
    """

    def __init__(self, page: QWidget, read: Callable[[str], Application | Spds | None]) -> None:
        super().__init__(page)
        self._page, self._read = page, read
        self._unread: list[tuple[SmallPicture, str]] = []
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self._read_next)

    def picture(self, theme: Theme, icon: str, path: str) -> SmallPicture:
        """One of the project at ``path``; an icon until that is read."""
        made = SmallPicture(theme, icon)
        self._unread.append((made, path))
        self._soon.start()
        return made

    @property
    def waits(self) -> bool:
        """Whether there are pictures that are still to be read."""
        return bool(self._unread)

    def go_on(self) -> None:
        """The page is seen again."""
        self._soon.start()

    def _read_next(self) -> None:
        if not self._unread or not self._page.isVisible():
            return
        picture, path = self._unread.pop(0)
        if shiboken6.isValid(picture):
            picture.show_document(self._read(path))
        self._soon.start()
