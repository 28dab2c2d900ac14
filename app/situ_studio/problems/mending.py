"""A window's problems: mending one, all of a kind, or accepting a warning.

Offered by the list of problems, by the form of what is wrong, and for what is selected by its
context menu and ``Ctrl+.``. ``problem_places`` goes to where a problem is.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from msgspec.structs import replace
from PySide6.QtCore import QObject, QPoint, Qt, QTimer
from PySide6.QtGui import QFontMetrics, QIcon
from PySide6.QtWidgets import QMenu

from situ.document import mend_toml
from situ.document.accepting import accepting
from situ.document.beside import Toml
from situ.document.mend import Stale, mends, of
from situ.document.mend_alike import alike, carried_out
from situ.document.problem import Mend, Problem
from situ_studio.edits import places
from situ_studio.edits.edit import Document, Place
from situ_studio.looks import icons
from situ_studio.looks.letters import px
from situ_studio.panels.problems import PROBLEM
from situ_studio.problems.alike_mending import AlikeMending, Plan, Wanted
from situ_studio.problems.begun_files import begun
from situ_studio.problems.problem_places import ProblemPlaces
from situ_studio.processes.working import Work
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow

MOST = 8
"""Of so many problems at most a menu has entries, and leads to the list of all."""
WIDE = 420
"""Px of a problem's words in a menu."""


