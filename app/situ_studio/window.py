"""The main window: canvas in the middle, panels round it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QByteArray, QSettings, Qt, Signal
from PySide6.QtGui import QCloseEvent, QGuiApplication, QPalette, QResizeEvent
from PySide6.QtWidgets import (
    QApplication,
    QDockWidget,
    QFrame,
    QHBoxLayout,
    QLabel,
    QMainWindow,
    QPushButton,
    QSizePolicy,
    QStackedWidget,
    QToolBar,
    QVBoxLayout,
    QWidget,
)

from situ.document.problem import Problem
from situ.document.rbd import Application
from situ_studio import places, words
from situ_studio.actions import Actions
from situ_studio.commands import Commands
from situ_studio.dialogs import Dialogs
from situ_studio.document_view import DocumentView
from situ_studio.edit import Document, Place
from situ_studio.find import FindAnything
from situ_studio.icon_widgets import IconButton, IconLabel, ThemedButton, retheme
from situ_studio.panels.fields import Choice, Flag, Line, Paragraph
from situ_studio.panels.header import PanelHeader
from situ_studio.panels.inspector import Inspector
from situ_studio.panels.outline import Outline
from situ_studio.panels.palette import Palette
from situ_studio.panels.problems import Problems
from situ_studio.panels.project_tree import ProjectTree, look, stem
from situ_studio.robot import RobotSide
from situ_studio.session import Session
from situ_studio.status import Status
from situ_studio.tabs import BottomPanels, DocumentTabs
from situ_studio.theme import DARK, LIGHT, Theme
from situ_studio.theme_qss import qss
from situ_studio.vocabulary import Lexicon
from situ_studio.welcome import Example, Welcome

RECENT = 8
LEFT, RIGHT, BOTTOM = 224, 280, 132
LEFT_SMALL, RIGHT_SMALL = 208, 264
LOW = 860
"""Px of the window's height below which rows are denser."""


