"""What commands put into a document: a new thing of a kind, where the selection is."""

from __future__ import annotations

from situ_studio import kinds
from situ_studio.commands.insert import NotHere, insert
from situ_studio.commands.robot_commands import RobotCommands
from situ_studio.edits import places
from situ_studio.edits.edit import Place
from situ_studio.panels.palette import offered


class InsertCommands(RobotCommands):
    """The handlers of one window that add a thing."""

    # -- when ------------------------------------------------------------------------

    def _can_insert(self, part: str) -> bool:
        document = self._window.current_document
        return any(kind.palette == part for kind in offered(document))

    def offers_application(self) -> bool:
        return self._can_insert("application")

    def offers_action(self) -> bool:
        return self._can_insert("action")

    def offers_screen(self) -> bool:
        return self._can_insert("screen")

    def offers_drawing(self) -> bool:
        return self._can_insert("drawing")

    def offers_script(self) -> bool:
        return self._can_insert("script")

    def offers_modules(self) -> bool:
        return self._can_insert("modules")

    def can_insert_application(self) -> bool:
        return self._can_insert("application")

    def can_insert_action(self) -> bool:
        return self._can_insert("action") and self.has_selection()

    def can_insert_screen(self) -> bool:
        return self._can_insert("screen") and self.has_selection()

    def can_insert_drawing(self) -> bool:
        return self._can_insert("drawing")

    def can_insert_script(self) -> bool:
        return self._can_insert("script")

    def can_insert_modules(self) -> bool:
        return self._can_insert("modules")

    # -- what is done ----------------------------------------------------------------

    def insert(self, name: str) -> None:
        """Puts a new thing where the selection is, and selects it."""
        view, document = self._window.current_view, self._window.current_document
        if view is None or document is None:
            return
        if name == "part":
            self._window.parts.insert()
            return
        if name in places.DRAWN and view.can("add_drawn"):
            view.call("add_drawn", name)
            return
        if name == "state" and view.can("add_state"):
            view.call("add_state")
            if len(view.selected) == 1:
                self._window.fill_in(view.selected[0])
            return
        self.insert_into(view.selected[0] if view.selected else (), name)

    def insert_into(self, at: Place, name: str) -> None:
        """Puts a new thing into what stands at a place, and selects it to be filled in."""
        document = self._window.current_document
        if document is None:
            return
        if kinds.kind(name).file:
            self._window.media_choice.add(at, name)
            return
        try:
            after, place, text = insert(document, kinds.kind(name), at)
        except NotHere as refused:
            self._window.say(str(refused))
            return
        if text:
            self._window.commit(after, text)
        self._window.fill_in(place, "timeout" if name == "timeout" else "")
