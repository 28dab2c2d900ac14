"""Going to exactly what a problem is about, in the view or on the page that shows it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from situ.document.folder import LOCAL_FILE, PROJECT_FILE
from situ.document.problem import Problem
from situ.document.rbd import Application
from situ_studio.edits.edit import Place

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow

MISSING_TEXT = "missing-text"


class ProblemPlaces:
    """Shows problems in one window."""

    def __init__(self, window: MainWindow) -> None:
        self._window = window

    def go(self, problem: Problem) -> None:
        """Shows what the problem is about, selected: a text that is not translated in the table of
        all texts, what stands in ``situ.toml`` in its form, the rest in its document.
        """
        window, session = self._window, self._window.session
        file = session.file_of(problem)
        if file is None:
            return
        language = self._language(problem)
        if language is not None:
            window.pages.go_to_text(file, problem.place, language)
        elif session.document(file) is None:
            window.open_file(file)
            if file in (PROJECT_FILE, LOCAL_FILE):
                window.pages.go_to_field(file, problem.place)
        else:
            window.open_file(file)
            self._show_screen(problem.place)
            window.go_to(file, problem.place)

    def _language(self, problem: Problem) -> str | None:
        """The language into which a text is to be translated; None for another problem."""
        project = self._window.session.project
        if problem.code != MISSING_TEXT or project is None or not problem.place:
            return None
        # The problem names its file, and has no other field for it.
        named = (one for one in project.languages if f"texts/{one}.po" in problem.message)
        return next(named, None)

    def _show_screen(self, place: Place) -> None:
        """What lies on a screen can not be seen in the graph alone."""
        view, document = self._window.current_view, self._window.current_document
        on_screen = isinstance(document, Application) and "screen" in place
        if view is not None and on_screen and view.shown_as == "graph":
            self._window.show_mode("split")
