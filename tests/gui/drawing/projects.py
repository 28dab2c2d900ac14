"""A project, drawn by hand from nothing: its applications and parts, script, modules, values."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from pathlib import Path

from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QAbstractButton, QTreeView
from tests.gui.drawing.applications import ApplicationDrawer
from tests.gui.drawing.scripts import ScriptDrawer
from tests.gui.drawing.translations import Translator
from tests.gui.drawing.values import ValuesFiller

from situ.document.modules import Modules
from situ.document.project import Project
from situ.document.rbd import Application
from situ_studio.kinds import TYPES

END = ".rbd.xml"
NEW = "New application…"
ADD = "Add to the project"


class ProjectDrawer(ApplicationDrawer, ScriptDrawer, ValuesFiller, Translator):
    """Begins at the welcome page."""

    def draw_project(self, wanted: Project) -> None:
        self.begin_project(wanted.name)
        for file in wanted.applications:
            self.add_application(file)
        if f"{wanted.name}{END}" not in wanted.applications:
            self.remove_application(wanted.name)
        for file, application in in_order(wanted):
            self.open_in_tree(file.removesuffix(END))
            self.draw(application)
        if wanted.spds is not None and wanted.spds_file is not None:
            self.open_in_tree(wanted.spds_file.removesuffix(".spds.xml"))
            self.draw_script(wanted.spds)
        if wanted.modules is not None:
            self.choose_in_menu("What modules say of themselves", lambda: self.click(ADD))
            self.settle()
            self.draw_information(wanted.modules)
        toml = (Path(wanted.root) / "situ.toml").read_text(encoding="utf-8")
        self.fill_project(tomllib.loads(toml))
        for language, texts in wanted.texts.items():
            self.open_in_tree("texts")
            self.translate(language, texts)

    def begin_project(self, name: str) -> None:
        self.answer(name)
        self.click("New project")

    def add_application(self, file: str) -> None:
        """One of the project's own name is there already."""
        name = file.removesuffix(END)
        if file not in self.window.session.project.applications:
            self.answer(name)
            self.choose_in_menu(NEW, lambda: self.click(ADD))
            self.settle()

    def remove_application(self, name: str) -> None:
        self.run("Applications")
        row = list(self.window.session.project.applications).index(f"{name}{END}")
        button = self.page_buttons("Remove an application")[row]
        self.bring(button)
        self.click_at(button.mapToGlobal(button.rect().center()))

    def page_buttons(self, name: str) -> list[QAbstractButton]:
        form = self.window.pages.page("situ.toml")
        every = [b for b in form.findChildren(QAbstractButton) if b.accessibleName() == name]
        every = [b for b in every if b.isVisible()]
        every.sort(key=lambda b: b.mapToGlobal(QPoint()).y())
        return every

    def open_in_tree(self, name: str) -> None:
        """A document of the project: the last row that is called so, changed or not."""
        tree = self.widget("Project", QTreeView)
        assert isinstance(tree, QTreeView)
        top = tree.model().index(0, 0)
        rows = [tree.model().index(row, 0, top) for row in range(tree.model().rowCount(top))]
        index = next(row for row in reversed(rows) if str(row.data()).removesuffix(" •") == name)
        port = tree.viewport()
        for _ in range(len(rows)):
            spot = tree.visualRect(index).center()
            if port.rect().contains(spot):
                break
            self.turn(port, 120 if spot.y() < 0 else -120)
        self.click_at(port.mapToGlobal(spot))

    def draw_information(self, wanted: Modules) -> None:
        for module in wanted.modules:
            self.press("Module")
            self.fill(
                {
                    "Name": module.name,
                    "Resources": " ".join(module.resources),
                    "Does": module.description,
                }
            )
            for need in module.requires:
                self.press_in_form("Add a need")
                column = "Data" if need.data is not None else "or module"
                self.fill({column: need.data or need.module or ""})
            types = dict(TYPES)
            provided = [
                (p.data, types.get(p.type or "", "–"), p.unit or "") for p in module.provides
            ]
            self.add_rows("Add a datum", provided)


def in_order(wanted: Project) -> Iterator[tuple[str, Application]]:
    """What others run comes after the first that runs it, which begins its file."""
    return iter(wanted.flows.items())