class MainWindow(QMainWindow):
    """One window with one session.

    settings: where it was and what it showed; examples: what the welcome page offers.
    """

    shown = Signal()
    """Laid out for the first time."""

    def __init__(
        self,
        session: Session,
        settings: QSettings,
        examples: Callable[[], list[Example]],
        theme: str | None = None,
    ) -> None:
        super().__init__()
        self.session = session
        session.setParent(self)
        self.settings = settings
        self._list_examples = examples
        self.theme_choice = theme or str(settings.value("theme", "system"))
        self.theme = self._chosen_theme()
        self.dialogs: Dialogs = Dialogs(self)
        self.views: dict[str, DocumentView] = {}
        self.current_file: str | None = None
        self._placed = False
        self._lexicon = Lexicon()
        self.setWindowTitle(self.tr("Situ Studio"))
        self.setMinimumSize(800, 500)
        self.setDockOptions(
            QMainWindow.DockOption.AnimatedDocks
            | QMainWindow.DockOption.AllowNestedDocks
            | QMainWindow.DockOption.AllowTabbedDocks
        )
        for corner, area in (
            (Qt.Corner.BottomLeftCorner, Qt.DockWidgetArea.LeftDockWidgetArea),
            (Qt.Corner.BottomRightCorner, Qt.DockWidgetArea.RightDockWidgetArea),
        ):
            self.setCorner(corner, area)
        self.commands = Commands(self)
        self.actions_ = Actions(self.commands, self.theme, self)
        self._build_centre()
        self._build_panels()
        self.status = Status(self.theme)
        self.setStatusBar(self.status)
        self.robot = RobotSide(self)
        self.actions_.fill_menus(self.menuBar())
        self._fill_panels_menu()
        self._build_toolbar()
        self.finder = FindAnything(self.theme, self)
        self._wire()
        self.set_theme(self.theme)
        self._restore()
        self.show_welcome()

    # -- building ------------------------------------------------------------------

    def _build_centre(self) -> None:
        self.stack = QStackedWidget()
        self.welcome = Welcome(self.theme)
        self.stack.addWidget(self.welcome)
        centre = QWidget()
        column = QVBoxLayout(centre)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        self.tabs = DocumentTabs(self.theme)
        column.addWidget(self.tabs)
        self.notice = Notice(self.theme)
        self.notice.hide()
        column.addWidget(self.notice)
        self.documents = QStackedWidget()
        column.addWidget(self.documents, 1)
        self.stack.addWidget(centre)
        self.setCentralWidget(self.stack)

    def _dock(self, name: str, title: str, widget: QWidget, area: Qt.DockWidgetArea) -> QDockWidget:
        dock = QDockWidget(title, self)
        dock.setObjectName(name)
        dock.setWidget(widget)
        self.addDockWidget(area, dock)
        return dock

    def _build_panels(self) -> None:
        theme = self.theme
        left, right = Qt.DockWidgetArea.LeftDockWidgetArea, Qt.DockWidgetArea.RightDockWidgetArea
        self.project_tree = ProjectTree(theme)
        self.outline = Outline(theme)
        self.palette_ = Palette(theme)
        self.inspector = Inspector(theme)
        self.problems = Problems(theme)
        self.bottom = BottomPanels(theme)
        self.bottom.add("problems", self.tr("Problems"), self.problems)
        self.docks: dict[str, QDockWidget] = {}
        headers = {
            "project": PanelHeader(self.tr("Project")),
            "outline": PanelHeader(self.tr("Outline")),
            "palette": PanelHeader(self.tr("Palette"), self.tr("drag onto the canvas")),
        }
        search = IconButton(theme, "search", self.tr("Find in the outline"), "text3", 14)
        search.clicked.connect(self.outline.toggle_search)
        headers["outline"].add(search)
        self._headers = headers
        for name, widget in (
            ("project", self.project_tree),
            ("outline", self.outline),
            ("palette", self.palette_),
        ):
            dock = self._dock(name, headers[name].title.text(), widget, left)
            dock.setTitleBarWidget(headers[name])
            self.docks[name] = dock
        self.docks["inspector"] = self._dock(
            "inspector", self.tr("Inspector"), self.inspector, right
        )
        self.docks["inspector"].setTitleBarWidget(self.inspector.header)
        self.docks["bottom"] = self._dock(
            "bottom",
            self.tr("Problems and more"),
            self.bottom,
            Qt.DockWidgetArea.BottomDockWidgetArea,
        )
        self.docks["bottom"].setTitleBarWidget(self.bottom.strip)

    def _fill_panels_menu(self) -> None:
        menu = self.actions_.menu("View").addMenu(self.tr("Panels"))
        for dock in self.docks.values():
            action = dock.toggleViewAction()
            action.setText(dock.windowTitle())
            menu.addAction(action)

    def _build_toolbar(self) -> None:
        bar = QToolBar(self.tr("Toolbar"))
        bar.setObjectName("toolbar")
        bar.setMovable(False)
        bar.setFloatable(False)
        bar.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
        bar.setFixedHeight(40)
        self.addToolBar(Qt.ToolBarArea.TopToolBarArea, bar)
        self.toolbar = bar
        self.actions_.fill_toolbar(bar, "left")
        bar.addWidget(_spring())
        self.search = ThemedButton(
            self.theme,
            "search",
            self.tr("Find anything, run a command"),
            "search",
            "text3",
            14,
        )
        self.search.setFixedWidth(304)
        line = QHBoxLayout(self.search)
        line.setContentsMargins(0, 0, 7, 0)
        line.addStretch(1)
        keys = QLabel("Ctrl K")
        keys.setProperty("role", "kbd")
        keys.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        line.addWidget(keys, 0, Qt.AlignmentFlag.AlignVCenter)
        self.search.clicked.connect(self.commands.find)
        bar.addWidget(self.search)
        bar.addWidget(_spring())
        self.actions_.fill_toolbar(bar, "right")

    def _wire(self) -> None:
        session = self.session
        session.opened.connect(self._on_opened)
        session.changed.connect(self._on_changed)
        session.selected.connect(self._on_undone)
        session.stack_changed.connect(self._on_stack)
        session.problems_changed.connect(self._on_problems)
        session.changed_on_disk.connect(self._on_disk)
        self.tabs.chosen.connect(self.show_file)
        self.tabs.closed.connect(self.close_file)
        self.tabs.view_chosen.connect(self.show_mode)
        self.project_tree.file_asked.connect(self.open_file)
        self.outline.selected.connect(self._on_outline)
        self.outline.activated.connect(self._on_outline_activated)
        self.palette_.kind_asked.connect(self.commands.insert)
        self.inspector.edited.connect(self._on_form)
        self.inspector.place_asked.connect(self.select)
        self.problems.chosen.connect(self._on_problem)
        self.bottom.folded.connect(lambda _: self._settle_bottom())
        self.status.problems_asked.connect(lambda: self.bottom.choose("problems"))
        self.notice.theirs.connect(self._on_theirs)
        self.notice.mine.connect(self._on_mine)
        welcome = self.welcome
        welcome.new_asked.connect(self.commands.new_project)
        welcome.open_asked.connect(self.commands.open_project)
        welcome.connect_asked.connect(self.commands.connect_robot)
        welcome.recent_asked.connect(self.commands.open_path)
        welcome.example_asked.connect(self.commands.open_example)
        welcome.theme_asked.connect(self.choose_theme)
        hints = QGuiApplication.styleHints()
        hints.colorSchemeChanged.connect(self._on_scheme)

    # -- the project -----------------------------------------------------------------

    @property
    def recent(self) -> list[str]:
        """The folders of the projects that were open lately, the last one first."""
        found: Any = self.settings.value("recent", [])
        every = [found] if isinstance(found, str) else list(found or [])
        return [p for p in every if Path(p).exists()]

    def open_project(self, path: Path) -> None:
        """Opens a project; UsageError, with one line for the user, where it can not be read."""
        self.session.open(path)
        there = str(path.resolve())
        self.settings.setValue("recent", [there, *(p for p in self.recent if p != there)][:RECENT])

    def _on_opened(self) -> None:
        project = self.session.project
        assert project is not None
        for view in self.views.values():
            self.documents.removeWidget(view)
            view.deleteLater()
        self.views = {}
        self.tabs.clear()
        self.current_file = None
        self.notice.hide()
        self.project_tree.show_project(project, self.session.files)
        for dock in self.docks.values():
            dock.show()
        self.stack.setCurrentIndex(1)
        shown = [f for f in self.session.files if f != project.modules_file]
        for file in shown or self.session.files:
            self._add_tab(file)
        self._refresh_tree()
        if self.tabs.files():
            self.tabs.choose(self.tabs.files()[0])
        else:
            self.show_file("")
        self._size_docks()
        shown_view = self.current_view
        if shown_view is not None:
            shown_view.current_view().setFocus()

    def _add_tab(self, file: str) -> None:
        document = self.session.document(file)
        if document is not None:
            icon, token, _ = look(document)
            self.tabs.add(file, stem(file), icon, token)

    def open_file(self, file: str) -> None:
        """Shows a document, in a new tab if it has none."""
        if file not in self.tabs.files():
            self._add_tab(file)
        self.tabs.choose(file)

    def show_file(self, file: str) -> None:
        """Shows the document of a tab."""
        document = self.session.document(file)
        self.current_file = file if document is not None else None
        if document is not None:
            view = self.views.get(file)
            if view is None:
                view = self._make_view(file)
            self.documents.setCurrentWidget(view)
            view.show_document(document, self._problems_of(file))
            self.tabs.views.set_offered(("graph", "outline") if view.has_graph else ("outline",))
            self.tabs.views.setVisible(view.has_graph)
            self.tabs.views.show_choice(view.mode)
        self._settle_title()
        self._settle_problems()
        self.project_tree.show_current(self.current_file)
        self._settle_document()

    def _make_view(self, file: str) -> DocumentView:
        view = DocumentView(self.theme, file)
        view.edited.connect(lambda after, text: self.commit(after, text, file))
        view.selection_changed.connect(self._on_selection)
        view.activated.connect(self._on_activated)
        view.status.connect(self.say)
        self.views[file] = view
        self.documents.addWidget(view)
        return view

    def close_file(self, file: str) -> None:
        """Closes a tab; the document stays in the project, with its changes."""
        self.tabs.remove(file)
        view = self.views.pop(file, None)
        if view is not None:
            self.documents.removeWidget(view)
            view.deleteLater()

    def close_tab(self) -> None:
        if self.current_file is not None and len(self.tabs.files()) > 1:
            self.close_file(self.current_file)

    def show_welcome(self) -> None:
        """Shows the welcome page; an open project stays open."""
        self.welcome.show_recent(self.recent)
        self.welcome.show_connect(self.can_connect)
        self.welcome.show_examples(self._list_examples())
        self.welcome.themes.show_choice(self.theme_choice)
        self.stack.setCurrentIndex(0)
        for dock in self.docks.values():
            dock.hide()
        self.toolbar.hide()
        self.current_file = None
        self.setWindowTitle(self.tr("Situ Studio"))
        self._settle_document()

    # -- what is shown ------------------------------------------------------------------

    @property
    def current_view(self) -> DocumentView | None:
        return self.views.get(self.current_file or "")

    @property
    def current_document(self) -> Document | None:
        return self.session.document(self.current_file or "")

    def show_mode(self, mode: str) -> None:
        """Shows the graph or the outline of the current document."""
        view = self.current_view
        if view is not None:
            view.set_mode(mode)
            self.tabs.views.show_choice(view.mode)
            view.current_view().setFocus()
            self.actions_.refresh()

    def say(self, text: str) -> None:
        """A passing message in the status bar."""
        self.status.say(text)

    def select(self, place: Place) -> None:
        """Selects a place of the current document everywhere."""
        view, document = self.current_view, self.current_document
        if view is None or document is None:
            return
        chosen = (places.nearest(document, place),) if place else ()
        view.select(chosen)
        view.selected = chosen
        self._settle_selection()

    def go_to(self, file: str, place: Place) -> None:
        """Shows a document and a place in it."""
        self.open_file(file)
        self.select(place)
        view = self.current_view
        if view is not None and place:
            view.call("zoom_to", (place,))

    def finish_fields(self) -> None:
        """Lets a field that is being typed into become an edit."""
        focus = QApplication.focusWidget()
        if isinstance(focus, Line):
            focus.on_finished()
        elif isinstance(focus, Paragraph):
            focus.finish()

    # -- changes -----------------------------------------------------------------------

    def commit(self, after: Document, text: str, file: str | None = None) -> None:
        """Makes a new value of a document one named step."""
        file = file or self.current_file
        if file is None:
            return
        view = self.views.get(file)
        self.session.commit(file, after, text, view.selected if view is not None else ())

    def _on_form(self, after: Document, text: str, place: Place) -> None:
        self.commit(after, text)
        view = self.current_view
        if view is not None and view.selected != (place,):
            self.select(place)

    def _on_changed(self, file: str) -> None:
        document = self.session.document(file)
        view = self.views.get(file)
        if document is None:
            return
        if view is not None:
            view.selected = tuple(p for p in view.selected if places.get(document, p) is not None)
            view.show_document(document, self._problems_of(file))
        if file == self.current_file:
            self._settle_document()
        self._refresh_tree()

    def _on_undone(self, file: str, selected: tuple[Place, ...]) -> None:
        self.open_file(file)
        view = self.current_view
        document = self.current_document
        if view is not None and document is not None:
            chosen = tuple(p for p in selected if places.get(document, p) is not None)
            view.select(chosen)
            view.selected = chosen
            self._settle_selection()

    def _on_stack(self) -> None:
        undo, redo = self.session.undo_text, self.session.redo_text
        actions = self.actions_.actions
        actions["undo"].setText(self.tr("Undo: {0}").format(undo) if undo else self.tr("Undo"))
        actions["redo"].setText(self.tr("Redo: {0}").format(redo) if redo else self.tr("Redo"))
        self.status.show_saved(
            len(self.session.dirty), self.session.saved_at, self.session.project is not None
        )
        self._settle_title()
        self._refresh_tree()
        self.actions_.refresh()

    def _on_selection(self, selected: tuple[Place, ...]) -> None:
        if self.sender() in (None, self.current_view):
            self._settle_selection()

    def _on_outline(self, selected: tuple[Place, ...]) -> None:
        view = self.current_view
        if view is not None:
            view.select(selected)
            view.selected = selected
            if selected:
                view.call("zoom_to", selected)
            self._settle_selection()

    def _on_outline_activated(self, place: Place) -> None:
        view = self.current_view
        if view is not None:
            view.call("zoom_to", (place,))
            view.current_view().setFocus()

    def _on_activated(self, place: Place) -> None:
        """A double click or Enter on a card: its form gets the focus."""
        self.select(tuple(place))
        form = self.inspector.form
        if form is not None and form.kind.fields:
            try:
                form.field(form.kind.fields[0].attribute).setFocus()
            except LookupError:
                return

    # -- problems and the disk -------------------------------------------------------------

    def _problems_of(self, file: str) -> list[Problem]:
        return [p for p in self.session.problems if self.session.file_of(p) == file]

    def _settle_problems(self) -> None:
        """The panel of the problems; places in other documents name them."""
        found = self.session.problems
        rows = []
        several = len(self.session.files) > 1
        for problem in found:
            file = self.session.file_of(problem)
            document = self.session.document(file) if file is not None else None
            where = Path(problem.file).name if document is None else stem(file or "")
            if document is not None and problem.place:
                short = _short(document, problem.place)
                other = several and file != self.current_file
                where = f"{stem(file or '')}: {short}" if other else short
            rows.append((problem, where))
        self.problems.show_problems(rows)
        self.bottom.set_count("problems", len(found))
        errors = sum(1 for p in found if p.severity == "error")
        self.status.show_problems(errors, len(found) - errors)

    def _on_problems(self) -> None:
        self._settle_problems()
        for file, view in self.views.items():
            document = self.session.document(file)
            if document is not None and view.problems != self._problems_of(file):
                view.show_document(document, self._problems_of(file))
        self._refresh_tree()
        self._settle_outline()
        self._settle_selection()

    def _on_problem(self, problem: Problem) -> None:
        file = self.session.file_of(problem)
        if file is not None:
            self.go_to(file, problem.place)

    def _on_disk(self, file: str) -> None:
        if file not in self.session.dirty:
            try:
                self.session.take_from_disk(file)
            except Exception as error:
                self.notice.show_for(file, str(error), can_take=False)
                return
            self.say(self.tr("{0} was changed by another program: read anew.").format(file))
            return
        self.notice.show_for(
            file, self.tr("Another program changed {0}; you have changed it too.").format(file)
        )

    def _on_theirs(self, file: str) -> None:
        try:
            self.session.take_from_disk(file)
        except Exception as error:
            self.dialogs.tell(str(error))

    def _on_mine(self, file: str) -> None:
        self.session.keep_mine(file)

    # -- bringing panels up to date ----------------------------------------------------------

    def _settle_document(self) -> None:
        document, project = self.current_document, self.session.project
        self.palette_.show_document(document)
        self.status.show_counts(document)
        self.status.show_project(document is not None)
        self._settle_outline()
        self._settle_selection()
        if project is not None and document is not None:
            application = isinstance(document, Application)
            self._headers["outline"].title.setText(
                self.tr("Outline") if application else self.tr("Modules")
            )

    def _settle_outline(self) -> None:
        project, file = self.session.project, self.current_file
        if project is None or file is None:
            return
        self.outline.show_document(project, self.current_document, tuple(self._problems_of(file)))

    def _settle_selection(self) -> None:
        view, document, project = self.current_view, self.current_document, self.session.project
        if view is None or document is None or project is None:
            self.inspector.show_nothing(self.tr("Nothing is selected."))
            self.status.show_selection(())
            self.actions_.refresh()
            return
        media = Path(project.root) / project.media if project.media is not None else None
        self.inspector.show_selection(
            document,
            view.selected,
            self._lexicon.vocabulary(project, document),
            tuple(self._problems_of(view.file)),
            media,
        )
        self.outline.select(view.selected)
        self.status.show_selection(view.selected)
        self.actions_.refresh()

    def _refresh_tree(self) -> None:
        dirty = self.session.dirty
        for file in self.session.files:
            document = self.session.document(file)
            if document is None:
                continue
            found = {p.severity for p in self._problems_of(file)}
            marks = tuple(m for m in ("error", "warning") if m in found)[:1]
            self.project_tree.show_document(file, document, file in dirty, marks)

    def _settle_title(self) -> None:
        project = self.session.project
        if project is None or self.stack.currentIndex() == 0:
            return
        star = "*" if self.session.dirty else ""
        self.setWindowTitle(self.tr("{0}{1} — Situ Studio").format(project.name, star))
        self.toolbar.show()

    # -- looks --------------------------------------------------------------------------------

    def _chosen_theme(self) -> Theme:
        if self.theme_choice == "system":
            scheme = QGuiApplication.styleHints().colorScheme()
            return DARK if scheme == Qt.ColorScheme.Dark else LIGHT
        return DARK if self.theme_choice == "dark" else LIGHT

    def choose_theme(self, choice: str) -> None:
        """``system``, ``light`` or ``dark``; kept for the next time."""
        self.theme_choice = choice
        self.settings.setValue("theme", choice)
        self.welcome.themes.show_choice(choice)
        self.set_theme(self._chosen_theme())

    def _on_scheme(self) -> None:
        if self.theme_choice == "system":
            self.set_theme(self._chosen_theme())

    def set_theme(self, theme: Theme) -> None:
        """Every widget of the window takes the theme."""
        self.theme = theme
        QApplication.setPalette(_palette(theme))
        self.setStyleSheet(qss(theme))
        self.actions_.set_theme(theme)
        retheme(self, theme)
        for choice in self.findChildren(Choice):
            choice.set_theme(theme)
        for flag in self.findChildren(Flag):
            flag.set_theme(theme)
        panels: tuple[Any, ...] = (
            self.project_tree,
            self.outline,
            self.palette_,
            self.inspector,
            self.problems,
            self.tabs,
            self.bottom,
            self.welcome,
            self.finder,
            self.robot,
            *self.views.values(),
        )
        for panel in panels:
            panel.set_theme(theme)
        self._settle_selection()

    def _size_docks(self) -> None:
        """The panels' usual sizes, unless a person has changed them before."""
        if self._placed:
            return
        small = self.width() < 1360
        horizontal, vertical = Qt.Orientation.Horizontal, Qt.Orientation.Vertical
        self.resizeDocks(
            [self.docks["project"], self.docks["inspector"]],
            [LEFT_SMALL if small else LEFT, RIGHT_SMALL if small else RIGHT],
            horizontal,
        )
        tree = self.project_tree.height_wanted() + 32
        self.resizeDocks(
            [self.docks["project"], self.docks["outline"], self.docks["palette"]],
            [tree, 10000, self.palette_.height() + 32],
            vertical,
        )
        self.resizeDocks([self.docks["bottom"]], [BOTTOM], vertical)

    def _settle_bottom(self) -> None:
        if not self.bottom.is_folded:
            self.resizeDocks([self.docks["bottom"]], [BOTTOM], Qt.Orientation.Vertical)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.palette_.set_dense(self.height() < LOW)
        if self.stack.currentIndex() == 1:
            self._size_docks()

    def _restore(self) -> None:
        geometry, state = self.settings.value("geometry"), self.settings.value("panels")
        self.resize(1440, 900)
        if isinstance(geometry, QByteArray):
            self.restoreGeometry(geometry)
        if isinstance(state, QByteArray):
            self._placed = self.restoreState(state)

    # -- leaving ---------------------------------------------------------------------------------

    def may_leave(self) -> bool:
        """Whether unsaved changes are saved, or may be forgotten."""
        self.finish_fields()
        dirty = self.session.dirty
        if not dirty:
            return True
        answer = self.dialogs.unsaved(dirty)
        if answer == "save":
            return self.commands.save()
        return answer == "discard"

    def closeEvent(self, event: QCloseEvent) -> None:
        if not self.may_leave():
            event.ignore()
            return
        self.settings.setValue("geometry", self.saveGeometry())
        if self.stack.currentIndex() == 1:
            self.settings.setValue("panels", self.saveState())
        self.disconnect_robot()
        super().closeEvent(event)

    # -- the robot -------------------------------------------------------------------------------

    @property
    def can_connect(self) -> bool:
        """Whether a robot can be followed: none is yet."""
        return not self.robot.connected

    @property
    def is_connected(self) -> bool:
        return self.robot.connected

    def ask_to_connect(self) -> None:
        """Asks for an address and connects."""
        self.robot.ask()

    def disconnect_robot(self) -> None:
        """Ends the link, if there is one."""
        self.robot.disconnect_robot()


