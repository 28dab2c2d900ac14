"""What the commands of ``actions.COMMANDS`` do, and when they can be done."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from PySide6.QtWidgets import QApplication

import situ
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ.document.words import listed
from situ_studio.actions import command
from situ_studio.commands.component_commands import ComponentCommands
from situ_studio.commands.insert_commands import InsertCommands
from situ_studio.commands.menus import told
from situ_studio.commands.preferences import Preferences
from situ_studio.commands.shortcuts import Shortcuts
from situ_studio.edits.lacking import lacking
from situ_studio.finding.find import Find, places_of
from situ_studio.panels.project_tree import stem
from situ_studio.screens import ordering
from situ_studio.screens.guides import Axis
from situ_studio.views.showing import show_beside
from situ_studio.welcome import recent

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow


class Commands(InsertCommands):
    """The handlers of one window."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self.components = ComponentCommands(window)

    # -- when ------------------------------------------------------------------------

    def has_document(self) -> bool:
        return self._window.current_view is not None

    def has_project(self) -> bool:
        return self._session.project is not None and self._window.stack.currentIndex() == 1

    def has_pages(self) -> bool:
        """Whether there is a project with a ``situ.toml``, no document alone."""
        project = self._session.project
        return self.has_project() and project is not None and project.toml is not None

    def has_tabs(self) -> bool:
        return self.has_project() and bool(self._window.tabs.files())

    def show_page(self, key: str) -> None:
        self._window.open_file(key)

    def can_undo(self) -> bool:
        return self._session.undo_text is not None

    def can_redo(self) -> bool:
        return self._session.redo_text is not None

    def has_graph(self) -> bool:
        view = self._window.current_view
        return view is not None and view.has_graph

    def is_script(self) -> bool:
        return isinstance(self._window.current_document, Spds)

    def _can(self, method: str, selected: bool = True) -> bool:
        view = self._window.current_view
        return view is not None and (bool(view.selected) or not selected) and view.can(method)

    def has_found(self) -> bool:
        return self._window.finding.panel.has_hits

    def has_problems(self) -> bool:
        return self.has_project() and bool(self._session.problems)

    def can_find_usages(self) -> bool:
        return self._window.finding.can_find_usages()

    def can_rename_everywhere(self) -> bool:
        return self._window.finding.can_rename()

    def can_copy(self) -> bool:
        """States, notes and frames, components of a screen, parts of a script, or cells."""
        return self.can_duplicate() or self.cells is not None

    def can_duplicate(self) -> bool:
        on_application = self.has_selection() and self.is_application()
        return on_application or self.has_parts_of_script()

    def can_follow(self) -> bool:
        """Whether pipes of the graph can be followed from what is selected."""
        return self.has_cards() or (self.on_script() and self.has_selection())

    def can_order(self) -> bool:
        return bool(self.components.chosen)

    def has_designer(self) -> bool:
        return self.components.guiding is not None

    def has_guides(self) -> bool:
        guiding = self.components.guiding
        return guiding is not None and bool(guiding.guides)

    def add_guide(self, axis: Axis) -> None:
        guiding = self.components.guiding
        if guiding is not None:
            guiding.add(axis)

    def clear_guides(self) -> None:
        guiding = self.components.guiding
        if guiding is not None:
            guiding.clear()

    def can_paste(self) -> bool:
        return self.is_application() or self.on_parts_of_script() or self.cells is not None

    def has_cells(self) -> bool:
        return self.cells is not None

    def on_cells(self, method: str) -> None:
        """Of the matrix what a spreadsheet does with a range."""
        if self.cells is not None:
            getattr(self.cells.range, method)()

    @property
    def cells(self) -> Any:
        """The matrix of a script, where it is what somebody works in; None elsewhere."""
        view, focus = self._window.current_view, QApplication.focusWidget()
        matrix = view.piece("matrix") if view is not None else None
        if view is None or matrix is None or not matrix.isVisible():
            return None
        within = focus is not None and matrix.isAncestorOf(focus)
        return matrix if within or view.mode == "matrix" else None

    def can_align(self) -> bool:
        return self._components() > 0 or self.has_two_cards()

    def can_space(self) -> bool:
        count = self._components()
        return count > 2 or (count == 0 and self.has_three_cards())

    def _components(self) -> int:
        """How many components are selected on the screen that is seen."""
        sheet = self.components.sheet
        return len(sheet.selected) if sheet is not None else 0

    def can_auto_layout(self) -> bool:
        return self._can("auto_layout", selected=False)

    def can_make_part(self) -> bool:
        return self._window.parts.can_make()

    def can_enter_part(self) -> bool:
        return self._window.parts.can_enter()

    def can_leave_part(self) -> bool:
        return self._window.parts.can_leave()

    def shows_view(self, mode: str) -> bool:
        view = self._window.current_view
        return view is not None and view.shown_as == mode

    def has_language(self, choice: str) -> bool:
        windows = self._window.windows
        return windows is not None and windows.language == choice

    def has_letters(self, choice: str) -> bool:
        windows = self._window.windows
        return windows is not None and windows.letters == choice

    def has_theme(self, choice: str) -> bool:
        return self._window.theme_choice == choice

    # -- editing ---------------------------------------------------------------------

    def undo(self) -> None:
        self._window.finish_fields()
        view = self._window.current_view
        self._session.undo(view.selected if view is not None else ())

    def redo(self) -> None:
        self._session.redo()

    def on_view(self, method: str) -> None:
        view = self._window.current_view
        if view is not None:
            view.call(method)

    def copy(self) -> None:
        if self.components.chosen:
            self.components.copy()
        elif self.cells is not None:
            self.cells.copy()
        else:
            self.on_view("copy")

    def cut(self) -> None:
        if self.cells is not None and not self._in_form():
            self.cells.cut()
        elif not self.components.chosen:
            self._unless_in_form("cut")
        elif not self._in_form():
            self.components.cut()

    def duplicate(self) -> None:
        if self.components.chosen:
            self.components.duplicate()
        else:
            self.on_view("duplicate")

    def paste(self) -> None:
        """Says too what the pasted states need and this project does not have."""
        if self.cells is not None:
            self.cells.paste()
            return
        if self.components.can_paste:
            self.components.paste()
            return
        view, before = self._window.current_view, self._window.current_document
        if view is None:
            return
        view.call("paste")
        after, project = self._window.current_document, self._session.project
        if after is before or project is None or not isinstance(after, Application):
            return
        missing = lacking(project, self._window.media, after, view.selected)
        if missing:
            self._window.say(
                self.tr("Pasted. This project does not have {0}: copy the files too.").format(
                    listed(missing)
                )
            )

    def delete(self) -> None:
        """Components of a screen alone where they are what is selected, not their state."""
        if not self.components.chosen:
            self._unless_in_form("delete_selection")
        elif not self._in_form():
            self.components.delete(self.tr("Delete {0}"))

    def rename(self) -> None:
        """Of a component on a sheet, its text."""
        if not self.components.write():
            self.on_view("rename")

    def order(self, way: ordering.Way) -> None:
        self.components.order(way)

    def _unless_in_form(self, method: str) -> None:
        """What takes a thing away is not meant by somebody who is in its form."""
        if not self._in_form():
            self.on_view(method)

    def _in_form(self) -> bool:
        focus = QApplication.focusWidget()
        return focus is not None and self._window.inspector.isAncestorOf(focus)

    def align(self, edge: str) -> None:
        """Of the components selected on the screen, where there are some, else of the cards."""
        view = self._window.current_view
        sheet = self.components.sheet
        if sheet is not None and sheet.selected:
            sheet.align(edge)
        elif view is not None:
            view.call("align", edge)

    def rename_everywhere(self) -> None:
        self._window.finding.rename_everywhere()

    def make_part(self) -> None:
        self._window.parts.make()

    def dissolve_part(self) -> None:
        self._window.parts.dissolve()

    def enter_part(self) -> None:
        self._window.parts.enter()

    def leave_part(self) -> None:
        self._window.parts.leave()

    # -- looking -----------------------------------------------------------------------

    def show_view(self, mode: str) -> None:
        self._window.show_mode(mode)

    def open_beside(self) -> None:
        file = self._window.tabs.chosen_file
        if file is not None:
            show_beside(self._window, file)

    def zoom_by(self, factor: float) -> None:
        view = self._window.current_view
        if view is not None:
            view.call("zoom_in" if factor > 1 else "zoom_out")

    def zoom_to_actual_size(self) -> None:
        view = self._window.current_view
        if view is not None:
            view.call("set_zoom", 1.0)

    def zoom_to_selection(self) -> None:
        view = self._window.current_view
        if view is not None:
            view.call("zoom_to", view.selected)

    def next_panel(self, way: int) -> None:
        self._window.next_panel(way)

    def can_reopen_tab(self) -> bool:
        return self.has_project() and self._window.tabs.has_closed

    def reopen_tab(self) -> None:
        self._window.open_files.reopen()

    def reset_layout(self) -> None:
        self._window.reset_layout()

    def choose_language(self, choice: str) -> None:
        if self._window.windows is not None:
            self._window.windows.choose_language(choice)

    def choose_letters(self, choice: str) -> None:
        if self._window.windows is not None:
            self._window.windows.choose_letters(choice)

    def choose_theme(self, choice: str) -> None:
        self._window.choose_theme(choice)

    def find(self) -> None:
        """Opens the field that finds anything, with everything in it."""
        self._window.finder.open(self.everything(), recent.commands(self._window.settings))

    def everything(self) -> list[Find]:
        """Commands, with why where one can not be done now, then all of the project's names."""
        window = self._window
        window.actions_.refresh()
        found = []
        for id, action in window.actions_.actions.items():
            if not action.isVisible() or id == "find":
                continue
            one = command(id)
            # What undo and redo would do stands in their actions only.
            text = told(one) if "/" in one.menu else action.text().replace("&&", "&").rstrip("…")
            if action.isEnabled():
                keys = action.shortcut().toString()
                found.append(Find(text, one.icon, "text2", keys, action.trigger, one.menu, id))
            else:
                said = window.actions_.reason(one)
                say = partial(window.say, f"{text}: {said}")
                found.append(Find(text, one.icon, "text2", said, say, one.menu, id, said))
        found += window.pages.findable()
        project = self._session.project
        for file in self._session.files if project is not None else ():
            document = self._session.document(file)
            if document is None:
                continue
            for place, icon, token, text, more in places_of(document):
                found.append(
                    Find(
                        text,
                        icon,
                        token,
                        stem(file),
                        partial(window.go_to, file, place),
                        more,
                    )
                )
        return found

    def find_in_project(self) -> None:
        self._window.finding.open()

    def find_next(self, by: int) -> None:
        self._window.finding.panel.step(by)

    def find_usages(self) -> None:
        self._window.finding.find_usages()

    def find_here(self) -> None:
        self._window.outline.toggle_search()

    # -- going somewhere ----------------------------------------------------------------

    def next_problem(self, by: int) -> None:
        self._window.problems.step(by)

    def mend(self) -> None:
        self._window.mending.ask()

    def next_tab(self, by: int) -> None:
        self._window.tabs.step(by)

    def context_menu(self) -> None:
        self._window.context_menus.open_at_selection()

    def show_help(self) -> None:
        self._window.helping.open()

    def show_tutorial(self) -> None:
        self._window.helping.show_tutorial()

    def ask_what_this_is(self) -> None:
        self._window.helping.ask()

    def show_shortcuts(self) -> None:
        Shortcuts(self._window.keys.every(), self._window).show()

    def show_preferences(self) -> None:
        windows = self._window.windows
        if windows is not None:
            Preferences(windows, self._window).show()

    def about(self) -> None:
        self._window.dialogs.tell(
            self.tr("Situ Studio {0}\nDraw what a robot says, shows and does.").format(
                situ.__version__
            )
        )
