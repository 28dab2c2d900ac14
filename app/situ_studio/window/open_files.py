"""The files that are open in a window: each in a tab, shown by a view or on a page."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from situ_studio.edits.edit import Place
from situ_studio.panels.project_tree import look, stem
from situ_studio.processes.working import follow
from situ_studio.views.document_view import DocumentView
from situ_studio.views.showing import show_as

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow


class OpenFiles(QObject):
    """Tabs of the current group: added, shown, closed, opened again. Files are keys of documents
    or, beside them, of pages.
    """

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window

    def add_tab(self, file: str) -> None:
        """A tab for a file, unless the current group has one; it is not chosen."""
        window, tabs = self._window, self._window.tabs
        document = window.session.document(file)
        if file in tabs.files():
            return
        if document is not None:
            icon, token, _ = look(document, window.parts.is_part(file))
            tabs.add(file, stem(file), icon, token)
        elif window.pages.has(file):
            tabs.add(file, *window.pages.look(file))

    def show(self, file: str) -> None:
        """Shows a file in the chosen tab: its document's view, its page, or that there is none."""
        window, group = self._window, self._window.sides.current
        document = window.session.document(file)
        group.current_file = file if document is not None else None
        if document is not None:
            view = group.views.get(file)
            if view is None:
                view = self._make_view(file)
                window.robot.follower.refresh()
            group.documents.setCurrentWidget(view)
            view.show_document(document, window.session.problems_of(file))
            how = group.waiting.pop(file, None)
            if how is not None:
                show_as(view, document, how)
            group.tabs.views.set_offered(view.ways_to_show)
            group.tabs.views.setVisible(len(view.ways_to_show) > 1)
            group.tabs.views.show_choice(view.shown_as)
        else:
            page = window.pages.page(file)
            if page is not None and group.documents.indexOf(page) < 0:
                group.documents.addWidget(page)
            group.documents.setCurrentWidget(page or group.no_document)
            group.tabs.views.hide()
        window.panels.settle_shown()

    def close(self, file: str) -> None:
        """Closes a tab of the current group, and the group with the last of one of two; the
        document stays in the project, with its changes."""
        window, group = self._window, self._window.sides.current
        window.parts.forget(file)
        group.tabs.remove(file)
        if not group.tabs.files() and window.sides.other is not None:
            window.sides.remove(group)
        elif file != group.current_file:
            # Else another tab is at this part now.
            group.drop_view(file)

    def close_chosen(self) -> None:
        """Closes the chosen tab, if a tab can be closed."""
        tabs = self._window.tabs
        if tabs.chosen_file is not None and tabs.may_close:
            self.close(tabs.chosen_file)

    def reopen(self) -> None:
        """Opens the tab again that was closed last, where it was."""
        window = self._window
        while (last := window.tabs.last_closed()) is not None:
            file, place = last
            if file not in window.tabs.files() and self._is_there(file):
                window.open_file(file)
                window.tabs.put(file, place)
                return

    def close_gone(self) -> None:
        """Closes every tab whose file the project has no more."""
        window = self._window
        for group in reversed(window.sides.groups):
            window.sides.enter(group)
            for file in group.tabs.files():
                if not self._is_there(file):
                    self.close(file)
        if window.current_file is not None and window.current_document is None:
            window.parts.leave()

    def _is_there(self, file: str) -> bool:
        return self._window.session.document(file) is not None or self._window.pages.has(file)

    # -- views -------------------------------------------------------------------------

    def _make_view(self, file: str) -> DocumentView:
        window, group = self._window, self._window.sides.current
        view = DocumentView(window.theme, file, project=lambda: window.session.project)
        view.origin = str((window.session.root / file).resolve())
        # Something may be dropped where the focus is not.
        view.edited.connect(lambda *_: window.sides.enter(group))
        view.edited.connect(lambda after, text: window.commit(after, text, file))
        view.selection_changed.connect(self._on_selection)
        view.activated.connect(self._on_activated)
        view.status.connect(window.say)
        view.filled_in.connect(window.fill_in)
        view.screen_asked.connect(window.designing.open)
        view.media_asked.connect(window.media_choice.add)
        view.file_asked.connect(window.media_choice.change)
        view.work_begun.connect(partial(follow, window.status.work))
        view.part_asked.connect(window.parts.insert)
        view.menu_requested.connect(window.context_menus.open)
        view.mends_asked.connect(window.mending.ask)
        view.module_dropped.connect(window.modules.add)
        group.add_view(view)
        return view

    def _on_selection(self, selected: tuple[Place, ...]) -> None:
        if self.sender() in (None, self._window.current_view):
            self._window.panels.settle_selection()

    def _on_activated(self, place: Place) -> None:
        """A double click or Enter on a card: its form gets the focus, or the part is shown."""
        window, view = self._window, self._window.current_view
        on_graph = view is not None and view.mode == "graph" and view.selected == (place,)
        if on_graph and window.parts.can_enter():
            window.parts.enter()
        else:
            window.fill_in(tuple(place))
