"""Copy, cut, paste and duplicate by the system's clipboard, on the canvas of a script."""

from __future__ import annotations

from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication

from situ.document import codec
from situ.document.spds import Spds
from situ_studio import script_copies as copies
from situ_studio.canvas import script_gestures as gestures
from situ_studio.canvas.script_commands import ScriptCommands
from situ_studio.copying import ORIGIN

MIME = "application/x-situ-situations+xml"
"""What was copied, as it stands in its script. The text beside it is a script by itself."""


class ScriptCopying(ScriptCommands):
    """Situations, data and modules, and what they refer to.

    origin: the path of the script.
    """

    origin: str = ""

    def _elsewhere(self) -> dict[str, tuple[str, ...]]:
        """Modules that the project declares outside of the script, with their resources."""
        project = self.project()
        if project is None or project.modules is None:
            return {}
        return {m.name: tuple(m.resources) for m in project.modules.modules}

    def copy(self) -> None:
        """What is selected to the clipboard; says so."""
        copied = copies.fragment(self.document, self.selection(), self._elsewhere())
        if copies.is_empty(copied):
            self.status.emit(self.tr("Situations, data and modules can be copied: select some"))
            return
        mime = QMimeData()
        mime.setData(MIME, codec.write(copied))
        mime.setData(ORIGIN, self.origin.encode())
        mime.setText(codec.write(copies.by_itself(self.document, copied)).decode())
        QGuiApplication.clipboard().setMimeData(mime)
        self.status.emit(self.tr("Copied: {0}").format(copies.named(copied)))

    def cut(self) -> None:
        """Copies what is selected and deletes it; nothing where it may not be deleted."""
        chosen = [p for p in self.selection() if copies.can_be_copied([p])]
        after, _ = gestures.delete(self.document, chosen)
        text = self.tr("Cut {0}").format(copies.named(copies.fragment(self.document, chosen)))
        breach = self._laws.breach(self.document, after)
        if breach:
            self.status.emit(breach)
        elif chosen:
            self.copy()
            self._edit(after, text)

    def paste(self) -> None:
        """What the clipboard holds, selected then; says in one line where that is nothing."""
        copied = self._from_clipboard()
        if copied is not None:
            self._put(*copies.paste(self.document, copied, self._below_chosen(), self._elsewhere()))

    def duplicate(self) -> None:
        self._put(*copies.duplicate(self.document, self.selection()))

    def _put(self, after: Spds, text: str, made: tuple[tuple[str, ...], ...]) -> None:
        if self._edit(after, text):
            self.select(made)
            self.bring_into_view(list(made[:1]))

    def _below_chosen(self) -> int | None:
        """The place in the precedence below the situation that is selected."""
        names = {p[1] for p in self.selection() if p[0] == "situation"}
        every = enumerate(self.document.situations, 1)
        return max((i for i, s in every if s.name in names), default=None)

    def _from_clipboard(self) -> Spds | None:
        # Where nothing was ever copied it is None, whatever the types of Qt say.
        there: QMimeData | None = QGuiApplication.clipboard().mimeData()
        mime = there if there is not None else QMimeData()
        origin = bytes(mime.data(ORIGIN).data()).decode() if mime.hasFormat(ORIGIN) else ""
        same = bool(origin) and origin == self.origin and mime.hasFormat(MIME)
        data = bytes(mime.data(MIME).data()) if same else mime.text().encode()
        copied, problems = codec.read(data, "clipboard") if data.strip() else (None, [])
        wrong = next((p for p in problems if p.severity == "error"), None)
        if isinstance(copied, Spds) and wrong is not None:
            told = self.tr("The text on the clipboard has errors. {0}")
            self.status.emit(told.format(wrong.message))
            return None
        if not isinstance(copied, Spds) or copies.is_empty(copied):
            self.status.emit(self.tr("There are no situations, data or modules on the clipboard"))
            return None
        return copied
