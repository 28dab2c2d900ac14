"""What commands do with the states and transitions of an application, drawn or in the outline."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from situ.document import rbd
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio.canvas import gestures
from situ_studio.canvas.menu import FollowMenu
from situ_studio.canvas.picture import NEW, exit_of
from situ_studio.commands.context_menus import context_of
from situ_studio.copying import copies
from situ_studio.edits import places
from situ_studio.edits.edit import Place

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow


class StateCommands(QObject):
    """The handlers of one window that are about states; ``commands.Commands`` has the others."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._session = window.session

    # -- when ------------------------------------------------------------------------

    def has_selection(self) -> bool:
        view = self._window.current_view
        return view is not None and bool(view.selected)

    def on_graph(self) -> bool:
        view = self._window.current_view
        return view is not None and view.mode == "graph"

    def is_application(self) -> bool:
        return isinstance(self._window.current_document, Application)

    def on_application(self) -> bool:
        return self.on_graph() and self.is_application()

    def _cards(self) -> int:
        """How many cards of an application are selected; none where something else is too."""
        view = self._window.current_view
        if view is None or not self.is_application():
            return 0
        cards = [p for p in view.selected if context_of((p,)) in ("state", "always")]
        return len(cards) if len(cards) == len(view.selected) else 0

    def has_cards(self) -> bool:
        return self.on_graph() and self._cards() > 0

    def has_one_state(self) -> bool:
        return self._cards() == 1

    def has_two_cards(self) -> bool:
        return self.on_graph() and self._cards() > 1

    def has_three_cards(self) -> bool:
        return self.on_graph() and self._cards() > 2

    def has_drawn_exit(self) -> bool:
        return self.on_graph() and self.has_exit()

    def can_step_exit(self) -> bool:
        return self.on_graph() and (self.has_card_or_exit() or self._on_script())

    def _on_script(self) -> bool:
        """Whether one thing of a script is selected on its graph."""
        view, document = self._window.current_view, self._window.current_document
        if view is None or not isinstance(document, Spds):
            return False
        return self.on_graph() and len(view.selected) == 1

    def can_lead(self) -> bool:
        return self.has_card_or_exit() or self._on_script()

    def has_exit(self) -> bool:
        view = self._window.current_view
        return view is not None and self.is_application() and context_of(view.selected) == "exit"

    def has_card_or_exit(self) -> bool:
        return self._cards() == 1 or self.has_exit()

    # -- what is done ------------------------------------------------------------------

    def mark_start(self) -> None:
        view, document = self._window.current_view, self._window.current_document
        if view is not None and isinstance(document, Application) and self.has_one_state():
            after, text = gestures.mark_start(document, view.selected[0][-1])
            if text:
                self._window.commit(after, text)

    def ask_where_to(self) -> None:
        """Asks where the selected transition leads, or a new one of the selected card."""
        view, document = self._window.current_view, self._window.current_document
        if view is None or not view.selected:
            return
        if view.can("ask_where_to"):
            view.call("ask_where_to")
            return
        if not isinstance(document, Application):
            return
        place = view.selected[0]
        owner, exit = places.root(place), exit_of(place) or NEW
        menu = FollowMenu(gestures.choices(document, owner, exit), self._window.theme, self._window)
        menu.chosen.connect(lambda key: self._lead(document, owner, exit, key))
        shown = view.current_view()
        menu.popup(shown.mapToGlobal(shown.rect().center()))

    def _lead(self, document: Application, owner: Place, exit: str, key: str) -> None:
        after, text, no = gestures.follow(document, owner, exit, key, *copies.below(document))
        if text and self._window.current_document is document:
            self._window.commit(after, text)
            if no is not None:
                self._window.select(("state", no))

    def guard(self) -> None:
        """A condition of the selected event, to be filled in."""
        view, form = self._window.current_view, self._window.inspector.form
        if view is None or form is None or len(view.selected) != 1:
            return
        if view.selected[0][-1:] == ("timeout",):
            self._window.say(
                self.tr("A timeout has no guard: give it no target, and guard the event timeout.")
            )
            return
        condition = form.section("when").condition
        if condition is not None:
            condition.add("test")

    def go_to_start(self) -> None:
        document, file = self._window.current_document, self._window.current_file
        if isinstance(document, Application) and file is not None and document.start_no is not None:
            self._window.go_to(file, ("state", document.start_no))

    def go_to_target(self) -> None:
        """To the state to which the selected transition leads."""
        view, document = self._window.current_view, self._window.current_document
        if view is None or not isinstance(document, Application) or not view.selected:
            return
        place = view.selected[0]
        leaving = places.get(document, place)
        target = leaving.next if leaving is not None else None
        if target == rbd.AGAIN and place[0] == "state":
            target = place[1]
        if target is None:
            self._window.say(self.tr("This leads nowhere: the state stays."))
        elif target in (rbd.BACK, rbd.AGAIN):
            self._window.say(self.tr("This leads to another state each time."))
        elif document.state(target) is None:
            self._window.say(self.tr("There is no state {0}.").format(target))
        else:
            self._window.go_to(view.file, ("state", target))