class Notice(QFrame):
    """A strip above the canvas: another program changed a file."""

    theirs = Signal(str)
    mine = Signal(str)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "notice")
        self._file = ""
        line = QHBoxLayout(self)
        line.setContentsMargins(12, 4, 8, 4)
        line.setSpacing(8)
        line.addWidget(IconLabel(theme, "warning", "warning", 16))
        self.words = QLabel()
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        line.addWidget(self.words, 1)
        self.take = QPushButton(self.tr("Take the one on disk"))
        self.take.clicked.connect(lambda: self._answer(self.theirs))
        line.addWidget(self.take)
        self.keep = QPushButton(self.tr("Keep mine"))
        self.keep.clicked.connect(lambda: self._answer(self.mine))
        line.addWidget(self.keep)

    def show_for(self, file: str, text: str, can_take: bool = True) -> None:
        self._file = file
        self.words.setText(text)
        self.take.setVisible(can_take)
        self.show()

    def _answer(self, signal: Any) -> None:
        self.hide()
        signal.emit(self._file)


def _spring() -> QWidget:
    widget = QWidget()
    widget.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
    return widget


def _short(document: Document, place: Place) -> str:
    """A problem's place in few words: ``12 SPO2``."""
    if place[0] == "state" and len(place) > 1:
        return words.state_words(document, place[1])
    if place[0] == "always":
        return "Always"
    return place[1] if len(place) > 1 else place[0]


def _palette(theme: Theme) -> QPalette:
    """What is not styled by the sheet: the ground of views, selections, placeholders."""
    palette = QPalette()
    role = QPalette.ColorRole
    for one, token in (
        (role.Window, "panel"),
        (role.Base, "panel"),
        (role.AlternateBase, "row_alt"),
        (role.Button, "panel"),
        (role.Text, "text"),
        (role.WindowText, "text"),
        (role.ButtonText, "text"),
        (role.PlaceholderText, "text3"),
        (role.Highlight, "accent"),
        (role.HighlightedText, "on_accent"),
        (role.ToolTipBase, "text"),
        (role.ToolTipText, "panel"),
        (role.Mid, "line"),
        (role.Link, "accent"),
    ):
        palette.setColor(one, theme.color(token))
    disabled = QPalette.ColorGroup.Disabled
    for one in (role.Text, role.WindowText, role.ButtonText):
        palette.setColor(disabled, one, theme.color("text3"))
    return palette
