"""Which event to raise at a robot: one that is expected there now, or any other."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QDialog,
    QFrame,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QVBoxLayout,
    QWidget,
)

from situ.decide.expected import Expectation
from situ.document import words
from situ_studio.looks.letters import px
from situ_studio.panels.fields import Line
from situ_studio.widgets.dialog_buttons import add_buttons
from situ_studio.wording.language import said, tr

NAME = Qt.ItemDataRole.UserRole


class Offer(Struct, frozen=True):
    """An event that is expected now. about: what is known of it, in words."""

    name: str
    about: str


def offers(expected: Mapping[str, Expectation], application: str | None) -> list[Offer]:
    """What one application expects, or all of them, each event once: what would be taken now goes
    first, else as the robot tells it.
    """
    found: dict[str, tuple[bool, Offer]] = {}
    for name, one in expected.items():
        if application is not None and name != application:
            continue
        for event in one.events:
            if not event.holds and event.when:
                about = tr("not now: {0}").format("; ".join(said(when) for when in event.when))
            else:
                about = ", ".join(words.quoted(phrase) for phrase in dict.fromkeys(event.says))
            if event.holds or event.name not in found:
                found[event.name] = (event.holds, Offer(event.name, about))
    return [offer for _, offer in sorted(found.values(), key=lambda one: not one[0])]


class RaisingDialog(QDialog):
    """``event_name``: the answer as it stands. usual: what is offered first. known: every event
    that the project names, which the field completes.
    """

    def __init__(
        self, offered: list[Offer], usual: str, known: tuple[str, ...], parent: QWidget
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Raise an event"))
        self.resize(px(440), px(360))
        column = QVBoxLayout(self)
        title = QLabel(self.tr("Expected now") if offered else self.tr("Nothing is expected now"))
        title.setProperty("role", "strong")
        column.addWidget(title)
        self.list = QListWidget()
        self.list.setAccessibleName(self.tr("Events that are expected now"))
        for offer in offered:
            text = f"{offer.name}   {offer.about}" if offer.about else offer.name
            item = QListWidgetItem(text)
            item.setData(NAME, offer.name)
            self.list.addItem(item)
        self.list.itemSelectionChanged.connect(self._on_picked)
        self.list.itemActivated.connect(lambda _: self.accept())
        self.list.setFrameShape(QFrame.Shape.NoFrame)
        box = QFrame()
        box.setProperty("role", "box")
        inner = QVBoxLayout(box)
        inner.setContentsMargins(1, 1, 1, 1)
        inner.addWidget(self.list)
        column.addWidget(box, 1)
        label = QLabel(self.tr("Event"))
        label.setProperty("role", "strong")
        column.addWidget(label)
        self.line = Line()
        self.line.setText(usual)
        self.line.selectAll()
        self.line.setAccessibleName(self.tr("Event"))
        self.line.complete_from(tuple(dict.fromkeys([*(o.name for o in offered), *known])))
        self.line.textChanged.connect(self._settle)
        column.addWidget(self.line)
        self.raise_button = add_buttons(self, column, self.tr("Raise"), self.accept)
        self.line.setFocus()
        self._settle()

    @property
    def event_name(self) -> str:
        return self.line.text().strip()

    def _on_picked(self) -> None:
        items = self.list.selectedItems()
        if items:
            self.line.setText(items[0].data(NAME))

    def _settle(self) -> None:
        self.raise_button.setEnabled(bool(self.event_name))
