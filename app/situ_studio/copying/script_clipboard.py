"""Copy, cut, paste and duplicate by the system's clipboard, for every view of a script."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication

from situ.document import codec
from situ.document.project import Project
from situ.document.spds import Spds
from situ_studio.canvas import script_gestures as gestures
from situ_studio.canvas.script_laws import Laws
from situ_studio.copying import script_copies as copies
from situ_studio.copying.clipboard import ORIGIN
from situ_studio.edits.edit import Place
from situ_studio.wording.language import said, tr

MIME = "application/x-situ-situations+xml"
"""What was copied, as it stands in its script. The text beside it is a script by itself."""


class ScriptView(Protocol):
    """A view of a script. origin: the path of the script; project: at the time of the call."""

    origin: str
    project: Callable[[], Project | None]
    edited: Any
    status: Any

    def selection(self) -> tuple[Place, ...]: ...
    def choose_copies(self, made: tuple[Place, ...]) -> None:
        """Selects what was pasted, where it can be seen."""
        ...


class ScriptCopying:
    """What one view of a script can do with the clipboard: with situations, data and modules, and
    what they refer to. script: as it is at the time of the call.
    """

    def __init__(self, view: ScriptView, script: Callable[[], Spds], laws: Laws) -> None:
        self._view = view
        self._script = script
        self._laws = laws

    def copy(self) -> None:
        """What is selected to the clipboard; says so."""
        script = self._script()
        copied = copies.fragment(script, self._view.selection(), self._elsewhere())
        if copies.is_empty(copied):
            self._say(tr("Situations, data and modules can be copied: select some"))
            return
        mime = QMimeData()
        mime.setData(MIME, codec.write(copied))
        mime.setData(ORIGIN, self._view.origin.encode())
        mime.setText(codec.write(copies.by_itself(script, copied)).decode())
        QGuiApplication.clipboard().setMimeData(mime)
        self._say(tr("Copied: {0}").format(copies.named(copied)))

    def cut(self) -> None:
        """Copies what is selected and deletes it; nothing where it may not be deleted."""
        script = self._script()
        chosen = [p for p in self._view.selection() if copies.can_be_copied([p])]
        after, _ = gestures.delete(script, chosen)
        text = tr("Cut {0}").format(copies.named(copies.fragment(script, chosen)))
        breach = self._laws.breach(script, after)
        if breach:
            self._say(breach)
        elif chosen:
            self.copy()
            self._view.edited.emit(after, text)

    def paste(self) -> None:
        """What the clipboard holds, selected then; says in one line where that is nothing."""
        copied = self._from_clipboard()
        if copied is not None:
            script, index = self._script(), self._below_chosen()
            self._put(*copies.paste(script, copied, index, self._elsewhere()))

    def duplicate(self) -> None:
        self._put(*copies.duplicate(self._script(), self._view.selection()))

    def _put(self, after: Spds, text: str, made: tuple[Place, ...]) -> None:
        breach = self._laws.breach(self._script(), after) if text else ""
        if breach:
            self._say(breach)
        elif text:
            self._view.edited.emit(after, text)
            self._view.choose_copies(made)

    def _say(self, line: str) -> None:
        self._view.status.emit(line)

    def _elsewhere(self) -> dict[str, tuple[str, ...]]:
        """Modules that the project declares outside of the script, with their resources."""
        project = self._view.project()
        if project is None or project.modules is None:
            return {}
        return {m.name: tuple(m.resources) for m in project.modules.modules}

    def _below_chosen(self) -> int | None:
        """The place in the precedence below the situation that is selected."""
        names = {p[1] for p in self._view.selection() if p[0] == "situation"}
        every = enumerate(self._script().situations, 1)
        return max((i for i, s in every if s.name in names), default=None)

    def _from_clipboard(self) -> Spds | None:
        # Where nothing was ever copied it is None, whatever the types of Qt say.
        there: QMimeData | None = QGuiApplication.clipboard().mimeData()
        mime = there if there is not None else QMimeData()
        origin = bytes(mime.data(ORIGIN).data()).decode() if mime.hasFormat(ORIGIN) else ""
        same = bool(origin) and origin == self._view.origin and mime.hasFormat(MIME)
        data = bytes(mime.data(MIME).data()) if same else mime.text().encode()
        copied, problems = codec.read(data, "clipboard") if data.strip() else (None, [])
        wrong = next((p for p in problems if p.severity == "error"), None)
        if isinstance(copied, Spds) and wrong is not None:
            told = tr("The text on the clipboard has errors. {0}")
            self._say(told.format(said(wrong.message)))
            return None
        if not isinstance(copied, Spds) or copies.is_empty(copied):
            self._say(tr("There are no situations, data or modules on the clipboard"))
            return None
        return copied
