"""What commands do with a script: begin one, and what its canvas does without a mouse."""

from __future__ import annotations

from situ.document.beside import Toml
from situ.document.condition import Group, Test
from situ.document.folder import PROJECT_FILE
from situ.document.spds import Entry, Spds
from situ_studio.commands.state_commands import StateCommands
from situ_studio.copying import script_copies
from situ_studio.edits import new_script, places


class SituationCommands(StateCommands):
    """The handlers of one window that are about scripts."""

    # -- when ------------------------------------------------------------------------

    def can_begin_script(self) -> bool:
        project = self._session.project
        return project is not None and new_script.can_begin(project)

    def on_script(self) -> bool:
        return self.on_graph() and isinstance(self._window.current_document, Spds)

    def on_parts_of_script(self) -> bool:
        """Whether a script is shown by its parts: as its graph or its outline."""
        view = self._window.current_view
        shown = view is not None and view.mode in ("graph", "outline")
        return shown and isinstance(self._window.current_document, Spds)

    def _is_about(self, kind: str) -> bool:
        """Whether all that is selected on the graph of a script is, or is in, things of a kind."""
        view = self._window.current_view
        if view is None or not view.selected or not self.on_graph():
            return False
        if not isinstance(self._window.current_document, Spds):
            return False
        return all(place[0] == kind for place in view.selected)

    def has_situation(self) -> bool:
        return self._is_about("situation")

    def has_data(self) -> bool:
        return self._is_about("data")

    def has_parts_of_script(self) -> bool:
        """Whether something that can be copied is selected on a script's graph or outline."""
        view = self._window.current_view
        if view is None or not self.on_parts_of_script():
            return False
        return script_copies.can_be_copied(view.selected)

    def has_tests(self) -> bool:
        """Whether tests, groups of them or a condition are selected."""
        view = self._window.current_view
        if view is None or not self._is_about("situation"):
            return False
        return all(place[2:3] in (("condition",), ("until",)) for place in view.selected)

    def has_group(self) -> bool:
        view, document = self._window.current_view, self._window.current_document
        if view is None or not isinstance(document, Spds) or not self.has_tests():
            return False
        values = [places.get(document, place) for place in view.selected]
        within = any(isinstance(v, Test) for v in values) and any(len(p) > 4 for p in view.selected)
        return within or any(isinstance(value, Group) for value in values)

    def has_priority(self) -> bool:
        view, document = self._window.current_view, self._window.current_document
        if view is None or not isinstance(document, Spds) or not self.on_graph():
            return False
        values = [places.get(document, place) for place in view.selected]
        return len(values) == 1 and isinstance(values[0], Entry)

    # -- what is done ------------------------------------------------------------------

    def begin_script(self) -> None:
        """A script for the project, opened; one step."""
        project, window = self._session.project, self._window
        toml = self._session.value(PROJECT_FILE)
        if project is None or not isinstance(toml, Toml) or not self.can_begin_script():
            return
        there = new_script.taken(self._session.root, self._session.files)
        changed = new_script.begun(project, toml, there)
        text = self.tr("Add a script of situations")
        if self._session.commit_all(changed, text):
            window.open_file(next(iter(changed)))

    def group(self, kind: str) -> None:
        view = self._window.current_view
        if view is not None:
            view.call("group", kind)
