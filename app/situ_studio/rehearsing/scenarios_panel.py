"""Scenarios: which went well, where the others failed, and what none of them came through."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from situ.rehearse.coverage import Coverage, Seen
from situ.rehearse.suite import Failed, Played
from situ_studio.looks.theme import Theme
from situ_studio.panels.empty import EmptyHint
from situ_studio.panels.table import Row, RowsTable
from situ_studio.rehearsing.scenario_run import Ran, ScenarioRun
from situ_studio.widgets.icon_widgets import ThemedButton, retheme
from situ_studio.wording.language import said, tr


class ScenariosPanel(QWidget):
    """``looked``: a scenario shall be looked at, where it failed first; ``gone``: a place that
    none came through, as (file, place).
    """

    run_asked = Signal()
    paint_asked = Signal(bool)
    looked = Signal(object)
    gone = Signal(str, tuple)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._ran: dict[str, Ran] = {}
        self._lacking: dict[str, Seen] = {}
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        line = QHBoxLayout()
        line.setContentsMargins(12, 4, 12, 4)
        line.setSpacing(8)
        self.run = ThemedButton(theme, "play", self.tr("Run all"), "mend", "accent", 14)
        self.run.setToolTip(self.tr("Each is done from the start, with the project as it is now"))
        self.run.clicked.connect(self.run_asked)
        line.addWidget(self.run)
        self.paint = QPushButton(self.tr("Paint"))
        self.paint.setProperty("role", "mend")
        self.paint.setCheckable(True)
        self.paint.setToolTip(
            self.tr("How often they came through each state and transition, on the drawings")
        )
        self.paint.clicked.connect(self.paint_asked)
        line.addWidget(self.paint)
        self.summary = QLabel()
        self.summary.setProperty("role", "label")
        line.addWidget(self.summary, 1)
        column.addLayout(line)
        titles = (self.tr("Scenario"), self.tr("Result"), self.tr("Expected"), self.tr("Where"))
        self.table = RowsTable(self.tr("Scenarios"), titles, (220, 110, 80), theme)
        self.table.rows.tips = (
            self.tr("Its file; below them, what none of them came through."),
            self.tr("Whether all that was expected happened."),
            self.tr("How much was expected."),
            self.tr("Where it failed first. A click shows that moment in all views."),
        )
        self.table.when_chosen(self._on_chosen)
        column.addWidget(self.table, 1)
        self.hint = EmptyHint(
            self.table,
            self.tr(
                "A scenario is what people and sensors do, and what shall happen then. Run all "
                "plays those of this project. A new one is a rehearsal that is saved: press "
                "Rehearse, do what people would do, and then Save as a scenario."
            ),
        )
        self.clear()

    def clear(self) -> None:
        """Nothing has been run yet."""
        self._ran, self._lacking = {}, {}
        self.table.rows.show([])
        self.summary.setText(self.tr("Not run yet"))
        self.paint.setChecked(False)
        self.paint.setEnabled(False)

    def set_theme(self, theme: Theme) -> None:
        self.table.set_theme(theme)
        retheme(self, theme)

    def show_run(self, run: ScenarioRun) -> None:
        """What has been played of it by now."""
        self._ran = {f"ran {one.path}": one for one in run.ran}
        done = len(run.ran) == len(run.files)
        lacking = _lacking(run.coverage) if done else []
        self._lacking = {f"lacks {n}": one for n, one in enumerate(lacking)}
        rows = [_ran_row(key, one.played) for key, one in self._ran.items()]
        rows += [_lack_row(key, one) for key, one in self._lacking.items()]
        self.table.rows.show(rows)
        well = sum(one.played.well for one in run.ran)
        self.summary.setText(
            tr("{0} of {1} well. {2}").format(well, len(run.files), covered_words(run.coverage))
        )
        self.paint.setEnabled(bool(run.ran))

    def _on_chosen(self, key: str) -> None:
        if key in self._ran:
            self.looked.emit(self._ran[key])
        elif key in self._lacking:
            seen = self._lacking[key]
            self.gone.emit(seen.file, tuple(seen.place))


def covered_words(coverage: Coverage) -> str:
    """``Came through 12 of 16 states, 20 of 31 transitions, 4 of 6 situations.``"""
    told = []
    for words, every in (
        (tr("{0} of {1} states"), coverage.states),
        (tr("{0} of {1} transitions"), coverage.transitions),
        (tr("{0} of {1} situations"), coverage.situations),
    ):
        if every:
            told.append(words.format(sum(one.covered for one in every.values()), len(every)))
    return tr("Came through {0}.").format(tr(", ").join(told)) if told else ""


def failed_words(failed: Failed) -> str:
    """Where a scenario failed: ``line 12, 30.2 s: expected enter, state 10``."""
    fields = dict(failed.expected)
    kind = fields.pop("kind", "")
    wanted = tr(", ").join([str(kind), *(f"{name} {value}" for name, value in fields.items())])
    return tr("line {0}, {1} s: expected {2}").format(failed.line, f"{failed.at:g}", wanted)


def _ran_row(key: str, played: Played) -> Row:
    if played.well:
        result, where = tr("✓ well"), ""
    elif played.unreadable is not None:
        result, where = tr("✗ unreadable"), said(played.unreadable)
    else:
        result, where = tr("✗ failed"), failed_words(played.failed[0])
    return Row(key, (played.file, result, str(played.expectations), where), played.well)


def _lacking(coverage: Coverage) -> list[Seen]:
    every: list[Seen] = [*coverage.states.values(), *coverage.transitions.values()]
    return [one for one in (*every, *coverage.situations.values()) if not one.covered]


def _lack_row(key: str, seen: Seen) -> Row:
    return Row(key, (tr("no scenario"), tr("never reached"), "", seen.label))
