"""The tutorial beside the window that it is done in: one step at a time, where one left off."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any, cast

from msgspec import Struct
from PySide6.QtCore import QPoint, QSettings, QSize, Qt, QUrl
from PySide6.QtGui import (
    QFont,
    QHideEvent,
    QImage,
    QKeyEvent,
    QResizeEvent,
    QTextBlock,
    QTextBlockFormat,
    QTextCharFormat,
    QTextCursor,
    QTextDocument,
    QTextFragment,
)
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QTextBrowser, QVBoxLayout, QWidget

from situ_studio.looks.letters import px
from situ_studio.looks.theme import FAMILIES, Theme, font
from situ_studio.widgets.icon_widgets import IconButton, retheme

STEP, GEOMETRY = "tutorial_step", "tutorial_geometry"
MARGIN = 16
WIDE, HIGH = 420, 640
"""Px that it has at first."""
FORMS, BELOW = 336, 72
"""Px that the forms at a window's right edge have, and what is above its drawing."""


class Step(Struct, frozen=True):
    """A section of the tutorial, in Markdown without its heading."""

    title: str
    text: str


def steps(text: str) -> list[Step]:
    """The tutorial's sections in their order; what is above the first one is one of its own.

    Links lead out of it and so are words only; its pictures stay.
    """
    plain = re.sub(r"(?<!!)\[([^]]+)\]\([^)]*\)", r"\1", text)
    first, *others = re.split(r"^##? ", plain, flags=re.MULTILINE)[1:]
    return [_step(one) for one in (first, *others)]


def _step(section: str) -> Step:
    title, _, text = section.partition("\n")
    return Step(title.strip(), text.strip())


