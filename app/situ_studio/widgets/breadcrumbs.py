"""Where one is in parts of parts: ``reception › register``; each name but the last leads back."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QWidget

from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.widgets.layouts import clear


class Breadcrumbs(QFrame):
    """asked: the level to go back to, 0 for the outermost. Hidden where there is only one."""

    asked = Signal(int)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "crumbs")
        self.setAccessibleName(self.tr("Way into the part"))
        self.setFixedHeight(px(32))
        self._names: tuple[str, ...] = ()
        self._line = QHBoxLayout(self)
        self._line.setContentsMargins(8, 0, 8, 0)
        self._line.setSpacing(2)
        self.set_theme(theme)
        self.hide()

    def set_theme(self, theme: Theme) -> None:
        self.setStyleSheet(
            f"Breadcrumbs {{ background: {theme.panel}; border: none;"
            f" border-bottom: 1px solid {theme.line}; }}"
            f"QPushButton {{ color: {theme.accent}; background: transparent; border: 2px solid"
            " transparent; border-radius: 4px; padding: 2px 6px; }"
            f"QPushButton:hover {{ background: {theme.hover}; }}"
            f"QPushButton:focus {{ border-color: {theme.accent}; }}"
            f"QLabel {{ color: {theme.text3}; background: transparent; border: 2px solid"
            " transparent; padding: 2px 6px; }"
            f"QLabel#here {{ color: {theme.text}; font-weight: 600; }}"
        )

    def show_way(self, names: tuple[str, ...]) -> None:
        """The names from the outermost application to the one that is shown."""
        self.setVisible(len(names) > 1)
        if names == self._names:
            return
        self._names = names
        clear(self._line)
        for level, name in enumerate(names[:-1]):
            button = QPushButton(name)
            button.setCursor(Qt.CursorShape.PointingHandCursor)
            button.setToolTip(self.tr("Back to {0}").format(name))
            button.setAccessibleName(button.toolTip())
            button.clicked.connect(lambda _=False, at=level: self.asked.emit(at))
            self._line.addWidget(button)
            self._line.addWidget(QLabel("›"))
        if names:
            here = QLabel(names[-1])
            here.setObjectName("here")
            self._line.addWidget(here)
        self._line.addStretch(1)

    def button(self, name: str) -> QPushButton:
        """The button that leads back to ``name``; LookupError where there is none."""
        for button in self.findChildren(QPushButton):
            if button.text() == name and not button.isHidden():
                return button
        raise LookupError(name)
