"""What is asked before a document gets another name or is deleted: what changes, and where."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QDialog,
    QFrame,
    QLabel,
    QLineEdit,
    QListWidget,
    QVBoxLayout,
    QWidget,
)

from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio.edits.document_uses import Renaming, Use, own_name
from situ_studio.edits.edit import Document
from situ_studio.files.proposed_names import ProposedNames
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Flag
from situ_studio.panels.project_tree import kind
from situ_studio.widgets.dialog_buttons import add_buttons


class RenameDocument(QDialog):
    """Asks for another name of a document's file, and shows what follows.

    stem: what the file is called. An application or a script gets the new name itself too, unless
    a person says no. names: what a name leads to.
    """

    agreed = Signal(object)
    """The ``Renaming`` that is wanted."""

    def __init__(
        self, stem: str, document: Document, names: ProposedNames, theme: Theme, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._names = names
        self._renaming: Renaming | None = None
        self.setWindowTitle(self.tr("Rename {0}").format(kind(document)))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(px(480), px(360))
        column = _column(self)
        column.addWidget(_label(self.tr("Name of the file"), "strong"))
        self.name = QLineEdit(stem)
        self.name.setAccessibleName(self.tr("Name of the file"))
        self.name.selectAll()
        column.addWidget(self.name)
        called = own_name(document)
        self.too = Flag(theme, self._too(document, called == stem))
        self.too.setChecked(called == stem)
        self.too.setVisible(called is not None)
        column.addWidget(self.too)
        self.why = _label("", "refused")
        column.addWidget(self.why)
        column.addWidget(_label(self.tr("What changes"), "strong"))
        self.list = _rows(column, self.tr("What changes"))
        hint = self.tr("All of it is one step, which Undo takes back; files change when you save.")
        column.addWidget(_label(hint, "hint"))
        self.rename = add_buttons(self, column, self.tr("Rename"), self._agree)
        self.name.textChanged.connect(self._settle)
        self.too.toggled.connect(self._settle)
        self.name.setFocus()
        self._settle()

    def _too(self, document: Document, same: bool) -> str:
        """What it is about the document's own name; same: it has the file's now."""
        called = own_name(document)
        if isinstance(document, Spds):
            if same:
                return self.tr("The script itself is called so too")
            return self.tr("The script is called so too, not {0}").format(called)
        if same:
            return self.tr("The application itself is called so too")
        return self.tr("The application is called so too, not {0}").format(called)

    def _settle(self) -> None:
        stem = self.name.text().strip()
        found = self._names.of(stem, self.too.isChecked())
        self._renaming = found if isinstance(found, Renaming) else None
        self.why.setText(found if isinstance(found, str) else "")
        self.why.setVisible(bool(self.why.text()))
        _fill(self.list, self._renaming.uses if self._renaming is not None else ())
        self.rename.setEnabled(self._renaming is not None)

    def _agree(self) -> None:
        # Of what the files are by now: another program may have changed them since a key was hit.
        self._names.look_again()
        self._settle()
        if self._renaming is not None:
            self.accept()
            self.agreed.emit(self._renaming)


class DeleteDocument(QDialog):
    """Asks whether a file shall be deleted, and shows what still refers to it.

    uses: what that is; nothing is told too.
    """

    agreed = Signal()

    def __init__(
        self, file: str, document: Document, uses: tuple[Use, ...], parent: QWidget
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Delete {0}").format(kind(document)))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(px(480), px(300) if uses else px(160))
        column = _column(self)
        column.addWidget(_label(self.tr("Delete {0}?").format(file), "strong"))
        told = self.tr("Undo brings it back. When you save, the file goes into the waste basket.")
        column.addWidget(_label(told, "label"))
        still = self.tr("Still refers to what stands in it")
        if isinstance(document, Application):
            still = self.tr("Still refers to it, and will not work any more")
        if uses:
            column.addWidget(_label(still, "strong"))
            self.list = _rows(column, still)
            _fill(self.list, uses)
        else:
            column.addWidget(_label(self.tr("Nothing else refers to it."), "label"))
            column.addStretch(1)
        self.delete = add_buttons(self, column, self.tr("Delete"), self._agree)
        self.delete.setFocus()

    def _agree(self) -> None:
        self.accept()
        self.agreed.emit()


def _column(dialog: QDialog) -> QVBoxLayout:
    column = QVBoxLayout(dialog)
    column.setContentsMargins(24, 20, 24, 20)
    column.setSpacing(10)
    return column


def _label(text: str, role: str) -> QLabel:
    label = QLabel(text)
    label.setProperty("role", role)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setWordWrap(True)
    return label


def _rows(column: QVBoxLayout, name: str) -> QListWidget:
    rows = QListWidget()
    rows.setAccessibleName(name)
    rows.setWordWrap(True)
    rows.setFrameShape(QFrame.Shape.NoFrame)
    rows.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    box = QFrame()
    box.setProperty("role", "box")
    inner = QVBoxLayout(box)
    inner.setContentsMargins(4, 4, 4, 4)
    inner.addWidget(rows)
    column.addWidget(box, 1)
    return rows


def _fill(rows: QListWidget, uses: Iterable[Use]) -> None:
    rows.clear()
    rows.addItems([f"{use.file}: {use.words}" for use in uses])