class TutorialPages(QTextBrowser):
    """Shows a step; its pictures are as wide as there is room."""

    def __init__(self, folder: Path, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self._folder = folder
        self._text = ""
        self.setOpenLinks(False)
        self.setFrameShape(QTextBrowser.Shape.NoFrame)
        self.document().setDocumentMargin(MARGIN)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        self.show_text(self._text)

    def show_text(self, text: str) -> None:
        self._text = text
        document = self.document()
        document.setDefaultFont(font(13))
        document.clear()
        document.setMarkdown(text)
        block = document.begin()
        while block.isValid():
            self._dress(block)
            block = block.next()

    def _dress(self, block: QTextBlock) -> None:
        """Room between paragraphs; bold of the weight that there is, typed words on a ground."""
        cursor = QTextCursor(block)
        if cursor.currentTable() is None:
            room = QTextBlockFormat()
            room.setTopMargin(0)
            room.setBottomMargin(px(8))
            room.setLineHeight(130, QTextBlockFormat.LineHeightTypes.ProportionalHeight.value)
            pictured = any(piece.charFormat().isImageFormat() for piece in _pieces(block))
            if not pictured:
                cursor.mergeBlockFormat(room)
        for piece in _pieces(block):
            form, merged = piece.charFormat(), QTextCharFormat()
            if form.isImageFormat():
                continue
            if form.fontWeight() > QFont.Weight.DemiBold:
                merged.setFontWeight(QFont.Weight.DemiBold)
            if form.fontFixedPitch():
                merged.setFontFixedPitch(False)
                merged.setFontFamilies(FAMILIES)
                merged.setForeground(self._theme.color("accent"))
                merged.setBackground(self._theme.color("accent_soft"))
            cursor.setPosition(piece.position())
            cursor.setPosition(piece.position() + piece.length(), QTextCursor.MoveMode.KeepAnchor)
            cursor.mergeCharFormat(merged)

    def loadResource(self, type: int, name: QUrl | str) -> Any:
        if type != QTextDocument.ResourceType.ImageResource.value:
            return super().loadResource(type, name)
        image = QImage(str(self._folder / QUrl(name).path()))
        if image.isNull():
            return image
        sharp = self.devicePixelRatioF()
        room = max(1, self.viewport().width() - 2 * MARGIN)
        wide = round(min(image.width(), room) * sharp)
        image = image.scaledToWidth(wide, Qt.TransformationMode.SmoothTransformation)
        image.setDevicePixelRatio(sharp)
        return image

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            at = self.verticalScrollBar().value()
            self.show_text(self._text)
            self.verticalScrollBar().setValue(at)


def _pieces(block: QTextBlock) -> list[QTextFragment]:
    return [at.fragment() for at in cast(Iterable[Any], block)]


class TutorialWindow(QWidget):
    """Beside the window in which it is done; Esc closes it.

    page: the tutorial's file, its pictures beside it. settings: where one was, and it was.
    """

    def __init__(self, page: Path, theme: Theme, settings: QSettings, parent: QWidget) -> None:
        super().__init__(parent, Qt.WindowType.Tool)
        self._settings = settings
        self.step = 0
        self.steps = steps(page.read_text(encoding="utf-8"))
        self.setProperty("role", "help")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setWindowTitle(self.tr("Tutorial"))
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 12, 0, 12)
        column.setSpacing(8)
        self.title = QLabel()
        self.title.setFont(font(15, QFont.Weight.DemiBold))
        self.title.setWordWrap(True)
        self.title.setContentsMargins(MARGIN, 0, MARGIN, 0)
        column.addWidget(self.title)
        self.pages = TutorialPages(page.parent, theme)
        self.pages.setAccessibleName(self.tr("Tutorial"))
        column.addWidget(self.pages, 1)
        foot = QHBoxLayout()
        foot.setContentsMargins(MARGIN, 0, MARGIN, 0)
        foot.setSpacing(8)
        self.back = IconButton(theme, "left", self.tr("The step before"), "text2")
        self.back.clicked.connect(lambda: self.show_step(self.step - 1))
        foot.addWidget(self.back)
        self.where = QLabel()
        self.where.setProperty("role", "hint")
        foot.addWidget(self.where)
        foot.addStretch(1)
        self.next = QPushButton(self.tr("Next step"))
        self.next.setToolTip(self.tr("What is to be done then"))
        self.next.clicked.connect(lambda: self.show_step(self.step + 1))
        foot.addWidget(self.next)
        column.addLayout(foot)
        step = settings.value(STEP, 0, int)
        self.show_step(step if isinstance(step, int) else 0)
        kept = settings.value(GEOMETRY)
        if kept is None or not self.restoreGeometry(kept):
            self.resize(self.sizeHint())
            self.move(self._beside(parent))

    def sizeHint(self) -> QSize:
        return QSize(px(WIDE), px(HIGH))

    def _beside(self, parent: QWidget) -> QPoint:
        """To the right of the window; without room there over the drawing: the forms stay free."""
        corner = parent.mapToGlobal(parent.rect().topRight())
        if corner.x() + self.width() <= parent.screen().availableGeometry().right():
            return corner
        return QPoint(corner.x() - self.width() - px(FORMS), corner.y() + px(BELOW))

    def show_step(self, step: int) -> None:
        """Shows a step of those that there are, counted from 0, and keeps it for the next time."""
        self.step = min(max(0, step), len(self.steps) - 1)
        self._settings.setValue(STEP, self.step)
        shown = self.steps[self.step]
        self.title.setText(shown.title)
        self.pages.show_text(shown.text)
        self.pages.verticalScrollBar().setValue(0)
        last = len(self.steps) - 1
        self.where.setText(
            self.tr("Step {0} of {1}").format(self.step, last)
            if self.step
            else self.tr("{0} steps").format(last)
        )
        self.back.setEnabled(self.step > 0)
        self.next.setEnabled(self.step < last)
        self.next.setText(self.tr("Next step") if self.step else self.tr("Begin"))

    def set_theme(self, theme: Theme) -> None:
        retheme(self, theme)
        self.pages.set_theme(theme)

    def hideEvent(self, event: QHideEvent) -> None:
        """Where it was is kept for the next time."""
        super().hideEvent(event)
        self._settings.setValue(GEOMETRY, self.saveGeometry())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.close()
        else:
            super().keyPressEvent(event)
