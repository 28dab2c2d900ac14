"""What the commands about projects and their files do: open, save, copy, leave."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from situ.document.beginning import project_name
from situ.document.export import deployable, write_out
from situ.document.ready import load_ready
from situ.errors import SituError
from situ_studio.commands.situation_commands import SituationCommands
from situ_studio.files.opening import Reading, is_large
from situ_studio.project import projects
from situ_studio.wording.language import said, spoken


class FileCommands(SituationCommands):
    """The handlers of one window that are about files."""

    def _home(self) -> str:
        there = [p for p in self._window.welcoming.recent if Path(p).exists()]
        return str(Path(there[0]).parent) if there else str(Path.home())

    def new_project(self, template: str = "empty") -> None:
        """Makes a project of a template, named and put where the person says, and opens it.

        It is written in the language that the studio speaks: that of who begins it.
        """
        dialogs = self._window.dialogs
        given = dialogs.name(self.tr("New project"), self.tr("Name"), "my-robot")
        if given is None:
            return
        name = project_name(given)
        parent = dialogs.new_folder(self._home(), self.tr("Where shall its folder be?"))
        if parent is not None:
            make = partial(projects.new_project, Path(parent), name, template, spoken())
            self._open(make, new=True)

    def open_project(self) -> None:
        path = self._window.dialogs.project(self._home())
        if path is not None:
            self.open_path(path)

    def open_path(self, path: str) -> None:
        """Opens a project: in the window that has it, in this one, or in one of its own."""
        windows = self._window.windows
        there = windows.window_of(Path(path)) if windows is not None else None
        if there is None:
            self._open(lambda: Path(path))
            return
        there.welcoming.leave()
        there.show()
        there.raise_()
        there.activateWindow()
        if there is not self._window:
            there.say(self.tr("This project is open here already."))

    def open_example(self, name: str) -> None:
        """Opens a copy of an example, made where the person says."""
        parent = self._window.dialogs.new_folder(
            self._home(), self.tr("Where shall the copy of the example be?")
        )
        if parent is not None:
            self._open(lambda: projects.copy_example(name, Path(parent)))

    def _open(self, made: Callable[[], Path], new: bool = False) -> None:
        """Opens what ``made`` gives. Where a project is open here, the person is asked in which
        window; unsaved changes of this one are asked about before anything is made."""
        window, project = self._window, self._session.project
        where = "here" if project is None else window.dialogs.where(project.name)
        if where == "new" and window.windows is not None:
            windows = window.windows
            shown = self._try(lambda: windows.show_project(made()))
        elif where == "here" and window.may_leave():
            shown = self._try(lambda: self._read(made()))
        else:
            return
        if shown and new:
            # A newcomer sees what a state is made of, and what comes next goes beside it.
            opened = window if where == "here" else window.windows and window.windows.windows[-1]
            if opened:
                opened.select(("state", "1"))

    def _read(self, path: Path) -> None:
        """Opens a project here; a large one is read beside the window, and can be cancelled."""
        if is_large(path):
            Reading(self._window, path, lambda window, why: window.dialogs.tell(why))
        else:
            self._window.open_project(path)

    def forget_recent(self, path: str) -> None:
        """Takes a project off the list of recent ones; its files stay."""
        self._window.welcoming.forget(path)

    def locate_recent(self, path: str) -> None:
        """Asks where a recent project is now, and opens it there."""
        found = self._window.dialogs.project(str(Path(path).parent))
        if found is not None:
            self._window.welcoming.move(path, Path(found))
            self.open_path(found)

    def show_welcome(self) -> None:
        self._window.welcoming.show()

    def save(self) -> bool:
        """Saves every changed document; False where a person or the disk said no."""
        self._window.finish_fields()
        conflicts = self._session.reconciling.conflicts()
        if not all(self._window.disk.resolve(file) for file in conflicts):
            return False
        try:
            self._session.save()
        except SituError as error:
            self._window.disk.tell_unsaved(error)
            return False
        self._window.disk.tell_saved()
        return True

    def save_copy(self) -> bool:
        """Puts the project, as it is here, into a folder that the person names, and goes on there.

        The folder that it came from stays as it is.
        """
        self._window.finish_fields()
        parent = self._window.dialogs.new_folder(
            self._home(), self.tr("Where shall the copy of the project be?")
        )
        return parent is not None and self._try(lambda: self._session.save_copy(Path(parent)))

    def export_picture(self) -> None:
        """Writes the drawing, as it is here, into a file that the person names."""
        self._window.finish_fields()
        self._try(self._window.exporting.export)

    def export_for_robot(self) -> None:
        """Writes what a robot needs of the project into a folder of its own, as it is saved."""
        window = self._window
        window.finish_fields()
        if self._session.dirty:
            window.say(self.tr("Save first: what is saved is exported."))
            return
        title = self.tr("Where shall the folder for the robot be?")
        parent = window.dialogs.new_folder(self._home(), title)
        if parent is None:
            return
        output = Path(parent) / f"{self._session.root.name}-robot"
        if self._try(lambda: write_out(deployable(load_ready(self._session.root)), output)):
            window.say(self.tr("Exported to {0}").format(output))

    def print_drawing(self) -> None:
        self._window.finish_fields()
        self._try(self._window.exporting.print_)

    def has_document_file(self) -> bool:
        return self._window.document_files.file is not None

    def can_have_another(self) -> bool:
        return self._window.document_files.is_application

    def rename_file(self) -> None:
        self._window.document_files.rename()

    def duplicate_application(self) -> None:
        self._window.document_files.duplicate()

    def delete_file(self) -> None:
        self._window.document_files.delete()

    def close_tab(self) -> None:
        self._window.open_files.close_chosen()

    def close_window(self) -> None:
        self._window.close()

    def quit(self) -> None:
        """Closes all windows, unless a person wants to stay in one."""
        windows = self._window.windows
        if windows is not None:
            windows.quit()

    def new_window(self) -> None:
        if self._window.windows is not None:
            self._window.windows.new_window()

    def show_log(self) -> None:
        if self._window.windows is not None:
            self._window.windows.show_log(self._window)

    def _try(self, what: Callable[[], object]) -> bool:
        """Does something that may fail, and says in one line why it did."""
        try:
            what()
        except (SituError, OSError) as error:
            self._window.dialogs.tell(said(str(error)))
            return False
        return True
