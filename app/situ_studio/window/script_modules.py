"""The modules that a window's script could have besides its own, and how they get into it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from situ.document.spds import Spds
from situ_studio.edits.edit import Place
from situ_studio.live.present import PresentModules
from situ_studio.project.known_modules import Known, added, known

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow


class ScriptModules(QObject):
    """Keeps the list below the outline true: of the project's files and the connected robot."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self.present = PresentModules(window.robot.link, self)
        self.present.changed.connect(window.panels.settle_outline)
        self._more = window.outline.more
        self._more.wanted.connect(self.add)

    def settle(self) -> None:
        """Shows what the current script does not name."""
        window = self._window
        script, project = window.current_document, window.session.project
        if not isinstance(script, Spds) or project is None:
            self._more.show_modules(())
            window.outline.show_present(frozenset())
            return
        every = known(project, self.present.modules)
        named = {module.name for module in script.modules}
        self._more.show_modules(one for name, one in every.items() if name not in named)
        window.outline.show_present(frozenset(n for n, one in every.items() if one.present))

    def add(self, name: str, place: Place = ()) -> None:
        """Adds a module to the script, and with a priority to the situation at ``place``."""
        window = self._window
        script, project, file = window.current_document, window.session.project, window.current_file
        if not isinstance(script, Spds) or project is None or file is None:
            return
        one: Known | None = known(project, self.present.modules).get(name)
        if one is None:
            return
        situation = place[1] if place[:1] == ("situation",) else None
        changed, text = added(project, script, file, one, situation)
        view = window.current_view
        if changed and view is not None:
            window.session.commit_all(changed, text, view.selected)
        window.select(("module", name))