class MendingSide(QObject):
    """Does what is asked of problems; a menu for those of what is selected."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window, self._session = window, window.session
        self._places = ProblemPlaces(window)
        self._known: dict[str, dict[Place, list[Problem]]] = {}
        self.shown: QMenu | None = None
        self._work: Work | None = None
        self.plan_with(AlikeMending(self))
        self._session.problems_changed.connect(self._known.clear)
        window.problems.chosen.connect(self._places.go)
        window.problems.mend_asked.connect(self.mend)
        window.problems.menu_asked.connect(self._on_row)
        window.inspector.told.mend_asked.connect(self.mend)

    def plan_with(self, alike: AlikeMending) -> None:
        """From now on this finds how all of a kind are mended."""
        self.alike = alike
        alike.began.connect(self._on_planning)
        alike.ended.connect(self._end_work)
        alike.planned.connect(self._on_planned)
        alike.gone.connect(self._on_gone)

    # -- what there is -----------------------------------------------------------

    def here(self) -> list[Problem]:
        """The problems of what is selected and of what is in it; of the document itself where
        nothing is selected; of the current row, while the list of problems has the focus.
        """
        rows = self._window.problems.list
        if rows.hasFocus():
            problem: Problem | None = rows.currentIndex().data(PROBLEM)
            return [problem] if problem is not None else []
        view = self._window.current_view
        if view is None:
            return []
        known = self._of(view.file)
        if not view.selected:
            return known.get((), [])
        roots = dict.fromkeys(places.root(place) for place in view.selected)
        return [
            problem
            for root in roots
            for problem in known.get(root, [])
            if any(problem.place[: len(place)] == place for place in view.selected)
        ]

    def _of(self, file: str) -> dict[Place, list[Problem]]:
        """The problems of a document, by the card that they are about, errors first, and those with
        a mend before others.
        """
        if file not in self._known:
            found = self._known[file] = {}
            every = self._session.problems_of(file)
            for problem in sorted(every, key=lambda p: (p.severity, p.mend is None)):
                found.setdefault(places.root(problem.place), []).append(problem)
        return self._known[file]

    # -- menus -------------------------------------------------------------------

    def ask(self) -> None:
        """Opens the menu of ``here``, beside what is selected."""
        rows = self._window.problems.list
        if rows.hasFocus():
            self.open_for_row()
            return
        found = self.here()
        if not found:
            self._window.say(self.tr("What is selected has no problem."))
            return
        self.open_at(found, self._window.context_menus.corner())

    def open_for_row(self) -> bool:
        """Opens the menu of the current row of the list of problems, if that has the focus."""
        rows = self._window.problems.list
        problem: Problem | None = rows.currentIndex().data(PROBLEM)
        if not rows.hasFocus() or problem is None:
            return False
        self._on_row(
            problem, rows.viewport().mapToGlobal(rows.visualRect(rows.currentIndex()).center())
        )
        return True

    def add_to(self, menu: QMenu) -> None:
        """Puts the problems of what is selected at the head of a context menu."""
        found = self.here()
        if not found or menu.isEmpty():
            return
        below = QMenu(self.tr("Problems"), menu)
        below.setToolTipsVisible(True)
        below.setIcon(self._icon(found[0].severity, found[0].severity))
        self._fill(below, found)
        menu.insertMenu(menu.actions()[0], below)
        menu.insertSeparator(menu.actions()[1])

    def open_at(self, problems: Sequence[Problem], at: QPoint) -> None:
        """Opens the menu of what can be done about these at a place of the screen."""
        menu = QMenu(self._window)
        menu.setToolTipsVisible(True)
        self._fill(menu, list(problems))
        self._pop_up(menu, at)

    def _on_row(self, problem: Problem, at: QPoint) -> None:
        self.open_at([problem], at)

    def _pop_up(self, menu: QMenu, at: QPoint) -> None:
        menu.aboutToHide.connect(lambda: self._on_hidden(menu))
        self.shown = menu
        menu.popup(at)
        menu.setActiveAction(menu.actions()[0])

    def _on_hidden(self, menu: QMenu) -> None:
        # What was chosen is done after this.
        self.shown = None
        QTimer.singleShot(0, menu, menu.deleteLater)

    def _fill(self, menu: QMenu, problems: list[Problem]) -> None:
        """What can be done about one; of several each has a menu of its own."""
        if len(problems) == 1:
            self._add(menu, problems[0])
            return
        metrics = QFontMetrics(menu.font())
        for problem in problems[:MOST]:
            words = metrics.elidedText(
                said(problem.message), Qt.TextElideMode.ElideRight, px(WIDE)
            ).replace("&", "&&")
            below = menu.addMenu(self._icon(problem.severity, problem.severity), words)
            below.setToolTipsVisible(True)
            below.menuAction().setToolTip(said(problem.message))
            self._add(below, problem)
        if len(problems) > MOST:
            more = self.tr("{0} more in the list of problems").format(len(problems) - MOST)
            menu.addAction(more).triggered.connect(lambda _=False: self._show_list())

    def _show_list(self) -> None:
        self._window.bottom.choose("problems")
        self._window.problems.list.setFocus()

    def _add(self, menu: QMenu, problem: Problem) -> None:
        if problem.mend is not None:
            words = said(problem.mend.words).replace("&", "&&")
            made = menu.addAction(self._icon("wand", "accent"), words)
            made.setToolTip(said(problem.message))
            made.triggered.connect(lambda _=False: self.mend(problem))
            count = len(alike(self._session.problems, problem.code))
            if count > 1:
                several = menu.addAction(self.tr("Mend all {0} of this kind").format(count))
                several.triggered.connect(lambda _=False: self.mend_alike(problem.code))
        beginning = begun(self._session, problem) if problem.mend is None else None
        if beginning is not None:
            made = menu.addAction(self._icon("wand", "accent"), beginning.words)
            made.setToolTip(said(problem.message))
            made.triggered.connect(lambda _=False: self._begin(problem))
        show = menu.addAction(self._icon("target", "text2"), self.tr("Show where it is"))
        show.setToolTip(said(problem.message))
        show.triggered.connect(lambda _=False: self._places.go(problem))
        if self._accepting(problem) is not None:
            accept = menu.addAction(self._icon("check", "text2"), self.tr("Accept this warning"))
            accept.setToolTip(self.tr("It is known and meant: it is told no more."))
            accept.triggered.connect(lambda _=False: self.accept(problem))

    def _icon(self, name: str, token: str) -> QIcon:
        return icons.icon(name, self._window.theme.color(token), 18)

    # -- what is done ------------------------------------------------------------

    def mend(self, problem: Problem) -> None:
        """Mends one problem, as one step."""
        window = self._window
        found = self._mended(problem)
        if problem.mend is None or found is None:
            window.say(self.tr("This has changed meanwhile: there is nothing to mend there now."))
            return
        words, after = found
        if isinstance(after, Toml):
            self._session.commit(problem.mend.file, after, said(words))
        else:
            window.commit(after, said(words), problem.mend.file)
        if problem.mend.file == window.current_file:
            window.select(problem.place)
        window.say(self.tr("Mended: {0}").format(said(words)))

    def _begin(self, problem: Problem) -> None:
        """Adds the file that takes a problem away, as one step."""
        beginning = begun(self._session, problem)
        if beginning is not None and self._session.commit_all(beginning.files, beginning.words):
            self._window.say(beginning.words)

    def _mended(self, problem: Problem) -> tuple[str, Document | Toml] | None:
        """What a problem's mend does, in words, and its file's value after it."""
        project, mend = self._session.project, problem.mend
        if project is None or mend is None:
            return None
        if mend.file not in mend_toml.FILES:
            found = mends(project, problem)
            return found[0] if found else None
        value = self._session.value(mend.file)
        try:
            return (mend.words, mend_toml.apply(value, mend)) if isinstance(value, Toml) else None
        except Stale:
            return None

    def mend_alike(self, code: str) -> None:
        """Mends all problems of one kind in the whole project, as one step.

        What has to be done is found beside the window in a large project, and not done where
        the project is another one by then.
        """
        project = self._session.project
        if project is not None and not self._settings_alike(code):
            self.alike.ask(Wanted(project, code))

    def _on_planning(self) -> None:
        words = self.tr("Mending all problems of one kind")
        self._work = self._window.status.work.begin(words, self._give_up)

    def _give_up(self) -> None:
        # The work ends itself.
        self._work = None
        self.alike.cancel()

    def _end_work(self) -> None:
        work, self._work = self._work, None
        if work is not None:
            work.end()

    def _on_gone(self) -> None:
        told = self.tr("These could not be mended: its process ended early. Nothing was changed.")
        self._window.say(told)

    def _on_planned(self, wanted: Wanted, plan: Plan) -> None:
        project, window = self._session.project, self._window
        if project is not wanted.project:
            window.say(self.tr("The project has changed meanwhile: nothing was mended."))
            return
        after = carried_out(project, plan.rounds)
        here = window.current_file or ""
        files = sorted(self._session.files, key=lambda file: file != here)
        changed = {
            file: document
            for file in files
            if (document := of(after, file)) is not None
            and document is not self._session.document(file)
        }
        view = window.current_view
        selected = view.selected if view is not None else ()
        text = self.tr("Mend {0} problems of one kind").format(plan.gone)
        if not changed or not self._session.commit_all(changed, text, selected):
            window.say(self.tr("These can not be mended together: mend them one by one."))
            return
        more = self.tr("{0} mended, {1} are left.").format(plan.gone, plan.left)
        window.say(more if plan.left else self.tr("{0} problems mended.").format(plan.gone))

    def _settings_alike(self, code: str) -> bool:
        """Whether those of one kind were mended in ``situ.toml``, where all of them were."""
        wanted = alike(self._session.problems, code)
        if any(one.mend is None or one.mend.file not in mend_toml.FILES for one in wanted):
            return False
        values = {file: self._session.value(file) for file in mend_toml.FILES}
        tomls = {file: value for file, value in values.items() if isinstance(value, Toml)}
        after, done = mend_toml.every(tomls, wanted)
        text = self.tr("Mend {0} problems of one kind").format(len(done))
        changed = {file: toml for file, toml in after.items() if toml != tomls[file]}
        if not changed or not self._session.commit_all(changed, text):
            return False
        self._window.say(self.tr("{0} problems mended.").format(len(done)))
        return True

    def accept(self, problem: Problem) -> None:
        """Writes down that a warning is known and meant, as one step."""
        project, mend = self._session.project, self._accepting(problem)
        if project is None or mend is None:
            return
        ((_, after),) = mends(project, replace(problem, mend=mend))
        self._window.commit(after, said(mend.words), mend.file)

    def _accepting(self, problem: Problem) -> Mend | None:
        project, file = self._session.project, self._session.file_of(problem)
        return accepting(project, file, problem) if project is not None and file else None
