"""What stands round the documents of a window: brought up to date with what is open, shown and
selected."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from situ.document.rbd import Application
from situ_studio.problems import problem_rows

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow


class PanelsSide(QObject):
    """Title, status, project tree, outline, form, problems. Nothing here changes a document."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window

    def settle_shown(self) -> None:
        """Another file is shown, or another group of tabs is the current one."""
        self.settle_title()
        self.settle_problems()
        self._window.disk.settle()
        self._window.project_tree.show_current(self._window.current_file)
        self.settle_document()

    def settle_document(self) -> None:
        """The current document is another one, or there is none."""
        self.settle_value()
        self._window.actions_.refresh()

    def settle_value(self) -> None:
        """The current document is another value; ``settle_stack`` comes next, for the commands."""
        window = self._window
        document, project = window.current_document, window.session.project
        window.palette_.show_document(document)
        window.status.show_counts(document)
        window.status.show_project(project is not None)
        self.settle_outline()
        self._settle_selected()
        if project is not None and document is not None:
            application = isinstance(document, Application)
            window.headers["outline"].title.setText(
                self.tr("Outline") if application else self.tr("Modules")
            )

    def settle_outline(self) -> None:
        window = self._window
        project, file = window.session.project, window.current_file
        if project is None or file is None:
            return
        window.modules.settle()
        found = tuple(window.session.problems_of(file))
        window.outline.show_document(project, window.current_document, found)

    def settle_selection(self) -> None:
        """Something else is selected in the current document, or it is no longer what it was."""
        self._settle_selected()
        self._window.actions_.refresh()

    def _settle_selected(self) -> None:
        window = self._window
        view, document, project = (
            window.current_view,
            window.current_document,
            window.session.project,
        )
        if view is None or document is None or project is None:
            window.inspector.show_nothing(
                self.tr("What is selected in a drawing can be changed here.")
            )
            window.inspector.usages.hide()
            window.status.show_selection(())
        else:
            vocabulary = window.vocabulary(document)
            found = tuple(window.session.problems_of(view.file))
            window.inspector.show_selection(document, view.selected, vocabulary, found, project)
            window.commands.components.offer_tags(vocabulary.tags)
            window.inspector.usages.setVisible(window.commands.can_find_usages())
            window.outline.select(view.selected)
            window.status.show_selection(view.selected)
        window.designing.settle()

    def settle_problems(self) -> None:
        window, found = self._window, self._window.session.problems
        window.problems.show_problems(problem_rows.rows(window.session, window.current_file))
        window.bottom.set_count("problems", len(found))
        errors = sum(1 for p in found if p.severity == "error")
        window.status.show_problems(errors, len(found) - errors)

    def settle_stack(self) -> None:
        """What can be undone, redone or saved is not what it was."""
        window, session = self._window, self._window.session
        undo, redo = session.undo_text, session.redo_text
        actions = window.actions_.actions
        undo_text = self.tr("Undo: {0}").format(undo) if undo else self.tr("Undo")
        redo_text = self.tr("Redo: {0}").format(redo) if redo else self.tr("Redo")
        # An ampersand in a name begins no mnemonic.
        actions["undo"].setText(undo_text.replace("&", "&&"))
        actions["redo"].setText(redo_text.replace("&", "&&"))
        there = session.project is not None
        window.status.show_saved(len(session.dirty), session.saved_at, there)
        self.settle_title()
        self.settle_files()
        window.actions_.refresh()

    def settle_files(self) -> None:
        """Files in the project's tree and in tabs: what each is, has wrong, has not saved."""
        window, session = self._window, self._window.session
        dirty = session.dirty
        for file in session.files:
            document = session.document(file)
            if document is None:
                continue
            found = {p.severity for p in session.problems_of(file)}
            marks = tuple(m for m in ("error", "warning") if m in found)[:1]
            part = window.parts.is_part(file)
            window.project_tree.show_document(file, document, part, file in dirty, marks)
        for group in window.sides.groups:
            group.tabs.show_unsaved((*dirty, *window.pages.unsaved()))

    def settle_title(self) -> None:
        """The project's name, with a star while something is not saved."""
        window, project = self._window, self._window.session.project
        if project is None or window.stack.currentIndex() == 0:
            window.setWindowTitle(self.tr("Situ Studio"))
            return
        star = "*" if window.session.dirty else ""
        window.setWindowTitle(self.tr("{0}{1} — Situ Studio").format(project.name, star))
        window.toolbar.show()
