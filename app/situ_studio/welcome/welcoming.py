"""A window's welcome page: shown and left, and the projects that were open lately."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from situ_studio.welcome import recent
from situ_studio.welcome.project_pictures import Example

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow


class Welcoming:
    """Fills the welcome page of one window; what is asked for there, its commands do.

    examples: what the page offers.
    """

    def __init__(self, window: MainWindow, examples: Callable[[], list[Example]]) -> None:
        self._window = window
        self._list_examples = examples
        self._before: str | None = None
        page, commands = window.welcome, window.commands
        page.back_asked.connect(self.leave)
        page.new_asked.connect(commands.new_project)
        page.open_asked.connect(commands.open_project)
        page.connect_asked.connect(commands.connect_robot)
        page.recent_asked.connect(commands.open_path)
        page.forget_asked.connect(commands.forget_recent)
        page.locate_asked.connect(commands.locate_recent)
        page.example_asked.connect(commands.open_example)
        page.template_asked.connect(commands.new_project)
        page.theme_asked.connect(window.choose_theme)
        page.language_asked.connect(commands.choose_language)
        page.tutorial_asked.connect(commands.show_tutorial)
        page.help_asked.connect(lambda: window.helping.show_topic("page/first"))

    # -- the page ----------------------------------------------------------------------

    def show(self, with_examples: bool = True) -> None:
        """Shows the welcome page; an open project stays open."""
        window, page = self._window, self._window.welcome
        self._show_recent()
        page.show_connect(not window.robot.connected)
        if with_examples:
            page.show_examples(self._list_examples())
        page.themes.show_choice(window.theme_choice)
        if window.stack.currentIndex() == 1:
            self._before = window.tabs.chosen_file
        project = window.session.project
        page.show_back(project.name if project is not None else None)
        window.stack.setCurrentIndex(0)
        window.designing.leave()
        window.moment.leave()
        window.docking.hide()
        window.toolbar.hide()
        window.sides.current.current_file = None
        window.panels.settle_title()
        window.panels.settle_document()

    def leave(self) -> None:
        """Goes back to the project that is open, as it was left."""
        window = self._window
        if window.session.project is None or window.stack.currentIndex() == 1:
            return
        window.docking.show()
        window.stack.setCurrentIndex(1)
        window.moment.settle()
        if self._before in window.tabs.files():
            window.tabs.choose(str(self._before))
        else:
            window.open_files.show("")
        if window.current_view is not None:
            window.current_view.current_view().setFocus()

    # -- recent projects ---------------------------------------------------------------

    @property
    def recent(self) -> list[str]:
        """The folders of the projects that were open lately, the last one first, gone ones too."""
        return recent.recent(self._window.settings)

    def remember(self, path: Path) -> None:
        """The project at ``path`` is open here: it is recent, and open at the next start."""
        window = self._window
        recent.remember(window.settings, path, window.session.now())
        if window.windows is not None:
            window.windows.remember()

    def forget(self, path: str) -> None:
        recent.forget(self._window.settings, path)
        self._show_recent()

    def move(self, path: str, to: Path) -> None:
        """A recent project lies in another folder now."""
        recent.move(self._window.settings, path, to)
        self._show_recent()

    def _show_recent(self) -> None:
        window = self._window
        opened = recent.opened(window.settings)
        window.welcome.recent.show_projects(self.recent, opened, window.session.now())
