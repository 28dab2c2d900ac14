"""The problems of what a row of the project form shows, where it is shown: a sign before it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, QPoint, Qt
from PySide6.QtWidgets import QWidget

from situ.document.problem import Problem
from situ_studio.looks.letters import px
from situ_studio.project_form.boxes import Section
from situ_studio.project_form.going import field_at
from situ_studio.widgets.icon_widgets import IconButton
from situ_studio.wording.language import said, tr

if TYPE_CHECKING:
    from situ_studio.project_form.form import ProjectForm

SIDE = 14


class Sign(IconButton):
    """Tells the problems of one field by its tooltip, and offers their mends when it is pressed."""

    def __init__(self, form: ProjectForm, section: Section, field: QWidget) -> None:
        super().__init__(section.theme, "warning", "", "warning", SIDE, section)
        self._form = form
        self.problems: tuple[Problem, ...] = ()
        self.setFixedSize(px(SIDE + 2), px(SIDE + 8))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.clicked.connect(self._on_clicked)
        self._watched = (section, section.title if field is section else field)
        for one in self._watched:
            one.installEventFilter(self)
        self.show()

    def tell(self, problems: Sequence[Problem]) -> None:
        """Errors first."""
        self.problems = tuple(problems)
        self._token = problems[0].severity
        kinds = {"error": tr("Error"), "warning": tr("Warning")}
        self.show_icon(self._token, "\n".join(said(one.message) for one in problems))
        self.setAccessibleName(
            "; ".join(f"{kinds[one.severity]}: {said(one.message)}" for one in problems)
        )
        self._settle()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kinds = QEvent.Type.Move, QEvent.Type.Resize, QEvent.Type.Show, QEvent.Type.Hide
        if event.type() in kinds:
            self._settle()
        return False

    def end(self) -> None:
        for one in self._watched:
            one.removeEventFilter(self)
        self.hide()
        self.deleteLater()

    def _settle(self) -> None:
        """In the margin of the section, at the height of its field."""
        section, beside = self._watched
        middle = beside.mapTo(section, QPoint(0, min(beside.height(), px(28)) // 2)).y()
        self.move(0, middle - self.height() // 2)

    def _on_clicked(self) -> None:
        at = self.mapToGlobal(QPoint(0, self.height()))
        self._form.mends_asked.emit(self.problems, at)


class Signs:
    """Those of one form."""

    def __init__(self, form: ProjectForm) -> None:
        self._form = form
        self._shown: dict[QWidget, Sign] = {}

    def show_problems(self, problems: Sequence[Problem]) -> None:
        """Signs at the rows that these are about, at the title of a section where it has none."""
        found: dict[QWidget, list[Problem]] = {}
        for problem in sorted(problems, key=lambda one: one.severity):
            # A setting, a row of several fields, has one sign.
            row = problem.place[:2] if problem.place[:1] == ("setting",) else problem.place
            field = field_at(self._form, row)
            if field is not None:
                found.setdefault(field, []).append(problem)
        for field in [one for one in self._shown if one not in found]:
            self._shown.pop(field).end()
        for field, those in found.items():
            if field not in self._shown:
                self._shown[field] = Sign(self._form, _section(field), field)
            self._shown[field].tell(those)

    def at(self, field: QWidget) -> Sign | None:
        """The sign of a field, or of a section."""
        return self._shown.get(field)


def _section(field: QWidget) -> Section:
    found: QWidget | None = field
    while not isinstance(found, Section):
        assert found is not None
        found = found.parentWidget()
    return found
