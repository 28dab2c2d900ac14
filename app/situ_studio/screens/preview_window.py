"""The screen as a person sees it, as large as the robot's, or as fits: it can be used."""

from __future__ import annotations

from functools import partial
from pathlib import Path

from PySide6.QtCore import QPoint, QSize, Qt
from PySide6.QtWidgets import QDialog, QFrame, QHBoxLayout, QLabel, QMenu, QVBoxLayout, QWidget

from situ_studio.edits import words
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.screens.devices import Device
from situ_studio.screens.measures import measures
from situ_studio.screens.preview_page import PreviewPage
from situ_studio.screens.walk import Walk
from situ_studio.widgets.icon_widgets import Elided, IconButton, ThemedButton

SHARE = 0.94
"""Of the desk's room, at most."""
BAR = 44


class PreviewWindow(QDialog):
    """Esc closes it. Below the screen stands what the last press did, and the way back."""

    def __init__(
        self,
        theme: Theme,
        device: Device,
        walk: Walk,
        media: Path | None,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Preview, {0}").format(device.words))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.walk = walk
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        self.page = PreviewPage(theme, walk, media)
        self.page.show_device(QSize(device.wide, device.high))
        # What lies on a screen that is very high does not fill it.
        column.addStretch(1)
        column.addWidget(self.page)
        column.addStretch(1)
        column.addWidget(self._bar(theme))
        self.page.walked.connect(self._settle)
        ground = measures().colour("ground").name()
        self.setStyleSheet(f"PreviewWindow {{ background: {ground}; }}")
        room = self.screen().availableSize() * SHARE
        below = QSize(0, px(BAR))
        size = fitting(QSize(device.wide, device.high), room - below)
        self.setFixedSize(size + below)
        self._settle()
        self.page.setFocus()

    def _bar(self, theme: Theme) -> QFrame:
        bar = QFrame()
        bar.setProperty("role", "panel")
        bar.setFixedHeight(px(BAR))
        line = QHBoxLayout(bar)
        line.setContentsMargins(12, 0, 16, 0)
        line.setSpacing(8)
        self.back = IconButton(theme, "left", self.tr("One step back"), "text2", 16)
        self.back.clicked.connect(self._go_back)
        line.addWidget(self.back)
        self.here = QLabel()
        self.here.setProperty("role", "heading")
        line.addWidget(self.here)
        self.said = Elided("", "label")
        line.addWidget(self.said, 1)
        self.others = ThemedButton(theme, "down", self.tr("Go on"), "", "text3", 12)
        self.others.setLayoutDirection(Qt.LayoutDirection.RightToLeft)
        self.others.setToolTip(self.tr("What else leads on from here than a press"))
        self.others.clicked.connect(self._offer)
        line.addWidget(self.others)
        self.left_out = QLabel(self.tr("Conditions and times are left out"))
        self.left_out.setProperty("role", "hint")
        self.left_out.setToolTip(
            self.tr("Of several events of one name the first is taken, and nothing is spoken.")
        )
        line.addWidget(self.left_out)
        return bar

    def _settle(self) -> None:
        walk = self.walk
        self.back.setEnabled(walk.can_go_back)
        self.here.setText(words.state_words(walk.application, walk.no))
        self.said.setText(walk.said or self.tr("Press what is on the screen; Esc closes"))
        self.others.setEnabled(bool(walk.others()))
        # On a phone there is room for what happens, not for what does not.
        self.left_out.setVisible(self.width() > 620)

    def _offer(self) -> None:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        for event, to in self.walk.others():
            name = event or self.tr("The time runs out")
            action = menu.addAction(f"{name}  ›  {to}".replace("&", "&&"))
            action.triggered.connect(partial(self._go_on, event))
        menu.popup(self.others.mapToGlobal(QPoint(0, -menu.sizeHint().height())))

    def _go_on(self, event: str, _checked: bool = False) -> None:
        self.walk.go_on(event)
        self.page.bring()

    def _go_back(self) -> None:
        self.walk.back()
        self.page.bring()


def fitting(size: QSize, room: QSize) -> QSize:
    """That size, or the largest of its shape that there is room for."""
    scale = min(1.0, room.width() / size.width(), room.height() / size.height())
    return QSize(round(size.width() * scale), round(size.height() * scale))
