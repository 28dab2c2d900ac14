"""The main window: canvas in the middle, panels round it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QSettings, QTimer, Signal
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QApplication

from situ_studio.commands.commands import Commands
from situ_studio.commands.context_menus import ContextMenus
from situ_studio.commands.menus import Actions
from situ_studio.commands.project_menu import ProjectMenu
from situ_studio.edits import places
from situ_studio.edits.edit import Document, Place
from situ_studio.edits.vocabulary import Lexicon, Vocabulary
from situ_studio.export.exporting import ExportingSide
from situ_studio.files import leftovers
from situ_studio.files.claim import Claim
from situ_studio.files.disk import DiskSide
from situ_studio.files.document_files import DocumentFiles
from situ_studio.files.opening import Found
from situ_studio.files.recovery import Recovery
from situ_studio.finding.looking import FindingSide
from situ_studio.help.helping import HelpSide
from situ_studio.live.column_side import ColumnSide
from situ_studio.live.deploying_side import DeployingSide
from situ_studio.live.field_side import FieldSide
from situ_studio.live.link import RobotLink
from situ_studio.live.link_status import LinkStatus
from situ_studio.live.operating import OperatingSide
from situ_studio.live.robot import RobotSide
from situ_studio.live.why_side import WhySide
from situ_studio.looks.theme import Theme
from situ_studio.panels.beside import ScreenBeside
from situ_studio.panels.fields import Choice, Line, Paragraph
from situ_studio.panels.project_tree import stem
from situ_studio.problems.checking import CheckWork
from situ_studio.problems.mending import MendingSide
from situ_studio.project.session import Session
from situ_studio.project.undo import Looking
from situ_studio.rehearsing.scenarios_side import ScenariosSide
from situ_studio.rehearsing.side import RehearsingSide
from situ_studio.screens.choosing_media import ChoosingMedia
from situ_studio.screens.designing import DesigningSide
from situ_studio.screens.media_import import names_of
from situ_studio.views.document_view import DocumentView
from situ_studio.views.showing import keep as keep_shown
from situ_studio.views.showing import recall, show_beside
from situ_studio.welcome.project_pictures import Example
from situ_studio.welcome.welcoming import Welcoming
from situ_studio.window.dialogs import Dialogs
from situ_studio.window.frame import Frame
from situ_studio.window.open_files import OpenFiles
from situ_studio.window.pages import PagesSide
from situ_studio.window.panels_side import PanelsSide
from situ_studio.window.parts import PartsSide
from situ_studio.window.script_modules import ScriptModules
from situ_studio.window.telling import TellingSide

if TYPE_CHECKING:
    from situ_studio.window.windows import Windows


class MainWindow(Frame):
    """One window with one session.

    settings: where it was and what it showed; examples: what the welcome page offers;
    opening: a project is opened at once, before anything is seen. link: to a robot, taken over
    from the window before.
    """

    closed = Signal(object)
    """The window itself, once nothing in it is left to save."""

    def __init__(
        self,
        session: Session,
        settings: QSettings,
        examples: Callable[[], list[Example]],
        theme: str | None = None,
        opening: bool = False,
        link: RobotLink | None = None,
    ) -> None:
        super().__init__(settings, theme)
        self.windows: Windows | None = None
        self.asked = False
        """What becomes of unsaved changes was asked already: it closes without another word."""
        self.session = session
        session.setParent(self)
        self._lexicon = Lexicon(names_of)
        self.dialogs: Dialogs = Dialogs(self)
        home = Path(settings.fileName()).parent / "recovery"
        self.recovery = Recovery(session, home, self.recovered)
        self.recovery.refused.connect(self.say)
        self.claim = Claim(home)
        self.commands = Commands(self)
        self.welcoming = Welcoming(self, examples)
        self.panels = PanelsSide(self)
        self.open_files = OpenFiles(self)
        self.telling = TellingSide(self)
        self.robot = RobotSide(self, link)
        self.why = WhySide(self)
        self.deploying = DeployingSide(self)
        self.operating = OperatingSide(self)
        self.rehearsing = RehearsingSide(self)
        self.moment = ColumnSide(self)
        self.link_status = LinkStatus(self)
        self.scenarios = ScenariosSide(self)
        self.field = FieldSide(self)
        self.disk = DiskSide(self)
        CheckWork(session.checker, self.status.work)
        self.modules = ScriptModules(self)
        self.designing = DesigningSide(self)
        self.media_choice = ChoosingMedia(self)
        self.parts = PartsSide(self)
        # Before the window closes the tabs of files that are not there any more.
        self.document_files = DocumentFiles(self)
        self.pages = PagesSide(self)
        self.finding = FindingSide(self)
        self.exporting = ExportingSide(self)
        self.context_menus = ContextMenus(self)
        self.mending = MendingSide(self)
        self.add_commands(Actions(self.commands, self.theme, self))
        self.project_menu = ProjectMenu(self)
        self.helping = HelpSide(self)
        self.search.clicked.connect(self.commands.find)
        self._wire()
        self.set_theme(self.theme)
        self.restore()
        # Reading the examples takes longer than opening a project: not for one that comes at once.
        self.welcoming.show(with_examples=not opening)

    def _wire(self) -> None:
        session = self.session
        session.opened.connect(self._on_opened)
        session.listed.connect(self._on_listed)
        session.changed.connect(self._on_changed)
        session.selected.connect(self._on_undone)
        session.stack_changed.connect(self.panels.settle_stack)
        session.problems_changed.connect(self._on_problems)
        self.sides.entered.connect(self.panels.settle_shown)
        self.sides.closed.connect(self.open_files.close)
        self.sides.view_chosen.connect(self.show_mode)
        self.sides.beside_asked.connect(lambda file, moved: show_beside(self, file, moved))
        self.project_tree.file_asked.connect(self.open_file)
        self.project_tree.panel_asked.connect(self.bottom.choose)
        self.outline.selected.connect(self._on_outline)
        self.outline.activated.connect(self._on_outline_activated)
        self.palette_.kind_asked.connect(self.commands.insert)
        self.inspector.edited.connect(self._on_form)
        self.inspector.place_asked.connect(self.select)
        self.inspector.kind_asked.connect(self.commands.insert_into)
        self.inspector.refused.connect(self.say)
        self.inspector.usages_asked.connect(self.commands.find_usages)
        self.status.problems_asked.connect(lambda: self.bottom.choose("problems"))

    # -- the project -----------------------------------------------------------------

    def open_project(self, path: Path) -> None:
        """Opens a project; UsageError, with one line for the user, where it can not be read."""
        keep_shown(self.settings, self)
        self.session.open(path)
        self._on_open(path)

    def take_project(self, found: Found, path: Path) -> None:
        """Opens what was read at ``path``; as ``open_project``."""
        keep_shown(self.settings, self)
        self.session.take(*found, path)
        self._on_open(path)

    def _on_open(self, path: Path) -> None:
        if self.isVisible():
            recall(self.settings, self)
        self.welcoming.remember(path)
        if self.claim.take(self.session.root):
            leftovers.clear(self.session.root)
        else:
            self.notice.ask(
                self.tr(
                    "This project is open in another Situ Studio too. What is saved there is told "
                    "here before anything is overwritten."
                ),
                (self.tr("All right"), lambda: None),
            )

    def _on_opened(self) -> None:
        project = self.session.project
        assert project is not None
        self.sides.reset()
        self.notice.hide()
        self.project_tree.show_project(project, self.session.files)
        self.docking.show()
        self.stack.setCurrentIndex(1)
        self.moment.settle()
        shown = [f for f in self.session.files if f != project.modules_file]
        for file in shown or self.session.files:
            self.open_files.add_tab(file)
        self.panels.settle_files()
        if self.tabs.files():
            self.tabs.choose(self.tabs.files()[0])
        else:
            self.open_files.show("")
        self.size_docks()
        shown_view = self.current_view
        if shown_view is not None:
            shown_view.current_view().setFocus()

    def take_over(self) -> None:
        """Shows a session that was open in a window before this one."""
        if self.session.project is not None:
            self._on_opened()
            self._on_problems()
        self.panels.settle_stack()
        self.recovery.keep()
        self.robot.follower.compare()
        self.robot.settle()

    def open_file(self, file: str) -> None:
        """Shows a document: where it is on the way into a part, else in its tab, new if need be;
        a file beside the documents on its page.
        """
        file = self.pages.key(file)
        if self.parts.reach(file):
            return
        self.open_files.add_tab(file)
        self.parts.forget(file)
        self.tabs.choose(file)

    # -- what is shown ------------------------------------------------------------------

    @property
    def views(self) -> dict[str, DocumentView]:
        """Those of the current group, by file."""
        return self.sides.current.views

    @property
    def current_file(self) -> str | None:
        """What the current group shows."""
        return self.sides.current.current_file

    @property
    def current_view(self) -> DocumentView | None:
        return self.sides.current.current_view

    @property
    def beside(self) -> ScreenBeside | None:
        """The screen beside the current document's graph, where it is shown so."""
        view = self.current_view
        return view.piece("screen") if view is not None and view.shown_as == "split" else None

    @property
    def current_document(self) -> Document | None:
        return self.session.document(self.current_file or "")

    def show_mode(self, mode: str) -> None:
        """Shows the current document as the view of that name, if it can be shown so."""
        view = self.current_view
        if view is not None:
            view.set_mode(mode)
            # Once its pieces have their sizes.
            QTimer.singleShot(0, view, view.bring_selected)
            self.tabs.views.show_choice(view.shown_as)
            view.current_view().setFocus()
            self.panels.settle_selection()

    def reset_layout(self) -> None:
        """A designer that is shown keeps its panel, and so does what is live."""
        self.designing.leave()
        self.moment.leave()
        super().reset_layout()
        self.designing.settle()
        self.moment.settle()

    def say(self, text: str) -> None:
        """A passing message in the status bar."""
        self.status.say(text)

    def select(self, place: Place) -> None:
        """Selects a place of the current document everywhere, or what of it is there."""
        view, document = self.current_view, self.current_document
        if view is None or document is None:
            return
        near = places.nearest(document, place)
        self.select_all((near,) if near else ())

    def select_all(self, chosen: tuple[Place, ...]) -> None:
        """Selects places of the current document, which are there."""
        view = self.current_view
        if view is None:
            return
        view.select(chosen)
        view.selected = chosen
        self.panels.settle_selection()

    def fill_in(self, place: Place, attribute: str = "") -> None:
        """Selects a place and puts the cursor into its form: into the first field unless named."""
        self.select(place)
        if self.inspector.form is not None and self.inspector.place == place:
            self.inspector.form.begin(attribute)

    @property
    def media(self) -> tuple[str, ...]:
        """The files of the project's media folder."""
        return self.vocabulary(self.current_document).media

    def vocabulary(self, document: Document | None) -> Vocabulary:
        """The words that can be used in a document; none where there is none."""
        project = self.session.project
        if project is None or document is None:
            return Vocabulary()
        return self._lexicon.vocabulary(project, document)

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
        elif isinstance(focus, Paragraph | Choice):
            focus.finish()

    # -- changes -----------------------------------------------------------------------

    def commit(self, after: Document, text: str, file: str | None = None) -> None:
        """Makes a new value of a document one named step."""
        file = file or self.current_file
        if file is None:
            return
        view = self.views.get(file)
        if not self.session.is_incomplete(file):
            selected = view.selected if view is not None else ()
            looking = view.call("looking") if view is not None else None
            self.session.commit(file, after, text, selected, looking)
            return
        self.say(self.tr("{0} has errors: it can be read, not changed.").format(stem(file)))
        document = self.session.document(file)
        if view is not None and document is not None:
            view.show_document(document, self.session.problems_of(file))
            self.panels.settle_selection()

    def _on_form(self, after: Document, text: str, place: Place) -> None:
        self.commit(after, text)
        view = self.current_view
        if view is not None and view.selected != (place,):
            self.select(place)

    def _on_listed(self) -> None:
        """The project has a file more or less: the tree shows it, and a tab without one closes."""
        project = self.session.project
        assert project is not None
        self.project_tree.show_project(project, self.session.files)
        self.open_files.close_gone()
        self.project_tree.show_current(self.current_file)

    def _on_changed(self, file: str) -> None:
        document = self.session.document(file)
        if document is None:
            return
        for view in self.sides.views_of(file):
            view.selected = tuple(p for p in view.selected if places.get(document, p) is not None)
            view.show_document(document, self.session.problems_of(file))
        if file == self.current_file:
            self.panels.settle_value()

    def _on_undone(self, file: str, selected: tuple[Place, ...], looking: Looking | None) -> None:
        other = self.sides.other
        if other is not None and file == other.current_file and file != self.current_file:
            self.sides.enter(other)
        elif file != self.current_file and not self.pages.shows(file):
            self._open_if_there(file)
        view = self.current_view
        document = self.current_document
        if view is not None and document is not None and file == self.current_file:
            chosen = tuple(p for p in selected if places.get(document, p) is not None)
            view.select(chosen)
            view.selected = chosen
            if looking is not None:
                view.call("look_at", looking)
            view.call("bring_into_view", chosen)
            self.panels.settle_selection()

    def _open_if_there(self, file: str) -> None:
        """Nothing is shown of a file that a step had begun, once it is taken back."""
        if self.session.value(file) is not None:
            self.open_file(file)

    def _on_outline(self, selected: tuple[Place, ...]) -> None:
        view = self.current_view
        if view is not None:
            view.select(selected)
            view.selected = selected
            if selected:
                view.call("zoom_to", selected)
            self.panels.settle_selection()

    def _on_outline_activated(self, place: Place) -> None:
        view = self.current_view
        if view is not None:
            view.call("zoom_to", (place,))
            view.current_view().setFocus()

    def _on_problems(self) -> None:
        self.panels.settle_problems()
        for view in self.sides.views():
            document, found = self.session.document(view.file), self.session.problems_of(view.file)
            if document is not None and view.problems != found:
                view.show_document(document, found)
        self.panels.settle_files()
        self.panels.settle_outline()
        self.panels.settle_selection()

    def set_theme(self, theme: Theme) -> None:
        """The documents and the robot's panels take the theme too."""
        super().set_theme(theme)
        self.robot.set_theme(theme)
        self.operating.set_theme(theme)
        self.why.set_theme(theme)
        self.moment.set_theme(theme)
        self.rehearsing.set_theme(theme)
        self.scenarios.panel.set_theme(theme)
        self.field.set_theme(theme)
        self.finding.set_theme(theme)
        self.pages.set_theme(theme)
        for view in self.sides.views():
            view.set_theme(theme)
        self.panels.settle_selection()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.ActivationChange and self.isActiveWindow():
            self.disk.look()

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
        if not self.asked and not self.may_leave():
            event.ignore()
            return
        self.designing.leave()
        self.rehearsing.end()
        self.moment.leave()
        self.scenarios.cancel()
        self.field.cancel()
        self.keep()
        keep_shown(self.settings, self)
        self.recovery.forget()
        self.claim.release()
        self.robot.disconnect_robot()
        super().closeEvent(event)
        self.closed.emit(self)
