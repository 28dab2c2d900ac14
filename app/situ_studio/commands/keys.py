"""The keys of the commands: those of the table, and those that a person put in their place."""

from __future__ import annotations

from PySide6.QtCore import QSettings, Qt
from PySide6.QtGui import QKeySequence

from situ_studio.actions import COMMANDS, MENUS, Command, command
from situ_studio.commands.menus import told, translated
from situ_studio.wording.language import tr

CHANGED = "keys"
_ALONE = {Qt.Key.Key_Delete, Qt.Key.Key_Insert, Qt.Key.Key_Menu}
_FUNCTION = range(Qt.Key.Key_F1, Qt.Key.Key_F35 + 1)
_ARROWS = {Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down}
_TEXT = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier


class Keys:
    """What the settings keep at ``keys/<command id>``, laid over the table's ``shortcut``.

    A key of the table that a person gave to another command is the other command's only.
    """

    def __init__(self, settings: QSettings) -> None:
        self._settings = settings

    def every(self) -> dict[str, list[QKeySequence]]:
        """The keys of every command by its id, the one that can be changed first."""
        changed = {one.id: key for one in COMMANDS if (key := self._changed(one.id))}
        taken = {key.toString() for key in changed.values()}
        found = {}
        for one in COMMANDS:
            table = [QKeySequence(k) for k in (one.shortcut, one.also) if k]
            own = [changed[one.id], *table[1:]] if one.id in changed else table
            found[one.id] = [
                key
                for at, key in enumerate(own)
                if (at == 0 and one.id in changed) or key.toString() not in taken
            ]
        return found

    def _changed(self, id: str) -> QKeySequence | None:
        kept = QKeySequence(str(self._settings.value(f"{CHANGED}/{id}", "")))
        return None if kept.isEmpty() else kept

    def is_changed(self, id: str) -> bool:
        return self._changed(id) is not None

    def give(self, id: str, key: QKeySequence) -> str:
        """Gives a command this key; else one line: why it can not have it."""
        refused = _not_for_commands(key) or self._taken(id, key)
        if not refused:
            if key.toString() == QKeySequence(command(id).shortcut).toString():
                self._settings.remove(f"{CHANGED}/{id}")
            else:
                portable = key.toString(QKeySequence.SequenceFormat.PortableText)
                self._settings.setValue(f"{CHANGED}/{id}", portable)
        return refused

    def reset(self, id: str) -> str:
        """Gives a command the table's key again; else one line: what has that now."""
        key = QKeySequence(command(id).shortcut)
        refused = "" if key.isEmpty() else self._taken(id, key)
        if not refused:
            self._settings.remove(f"{CHANGED}/{id}")
        return refused

    def reset_all(self) -> None:
        self._settings.remove(CHANGED)

    def _taken(self, id: str, key: QKeySequence) -> str:
        """What has the key already, in one line."""
        for other, keys in self.every().items():
            if other != id and key.toString() in [one.toString() for one in keys]:
                return tr("{0} is the key of “{1}”: give that another one first.").format(
                    native(key), told(command(other))
                )
        return ""


def native(key: QKeySequence) -> str:
    """A key as this system writes it."""
    return key.toString(QKeySequence.SequenceFormat.NativeText)


def written(keys: list[QKeySequence]) -> str:
    return ", ".join(native(key) for key in keys)


def headed(one: Command) -> str:
    """The title of the menu under which a command's keys are listed."""
    return translated(one.menu.partition("/")[0])


def _not_for_commands(key: QKeySequence) -> str:
    """Why no command can have a key: text, menus and canvases have it. Nothing where one can."""
    if key.isEmpty():
        return tr("No key was pressed.")
    pressed = key[0]  # type: ignore[index]  # The stubs do not know it.
    held, bare = pressed.keyboardModifiers(), pressed.key()
    if not held & _TEXT and bare not in _ALONE and bare not in _FUNCTION:
        return tr("{0} alone writes or moves: press it together with Ctrl or Alt.").format(
            native(key)
        )
    if held == Qt.KeyboardModifier.AltModifier and bare in {ord(title[0]) for title in MENUS}:
        return tr("{0} opens a menu: press another key.").format(native(key))
    if held == Qt.KeyboardModifier.ControlModifier and bare in _ARROWS:
        return tr("{0} moves the selected cards: press another key.").format(native(key))
    return ""
