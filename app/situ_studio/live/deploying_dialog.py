"""Deploy: what the robot would do differently, how far it is, and which versions there were."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QDialog,
    QFrame,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QProgressBar,
    QPushButton,
    QSpinBox,
    QTreeWidget,
    QVBoxLayout,
    QWidget,
)

from situ_studio.assistive.heard_cells import HeardRow
from situ_studio.live import deploying_words
from situ_studio.live.deploying import Deploying
from situ_studio.live.deploying_plan import Plan
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Flag
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ.blackboard.replies import Turn

MOST = 500
"""Changes that are listed."""
USUAL = 30
"""Seconds after which the robot waits no longer, where a person does not want it to."""


class DeployDialog(QDialog):
    """planned: gives what would be sent as things are now; None while the robot has not told what
    it runs. ``settle`` shows everything as it is.
    """

    theirs_asked = Signal()
    """A person wants to look at what the robot runs."""

    def __init__(
        self,
        deploying: Deploying,
        planned: Callable[[], Plan | None],
        theme: Theme,
        parent: QWidget,
    ) -> None:
        super().__init__(parent)
        self._deploying = deploying
        self._planned = planned
        self._plan: Plan | None = None
        self._shown: tuple[Turn, ...] = ()
        self.setWindowTitle(self.tr("Deploy"))
        self.resize(px(720), 600)
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 16)
        column.setSpacing(8)
        self.hindered = QLabel()
        self.hindered.setWordWrap(True)
        self.hindered.setTextFormat(Qt.TextFormat.PlainText)
        self.hindered.setProperty("role", "refused")
        self.changes = QListWidget()
        self.changes.setWordWrap(True)
        self.changes.setFrameShape(QFrame.Shape.NoFrame)
        column.addWidget(self._titled(self.tr("What the robot will do differently"), self.changes))
        column.addWidget(self._boxed(self.changes), 2)
        column.addWidget(self.hindered)
        column.addLayout(self._when(theme))
        self.versions = QTreeWidget()
        self.versions.setRootIsDecorated(False)
        self.versions.setFrameShape(QFrame.Shape.NoFrame)
        self.versions.setHeaderLabels([self.tr("When"), self.tr("What"), self.tr("Who")])
        self.versions.itemSelectionChanged.connect(self._settle_buttons)
        column.addWidget(self._titled(self.tr("Versions on the robot"), self.versions))
        column.addWidget(self._boxed(self.versions), 2)
        self.stands = QLabel()
        self.stands.setWordWrap(True)
        self.stands.setTextFormat(Qt.TextFormat.PlainText)
        self.stands.setProperty("role", "medium")
        self.stands.setAccessibleName(self.tr("How far it is"))
        column.addWidget(self.stands)
        self.progress = QProgressBar()
        self.progress.setTextVisible(False)
        self.progress.setFixedHeight(px(4))
        column.addWidget(self.progress)
        column.addLayout(self._buttons())
        deploying.changed.connect(self._on_deploying)

    # -- building ------------------------------------------------------------

    def _titled(self, title: str, named: QWidget) -> QLabel:
        label = QLabel(title)
        label.setProperty("role", "strong")
        named.setAccessibleName(title)
        return label

    def _boxed(self, inner: QWidget) -> QFrame:
        box = QFrame()
        box.setProperty("role", "box")
        room = QVBoxLayout(box)
        room.setContentsMargins(4, 4, 4, 4)
        room.addWidget(inner)
        return box

    def _when(self, theme: Theme) -> QHBoxLayout:
        line = QHBoxLayout()
        self.force = Flag(theme, self.tr("Do not wait for a safe point longer than"))
        self.force.setToolTip(
            self.tr("The robot waits until no action runs; what runs then is broken off.")
        )
        self.seconds = QSpinBox()
        self.seconds.setRange(0, 3600)
        self.seconds.setValue(USUAL)
        self.seconds.setSuffix(self.tr(" s"))
        self.seconds.setAccessibleName(self.force.text())
        self.seconds.setEnabled(False)
        self.force.toggled.connect(self.seconds.setEnabled)
        line.addWidget(self.force)
        line.addWidget(self.seconds)
        line.addStretch(1)
        return line

    def _buttons(self) -> QHBoxLayout:
        line = QHBoxLayout()
        self.back = QPushButton()
        self.back.clicked.connect(self._on_back)
        self.stop = QPushButton(self.tr("Stop"))
        self.stop.clicked.connect(self._deploying.stop)
        self.close_button = QPushButton(self.tr("Close"))
        self.close_button.clicked.connect(self.close)
        self.deploy = QPushButton(self.tr("Deploy"))
        self.deploy.setProperty("role", "filled")
        self.deploy.clicked.connect(self._on_deploy)
        self.theirs = QPushButton(self.tr("Open the robot's version…"))
        self.theirs.setToolTip(self.tr("As a project of its own, in a window of its own."))
        self.theirs.clicked.connect(self.theirs_asked)
        line.addWidget(self.back)
        line.addWidget(self.theirs)
        line.addStretch(1)
        for button in (self.stop, self.close_button, self.deploy):
            line.addWidget(button)
        for button in (self.back, self.theirs, self.stop, self.close_button):
            button.setAutoDefault(False)
        self.deploy.setDefault(True)
        return line

    # -- what a person does ----------------------------------------------------

    @property
    def force_after(self) -> float | None:
        """Seconds that the robot may wait at most."""
        return float(self.seconds.value()) if self.force.isChecked() else None

    def _on_deploy(self) -> None:
        if self._plan is not None:
            self._deploying.deploy(self._plan.files, self._plan.main, self.force_after)

    def _on_back(self) -> None:
        self._deploying.rollback(self._back_to, self.force_after)

    @property
    def _back_to(self) -> int | None:
        """The version of the chosen row; None: the one that ran before."""
        turns = self._deploying.turns
        for item in self.versions.selectedItems():
            number = int(item.data(0, Qt.ItemDataRole.UserRole))
            if turns is not None and number in turns.kept and number != turns.version:
                return number
        return None

    # -- bringing it up to date ----------------------------------------------------

    def settle(self) -> None:
        """The documents here or the robot's are others."""
        self._plan = plan = self._planned()
        self.changes.clear()
        if plan is None:
            words = self.tr("The robot has not told yet what it runs.")
            if not self._deploying.is_connected:
                words = self.tr("The robot is not there: what differs is told when it is.")
            self.changes.addItem(words)
        elif plan.changes:
            several = len({change.file for change in plan.changes}) > 1
            for change in plan.changes[:MOST]:
                text = said(change.text)
                self.changes.addItem(f"{change.file}: {text}" if several else text)
            if len(plan.changes) > MOST:
                more = self.tr("and {0} more").format(len(plan.changes) - MOST)
                self.changes.addItem(more)
        elif plan.files:
            self.changes.addItem(self.tr("It will act the same; its media may differ."))
        hindrances = list(plan.hindrances[:5]) if plan is not None else []
        if not self._deploying.is_allowed:
            only = self.tr("Only an operator may deploy: your key lets you look only.")
            hindrances = [only]
        self.hindered.setText("\n".join(hindrances))
        self.hindered.setVisible(bool(self.hindered.text()))
        self._on_deploying()

    def _on_deploying(self) -> None:
        deploying = self._deploying
        self.stands.setText(deploying_words.standing(deploying))
        sending = deploying.stands == "sending" and deploying.size > 0
        self.progress.setRange(0, 1000 if sending else 0)
        if sending:
            self.progress.setValue(round(1000 * deploying.sent / deploying.size))
        self.progress.setVisible(deploying.is_on_its_way)
        self._show_versions()
        self._settle_buttons()

    def _show_versions(self) -> None:
        turns = self._deploying.turns
        rows = turns.turns if turns is not None else ()
        if rows == self._shown:
            return
        self._shown = rows
        self.versions.clear()
        for one in reversed(rows):
            item = HeardRow(deploying_words.turn(one))
            item.setData(0, Qt.ItemDataRole.UserRole, one.version)
            if one.changed:
                item.setToolTip(1, "\n".join(map(said, one.changed)))
            self.versions.addTopLevelItem(item)
        for at in (0, 1):
            self.versions.resizeColumnToContents(at)

    def _settle_buttons(self) -> None:
        deploying, plan, turns = self._deploying, self._plan, self._deploying.turns
        busy = deploying.is_on_its_way
        may = deploying.is_allowed and not busy
        self.deploy.setEnabled(bool(plan and plan.files and not plan.hindrances) and may)
        self.stop.setVisible(busy)
        self.theirs.setEnabled(plan is not None)
        to = self._back_to
        words = self.tr("Roll back to version {0}").format(to) if to is not None else ""
        self.back.setText(words or self.tr("Roll back"))
        others = turns is not None and any(one != turns.version for one in turns.kept)
        self.back.setEnabled(others and may)
