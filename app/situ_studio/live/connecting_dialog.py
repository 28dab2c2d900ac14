"""Which robot to connect to: one that announces itself in the network, or an address."""

from __future__ import annotations

import html

from msgspec import Struct
from PySide6.QtCore import QModelIndex, QSize, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QFrame,
    QHeaderView,
    QLabel,
    QLineEdit,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from situ_studio.assistive.heard_cells import HeardRow
from situ_studio.live.nearby import Found, NearbyRobots
from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.widgets.dialog_buttons import add_buttons
from situ_studio.wording.language import said, tr

NAME, ADDRESS, STANDING = range(3)


class Chosen(Struct, frozen=True):
    """A robot's address. key: the fingerprint of the public key that it announced; "" where it
    has none, or where a person gave the address."""

    endpoint: str
    key: str = ""


class ConnectDialog(QDialog):
    """``chosen``: the answer as it stands. usual: the address that is offered first.

    nearby is followed until the dialog has been answered.
    """

    def __init__(self, usual: str, nearby: NearbyRobots, theme: Theme, parent: QWidget) -> None:
        super().__init__(parent)
        self._nearby = nearby
        self._theme = theme
        self._rows: dict[str, QTreeWidgetItem] = {}
        self._taken: str | None = None
        """The address that was taken from the list."""
        self.setWindowTitle(self.tr("Connect to a robot"))
        self.resize(px(640), px(440))
        column = QVBoxLayout(self)
        column.addWidget(self._titled(self.tr("Found in the network")))
        column.addWidget(self._listed(), 1)
        self.told = QLabel()
        self.told.setProperty("role", "words")
        self.told.setTextFormat(Qt.TextFormat.PlainText)
        self.told.setWordWrap(True)
        # Two lines, so that nothing moves when there is more to say.
        self.told.setMinimumHeight(2 * self.told.fontMetrics().lineSpacing())
        self.told.setAlignment(Qt.AlignmentFlag.AlignTop)
        column.addWidget(self.told)
        column.addWidget(self._titled(self.tr("Address")))
        self.address = QLineEdit(usual)
        self.address.setAccessibleName(self.tr("Address"))
        self.address.selectAll()
        self.address.textChanged.connect(self._settle)
        column.addWidget(self.address)
        self.connect_button = add_buttons(self, column, self.tr("Connect"), self.accept)
        self.address.setFocus()
        nearby.changed.connect(self._on_changed)
        self.finished.connect(nearby.stop)
        self._on_changed()
        nearby.start()

    def _titled(self, title: str) -> QLabel:
        label = QLabel(title)
        label.setProperty("role", "strong")
        return label

    def _listed(self) -> QFrame:
        self.list = _Robots()
        self.list.setRootIsDecorated(False)
        self.list.setFrameShape(QFrame.Shape.NoFrame)
        self.list.setIconSize(QSize(px(16), px(16)))
        self.list.setAccessibleName(self.tr("Robots found in the network"))
        self.list.setHeaderLabels([self.tr("Robot"), self.tr("Address"), self.tr("Connecting")])
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        header = self.list.header()
        header.setSectionResizeMode(NAME, QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(ADDRESS, QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(STANDING, QHeaderView.ResizeMode.ResizeToContents)
        header.setStretchLastSection(False)
        self.list.itemSelectionChanged.connect(self._on_picked)
        self.list.itemActivated.connect(self._on_activated)
        box = QFrame()
        box.setProperty("role", "box")
        inner = QVBoxLayout(box)
        inner.setContentsMargins(1, 1, 1, 1)
        inner.addWidget(self.list)
        return box

    @property
    def chosen(self) -> Chosen:
        """What stands in the field; as the robot that it was taken from, unless it was changed."""
        endpoint, robot = self.address.text().strip(), self._picked()
        same = robot is not None and robot.endpoint == endpoint
        return Chosen(endpoint, robot.key if same and robot is not None else "")

    # -- the list --------------------------------------------------------------

    def _on_changed(self) -> None:
        robots = self._nearby.robots
        for name in sorted(robots, key=str.casefold):
            item = self._rows.get(name)
            if item is None:
                item = self._rows[name] = HeardRow()
                place = sorted(self._rows, key=str.casefold).index(name)
                self.list.insertTopLevelItem(place, item)
            self._show(item, robots[name])
        self._settle()

    def _show(self, item: QTreeWidgetItem, robot: Found) -> None:
        item.setData(NAME, Qt.ItemDataRole.UserRole, robot.name)
        words = _words(robot.standing)
        for at, text in ((NAME, robot.name), (ADDRESS, robot.endpoint), (STANDING, words)):
            item.setText(at, text)
            # What strangers wrote is never read as a document.
            item.setToolTip(at, f"<p>{html.escape(text)}</p>")
            token = "text3" if robot.standing == "gone" else "text"
            item.setForeground(at, self._theme.color(token))
        name, token = _SIGNS[robot.standing]
        item.setIcon(STANDING, icons.icon(name, self._theme.color(token)))
        if item.isSelected() and self.address.text() == self._taken:
            # It may be asked at another address now.
            self._on_picked()

    def _picked(self) -> Found | None:
        items = self.list.selectedItems()
        if not items:
            return None
        return self._nearby.robots.get(items[0].data(NAME, Qt.ItemDataRole.UserRole))

    def _on_picked(self) -> None:
        robot = self._picked()
        if robot is not None:
            self._taken = robot.endpoint
            self.address.setText(robot.endpoint)
        self._settle()

    def _on_activated(self) -> None:
        self._on_picked()
        self.accept()

    def _settle(self) -> None:
        self.connect_button.setEnabled(bool(self.address.text().strip()))
        robot = self._picked()
        if robot is not None and robot.endpoint == self.address.text().strip():
            self.told.setText(_advice(robot.standing))
        elif self._nearby.failed:
            why = said(self._nearby.failed)
            self.told.setText(self.tr("Robots can not be looked for: {0}").format(why))
        elif not self._rows:
            self.told.setText(
                self.tr(
                    "Looking for robots… One that only its own machine reaches does not "
                    "announce itself."
                )
            )
        else:
            self.told.setText("")


class _Robots(QTreeWidget):
    """The first arrow takes the first row: Qt has it current before anybody has taken it."""

    def keyPressEvent(self, event: QKeyEvent) -> None:
        arrow = event.key() in (Qt.Key.Key_Down, Qt.Key.Key_Up, Qt.Key.Key_Home, Qt.Key.Key_End)
        if arrow and not self.selectedItems():
            self.setCurrentIndex(QModelIndex())
        super().keyPressEvent(event)


_SIGNS = {
    "ready": ("lock", "live"),
    "open": ("warning", "warning"),
    "no-key": ("lock", "text3"),
    "other-key": ("error", "error"),
    "other-version": ("error", "error"),
    "gone": ("unlink", "text3"),
}
"""Icon and colour for how a robot stands."""


def _words(standing: str) -> str:
    return {
        "ready": tr("You have its key"),
        "open": tr("Open to everybody"),
        "no-key": tr("Needs a key you do not have"),
        "other-key": tr("Not the robot you know"),
        "other-version": tr("Another version of Situ"),
        "gone": tr("Gone"),
    }[standing]


def _advice(standing: str) -> str:
    """What follows for a person."""
    return {
        "ready": tr("Only the robot whose key you have can answer, whoever announced it."),
        "open": tr(
            "It runs without keys: whoever is in the network can look, change and deploy, and "
            "nobody can tell whether it is the robot that it says it is."
        ),
        "no-key": tr(
            "Whoever looks after the robot makes you a key, with situ keys add; it goes into "
            "the folder of your keys."
        ),
        "other-key": tr(
            "A robot of this name or address is known here, by another key. Ask whoever looks "
            "after it before you connect."
        ),
        "other-version": tr("Robot and studio do not understand each other: update one of them."),
        "gone": tr("It has said goodbye, or has not been heard of for a minute."),
    }[standing]
