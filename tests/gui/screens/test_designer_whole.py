"""From an empty project, with mouse and keys only: the reception's screen *intro* and its state."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from msgspec.structs import replace
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractButton, QApplication

from situ.document import codec, rbd
from situ.document.aside import NOTHING
from situ.resources import example

Start = Callable[..., Any]
CONTROL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


class Hands:
    """Press what is seen, write where the cursor is."""

    def __init__(self, used: Any) -> None:
        self.used, self.window = used, used.window

    @property
    def form(self) -> Any:
        return self.window.inspector.form

    @property
    def designer(self) -> Any:
        return self.window.current_view.piece("designer")

    def write(self, **fields: str) -> None:
        """Fields of the form, one after the other."""
        for name, text in fields.items():
            self.used.fill(self.form.field(name), text, Qt.Key.Key_Tab)

    def view(self, name: str) -> None:
        self.used.click(self.window.tabs.views.button(name))

    def press(self, kind: str) -> None:
        self.used.click(self.window.palette_.item(kind))

    def state(self, name: str) -> None:
        """One more state, named where the cursor is."""
        self.press("state")
        self.used.type(name)
        self.used.key(Qt.Key.Key_Return)

    def go_to(self, row: str) -> None:
        outline = self.window.outline.list
        self.used.click_row(outline, self.used.row_with(outline, row))

    def component(self, kind: str, **fields: str) -> None:
        self.used.click(self.designer.side.components.items[kind])
        self.write(**fields)

    def has_file(self, path: Path) -> None:
        """Chooses that file when the project has none of the kind and asks for one."""
        self.used.answers.put("media_file", str(path))

    def tick(self, flag: Any) -> None:
        flag.setFocus()
        self.used.key(Qt.Key.Key_Space)


def written(state: rbd.State) -> str:
    """A state as its file has it, but for where its card is."""
    application = rbd.Application(name="a", states=(replace(state, aside=NOTHING),))
    return codec.write(application).decode()


def test_the_intro_of_the_reception_is_drawn_from_nothing(studio: Start, tmp_path: Path) -> None:
    used = studio()
    me = Hands(used)
    used.answers.put("new_folder", str(tmp_path))
    used.answers.put("name", "reception")
    used.click(used.window.welcome.new)
    me.state("intro")
    me.state("enter initial 1")

    # The screen: two texts, a picture from elsewhere, a button.
    me.go_to("intro")
    me.view("screen")
    me.component(
        "text", text="Hello!", id="hello", x="6", y="20", width="54", height="14", size="11"
    )
    me.component(
        "text",
        text="I am the robot nurse. Shall we see how you are today?",
        id="who", x="6", y="36", width="54", height="28", size="7",
    )  # fmt: skip
    me.has_file(example("reception") / "media" / "robot.png")
    me.component("image", id="robot", x="62", y="18", width="32", height="48")
    me.component("button", text="CONTINUE", id="continue", event="clickContinue")
    me.write(x="28", y="70", width="44", height="24", size="8")
    # The state shall expect what the button sends.
    mends = me.form.told("touched").findChildren(QAbstractButton)
    used.click(next(b for b in mends if b.isVisible()))

    # The state: its timeout, what it does, and where the button leads.
    me.view("graph")
    me.go_to("intro")
    me.write(timeout="60")
    used.choose(me.form._timeout.next, "1 start")
    me.tick(me.form._timeout.idle)
    me.has_file(example("reception") / "media" / "chime.wav")
    me.press("sound")
    me.go_to("intro")
    me.press("robot")
    me.write(resource="head", command="nod")
    me.tick(me.form.field("optional"))
    me.go_to("intro")
    me.press("speech")
    me.write(
        text="Hello! I am the robot nurse. Shall we see how you are today? Please touch continue."
    )
    me.go_to("intro")
    used.click(me.form.section("events").rows.row(0))
    used.choose(me.form.field("next"), "3 enter initial 1")
    for phrase in ("continue", "go on", "yes"):
        says = me.form.section("says")
        used.click(next(b for b in says.findChildren(QAbstractButton) if "phrase" in b.toolTip()))
        focus = QApplication.focusWidget()
        used.key(Qt.Key.Key_A, CONTROL)
        used.type(phrase)
        assert focus is not None
        used.key(Qt.Key.Key_Return)

    used.key(Qt.Key.Key_S, CONTROL)
    assert used.session.dirty == []
    file = next(tmp_path.rglob("*.rbd.xml"))
    made, problems = codec.read(file.read_bytes(), str(file))
    wanted, _ = codec.read((example("reception") / "reception.rbd.xml").read_bytes(), "reception")
    assert problems == []
    assert isinstance(made, rbd.Application)
    assert isinstance(wanted, rbd.Application)
    mine, theirs = made.state("2"), wanted.state("2")
    assert mine is not None
    assert theirs is not None
    assert written(mine) == written(theirs)
    for name in ("robot.png", "chime.wav"):
        copied = next(tmp_path.rglob(name))
        assert copied.read_bytes() == (example("reception") / "media" / name).read_bytes()
