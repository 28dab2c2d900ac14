"""A module as a row: it asks and gives back, lets a resource do something, and is lost."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QLineEdit, QMenu, QPushButton, QWidget, QWidgetAction

from situ.decide import inputs
from situ.document.values import read
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.widgets.icon_widgets import Elided, IconButton


class ModuleRow(QWidget):
    """``done``: an input that somebody lets the module give."""

    done = Signal(object)

    def __init__(
        self, theme: Theme, name: str, resources: tuple[str, ...], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.name, self.resources = name, resources
        line = QHBoxLayout(self)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(6)
        line.addWidget(Elided(name, "label"), 1)
        asked = self.tr("Asks for {0}; pressed again it gives that back").format(
            ", ".join(resources)
        )
        self.asks = self._button(self.tr("Ask"), self.tr("{0} asks").format(name), asked)
        self.asks.setCheckable(True)
        self.asks.setVisible(bool(resources))
        self.asks.clicked.connect(self._on_asks)
        line.addWidget(self.asks)
        lost = self.tr("It died, or is out of reach: what it asked for and does ends")
        self.lose = self._button(self.tr("Lose"), self.tr("{0} is lost").format(name), lost)
        self.lose.clicked.connect(lambda: self.done.emit(inputs.Lost(name)))
        line.addWidget(self.lose)
        words = self.tr("What {0} lets the robot do").format(name)
        self.more = IconButton(theme, "more", words, "text3", 14)
        self.more.setVisible(bool(resources))
        self.more.clicked.connect(self._open_menu)
        line.addWidget(self.more)

    def show_state(self, asks: bool, there: bool) -> None:
        """Whether it asks for something now, and whether it is there."""
        self.asks.setChecked(asks)
        self.lose.setEnabled(there)

    def _button(self, text: str, name: str, tip: str) -> QPushButton:
        button = QPushButton(text)
        button.setProperty("role", "mend")
        button.setAccessibleName(name)
        button.setToolTip(tip)
        return button

    def _on_asks(self, on: bool) -> None:
        self.done.emit(
            inputs.Acquire(self.name, self.resources) if on else inputs.Abandon(self.name)
        )

    def _open_menu(self) -> None:
        """A line for each resource: what is typed is its command."""
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        for resource in self.resources:
            menu.addAction(self._command(menu, resource))
        menu.popup(self.more.mapToGlobal(self.more.rect().bottomLeft()))

    def _command(self, menu: QMenu, resource: str) -> QWidgetAction:
        line = QLineEdit()
        line.setPlaceholderText(self.tr("{0}: a value").format(resource))
        line.setAccessibleName(self.tr("What {0} shall do").format(resource))
        line.setMinimumWidth(px(160))

        def take() -> None:
            self.done.emit(inputs.Command(self.name, resource, read(line.text())))
            menu.close()

        line.returnPressed.connect(take)
        action = QWidgetAction(menu)
        action.setDefaultWidget(line)
        return action
