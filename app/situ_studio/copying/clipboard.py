"""Copy, cut, paste and duplicate by the system's clipboard, for every view of an application."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication

from situ.document import codec
from situ.document.rbd import Application
from situ_studio.canvas import gestures
from situ_studio.copying import copies
from situ_studio.edits.edit import Place
from situ_studio.wording.language import said, tr

MIME = "application/x-situ-states+xml"
"""Copied states, notes and frames: an application of their own, as a file has it."""
ORIGIN = "application/x-situ-origin"
"""Beside it: the path of the file that they come from, as UTF-8."""


class Copying:
    """What a view of a document can do with the clipboard; the view says the rest.

    The clipboard holds XML as text too, so that any text editor takes it, and text that is an
    application is pasted like what was copied here. origin: the path of the view's document.
    """

    origin: str = ""
    # Of the views, which are QWidgets.
    edited: Any
    status: Any
    select: Any

    def copied_document(self) -> Application | None:
        """The document, with a place for every card; None where it is no application."""
        raise NotImplementedError

    def selection(self) -> tuple[Place, ...]:
        raise NotImplementedError

    def paste_corner(self) -> tuple[float, float] | None:
        """Where the corner of what is pasted goes; None: the view shows no places."""
        raise NotImplementedError

    def _chosen(self) -> Application | None:
        document = self.copied_document()
        copied = copies.fragment(document, self.selection()) if document is not None else None
        return copied if copied is not None and not copies.is_empty(copied) else None

    def copy(self) -> None:
        """What is selected to the clipboard; says so."""
        copied = self._chosen()
        if copied is None:
            self.status.emit(tr("States, notes and frames can be copied: select some"))
            return
        data = codec.write(copied)
        mime = QMimeData()
        mime.setData(MIME, data)
        mime.setData(ORIGIN, self.origin.encode())
        mime.setText(data.decode())
        QGuiApplication.clipboard().setMimeData(mime)
        self.status.emit(tr("{0} copied").format(copies.counted(copied)))

    def cut(self) -> None:
        """Copies what is selected and deletes it, with what leads there."""
        copied, document = self._chosen(), self.copied_document()
        if copied is None or document is None:
            return
        self.copy()
        gone = [p for p in self.selection() if len(p) == 2 and p[0] != "always"]
        after, _ = gestures.delete(document, gone)
        self.edited.emit(after, tr("Cut {0}").format(copies.named(copied)))

    def paste(self) -> None:
        """What the clipboard holds, selected then; says in one line where that is nothing."""
        document = self.copied_document()
        copied = self._from_clipboard()
        if copied is None or document is None:
            return
        mime = QGuiApplication.clipboard().mimeData()
        origin = bytes(mime.data(ORIGIN).data()).decode() if mime.hasFormat(ORIGIN) else ""
        same = bool(origin) and origin == self.origin
        if same and copies.fits(document, copied):
            at = copies.corner(copied)
        else:
            at = self.paste_corner() or copies.below(document)
        after, text, made = copies.paste(document, copied, at, same=same)
        self.edited.emit(after, text)
        self.select(made)

    def _from_clipboard(self) -> Application | None:
        # Where nothing was ever copied it is None, whatever the types of Qt say.
        there: QMimeData | None = QGuiApplication.clipboard().mimeData()
        mime = there if there is not None else QMimeData()
        data = bytes(mime.data(MIME).data()) if mime.hasFormat(MIME) else mime.text().encode()
        copied, problems = codec.read(data, "clipboard") if data.strip() else (None, [])
        wrong = next((p for p in problems if p.severity == "error"), None)
        if isinstance(copied, Application) and wrong is not None:
            told = tr("The text on the clipboard has errors. {0}")
            self.status.emit(told.format(said(wrong.message)))
            return None
        if not isinstance(copied, Application) or copies.is_empty(copied):
            self.status.emit(tr("There are no states on the clipboard"))
            return None
        return copied

    def duplicate(self) -> None:
        document = self.copied_document()
        if document is None:
            return
        after, text, made = copies.duplicate(document, self.selection())
        if text:
            self.edited.emit(after, text)
            self.select(made)
