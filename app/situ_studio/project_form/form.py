"""The page of what a project is: its name, languages and values, section by section."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from situ.document.beside import Toml
from situ.document.folder import LOCAL_FILE, PROJECT_FILE
from situ.document.problem import Problem
from situ.document.project import Project
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Choice
from situ_studio.panels.tabs import Segments
from situ_studio.panels.told import Told
from situ_studio.project_form.applications import ApplicationsSection
from situ_studio.project_form.boxes import Change, FieldsSection, Section
from situ_studio.project_form.checks import inside, named
from situ_studio.project_form.readings import ReadingsSection
from situ_studio.project_form.robot import RobotSection, announces
from situ_studio.project_form.sections import (
    LanguagesSection,
    MqttSection,
    PatternsSection,
    PlacesSection,
    SettingsSection,
    TagsSection,
)
from situ_studio.project_form.signs import Signs

WIDTH = 760


class ProjectForm(QWidget):
    """Shows ``situ.toml``, or ``robot.local.toml`` that is laid over it on one robot."""

    edited = Signal(str, object, str)
    """The file, its value after the change, and the name of the step."""
    refused = Signal(str)
    language_asked = Signal()
    mend_asked = Signal(object)
    """One problem."""
    mends_asked = Signal(object, QPoint)
    """The problems of a field, and where on the screen a menu for them opens."""
    readings_changed = Signal(object, str)
    """As ``ReadingsSection.changed``."""

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "page")
        self._values: dict[str, Toml | None] = {}
        self.file = PROJECT_FILE
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        scroll = QScrollArea()
        scroll.setProperty("role", "page")
        scroll.setWidgetResizable(True)
        scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.area = scroll
        inner = QWidget()
        inner.setProperty("role", "page")
        middle = QHBoxLayout(inner)
        middle.setContentsMargins(24, 16, 24, 24)
        page = QWidget()
        page.setMaximumWidth(px(WIDTH))
        middle.addStretch(1)
        middle.addWidget(page, 100)
        middle.addStretch(1)
        self._column = QVBoxLayout(page)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(12)
        self._column.addLayout(self._head(theme))
        self.told = Told(theme)
        self.told.mend_asked.connect(self.mend_asked)
        self._column.addWidget(self.told)
        self.sections: dict[str, Section] = self._make(theme)
        for section in self.sections.values():
            section.edited.connect(self._on_edited)
            section.refused.connect(self.refused)
            self._column.addWidget(section)
        self.readings = ReadingsSection(theme)
        self.readings.changed.connect(self.readings_changed)
        self.readings.refused.connect(self.refused)
        self._column.insertWidget(self._column.indexOf(self.sections["robot"]), self.readings)
        self._column.addStretch(1)
        self.signs = Signs(self)
        scroll.setWidget(inner)
        column.addWidget(scroll)

    def _head(self, theme: Theme) -> QHBoxLayout:
        line = QHBoxLayout()
        self.title = QLabel()
        self.title.setProperty("role", "section")
        line.addWidget(self.title, 1)
        self.which = Segments(
            theme,
            ((PROJECT_FILE, "", self.tr("Every robot")), (LOCAL_FILE, "", self.tr("This robot"))),
            self.tr("Where it counts"),
        )
        self.which.button(LOCAL_FILE).setToolTip(
            self.tr("What is other on this robot than in the project; it is not deployed.")
        )
        self.which.show_choice(PROJECT_FILE)
        self.which.chosen.connect(self.show_file)
        line.addWidget(self.which)
        return line

    def _make(self, theme: Theme) -> dict[str, Section]:
        self.applications = ApplicationsSection(theme)
        self.robot = RobotSection(
            theme,
            self.tr("Robot"),
            "",
            (
                (
                    "robot",
                    "endpoint",
                    self.tr("Address"),
                    self.tr("Where it is reached, such as tcp://127.0.0.1:5570"),
                    named,
                ),
                (
                    "robot",
                    "adapter",
                    self.tr("Adapter"),
                    self.tr("What drives it: sim is the simulated robot"),
                    named,
                ),
            ),
        )
        languages = LanguagesSection(theme)
        languages.language_asked.connect(self.language_asked)
        return {
            "project": FieldsSection(
                theme,
                self.tr("Project"),
                "",
                (
                    ("project", "name", self.tr("Name"), self.tr("What it is called"), named),
                    (
                        "project",
                        "media",
                        self.tr("Media folder"),
                        self.tr("Pictures, movies and sounds"),
                        inside,
                    ),
                    (
                        "project",
                        "scenarios",
                        self.tr("Scenario folder"),
                        self.tr("What is played as a test"),
                        inside,
                    ),
                ),
            ),
            "applications": self.applications,
            "languages": languages,
            "robot": self.robot,
            "tags": TagsSection(
                theme,
                self.tr(
                    "What stands on the blackboard before anything happens, such as the language "
                    "or the address of a service."
                ),
            ),
            "settings": SettingsSection(theme),
            "durable": PatternsSection(
                theme,
                "durable",
                "tags",
                self.tr("Kept when the robot restarts"),
                self.tr("Values that outlive a restart: medication.* is all below medication."),
            ),
            "private": PatternsSection(
                theme,
                "privacy",
                "private",
                self.tr("Private"),
                self.tr("Shown as ••• to all but operators in traces and recordings."),
            ),
            "places": PlacesSection(theme),
            "mqtt": MqttSection(theme),
        }

    def set_theme(self, theme: Theme) -> None:
        """``retheme`` does the rest."""
        self.told.set_theme(theme)
        for field in self.findChildren(Choice):
            field.set_theme(theme)

    # -- showing -----------------------------------------------------------------

    def show_project(
        self, project: Project, value: Callable[[str], Any], problems: Callable[[str], Any]
    ) -> None:
        """Shows the files as they are now. value: of a file; problems: those of one."""
        self.title.setText(project.name)
        self.readings.show_project(project)
        for file in (PROJECT_FILE, LOCAL_FILE):
            found = value(file)
            self._values[file] = found if isinstance(found, Toml) else None
        self._problems: dict[str, tuple[Problem, ...]] = {
            file: tuple(problems(file)) for file in (PROJECT_FILE, LOCAL_FILE)
        }
        self.applications.show_applications(project.applications)
        self._settle()

    def show_file(self, file: str) -> None:
        """Shows what counts everywhere, or on this robot."""
        self.file = file
        self.which.show_choice(file)
        self._settle()

    def _settle(self) -> None:
        toml = self._values.get(self.file)
        tables = tomllib.loads(toml.text) if toml is not None else {}
        local = self.file == LOCAL_FILE
        project = self._values.get(PROJECT_FILE) if local else None
        everywhere = tomllib.loads(project.text) if project is not None else {}
        self.robot.everywhere = announces(everywhere, True)
        self.readings.setVisible(not local)
        for name, section in self.sections.items():
            section.setVisible(not local or name in ("robot", "tags", "places", "mqtt"))
            section.show_tables(tables)
        problems = self._problems.get(self.file, ())
        self.told.show_problems(problems)
        self.signs.show_problems(problems)

    def begin(self) -> None:
        """Gives the first field the focus."""
        first = self.sections["project"]
        assert isinstance(first, FieldsSection)
        first.fields["project", "name"].setFocus()

    # -- changes -----------------------------------------------------------------

    def _on_edited(self, change: Change, words: str) -> None:
        before = self._values.get(self.file) or Toml("")
        after = change(before)
        if after != before:
            self.edited.emit(self.file, after, words)
        # What was refused, or is the same, stands there as it was.
        self._settle()
