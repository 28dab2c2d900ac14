"""The modules that a script does not name yet: of the project's files, and of a running robot."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEvent, QMimeData, QPoint, QPointF, Qt
from PySide6.QtGui import QDragEnterEvent, QDragMoveEvent, QDropEvent, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QListView
from tests.gui.live.conftest import DEADLINE, Running, robot, until

import situ
from situ.blackboard.protocol import Offer
from situ.blackboard.replies import ModuleState
from situ.document.folder import load
from situ.document.modules import Module, Modules, Provides, Requires
from situ_studio.kinds import MODULE_MIME
from situ_studio.panels.more_modules import words
from situ_studio.project.known_modules import Known, added, known

__all__ = ["DEADLINE", "Running", "robot", "until"]

LEFT = Qt.MouseButton.LeftButton
CONTROL = Qt.KeyboardModifier.ControlModifier
SEER = Module(
    "seer",
    ("head",),
    "Looks out for smoke.",
    (Requires(data="camera.left"),),
    (Provides("smoke.seen", "boolean"), Provides("sound.slap", "number", "deg")),
)
SCRIPT = "conversation.spds.xml"


def conversation(project: Callable[[str], Path]) -> Any:
    found, _ = load(project("conversation"))
    assert found is not None
    return found


def test_an_added_module_is_declared_and_what_it_provides_observed(project: Any) -> None:
    found = conversation(project)
    changed, text = added(found, found.spds, SCRIPT, Known(SEER))
    after: Any = changed[SCRIPT]
    assert after.modules[-1].resources == ("head",)
    assert [o.tag for o in after.observe[len(found.spds.observe) :]] == ["smoke.seen"]
    assert after.situations == found.spds.situations
    information: Any = changed["modules.xml"]
    assert information.modules[-1] == SEER
    assert text == "Add seer to the script"


def test_in_a_situation_it_takes_nothing_from_the_others(project: Any) -> None:
    found = conversation(project)
    changed, _ = added(found, found.spds, SCRIPT, Known(SEER), "sound")
    script: Any = changed[SCRIPT]
    before = found.spds.priorities(found.spds.situation("sound"))
    now = script.priorities(script.situation("sound"))
    assert now.pop("seer") < min(before.values())
    assert now == before
    again = replace(found, spds=script, modules=changed["modules.xml"])
    assert added(again, script, SCRIPT, Known(SEER), "sound")[0] == {}


def test_what_a_file_says_of_a_module_counts_before_what_it_says_itself(project: Any) -> None:
    found = replace(conversation(project), modules=Modules((SEER,)))
    told = ModuleState("seer", False, True, True, ("base",), (), "Other words.", (), ())
    every = known(found, (told,))
    assert every["seer"].module == SEER
    assert every["seer"].present
    assert every["converse"].application


def test_its_words_say_what_it_needs_and_provides() -> None:
    assert words(Known(SEER, present=True)).splitlines() == [
        "Looks out for smoke.",
        "Connected to the robot now.",
        "Moves or uses: head",
        "Needs: camera.left",
        "Provides: smoke.seen (boolean), sound.slap (deg)",
    ]


@pytest.fixture
def drawing(studio: Callable[..., Any], project: Callable[[str], Path]) -> Any:
    """A window on the script, which has lost one of its modules."""
    it = studio(project("conversation"))
    script = it.session.document(SCRIPT)
    left = replace(
        script,
        modules=tuple(m for m in script.modules if m.name != "nod"),
        situations=tuple(
            replace(s, entries=tuple(e for e in s.entries if e.module != "nod"))
            for s in script.situations
        ),
    )
    it.window.open_file(SCRIPT)
    it.session.commit(SCRIPT, left, "Take nod out")
    it.settle()
    return it


def names(it: Any) -> list[str]:
    model = it.window.outline.more.list.model()
    return [model.index(row, 0).data() for row in range(model.rowCount())]


def test_enter_adds_the_module_and_it_leaves_the_list(drawing: Any) -> None:
    more = drawing.window.outline.more
    row = names(drawing).index("nod")
    more.list.setFocus()
    more.list.setCurrentIndex(more.list.model().index(row, 0))
    drawing.key(Qt.Key.Key_Return)
    assert "nod" not in names(drawing)
    assert "nod" in {m.name for m in drawing.session.document(SCRIPT).modules}
    assert drawing.window.current_view.selected == (("module", "nod"),)
    drawing.session.undo()
    drawing.settle()
    assert "nod" in names(drawing)


def test_in_a_high_window_all_are_seen_right_below_their_heading(drawing: Any) -> None:
    drawing.window.resize(1280, 1440)
    drawing.settle()
    more = drawing.window.outline.more
    assert more.list.geometry().top() - more.title.geometry().bottom() <= 3
    assert more.list.verticalScrollBar().maximum() == 0
    assert more.list.height() == more.list.sizeHintForRow(0) * len(names(drawing))


def test_a_module_dropped_on_a_situation_gets_a_priority_there(drawing: Any) -> None:
    model = drawing.window.outline.more.list.model()
    data: QMimeData = model.mimeData([model.index(names(drawing).index("nod"), 0)])
    assert data.hasFormat(MODULE_MIME)
    drop_on_sound(drawing, data)
    script = drawing.session.document(SCRIPT)
    assert "nod" in script.priorities(script.situation("sound"))
    assert drawing.session.undo_text == "Add nod to the script"


def drop_on_sound(it: Any, data: QMimeData) -> None:
    """Onto the card of that situation."""
    canvas = it.window.current_view.canvas
    viewer = canvas.viewer
    place = ("situation", "sound")
    card = next(n.view for uid, n in canvas.graph.nodes.items() if canvas._place(uid) == place)
    spot = viewer.mapFromScene(card.sceneBoundingRect().center())
    assert viewer.viewport().rect().contains(spot)
    drag(viewer.viewport(), data, spot)
    it.settle()


def held_move(widget: Any, at: QPoint) -> None:
    # QTest.mouseMove holds no button.
    where, none = QPointF(at), Qt.KeyboardModifier.NoModifier
    move, there = QEvent.Type.MouseMove, widget.mapToGlobal(where)
    QApplication.sendEvent(widget, QMouseEvent(move, where, there, LEFT, LEFT, none))


def drag(target: Any, data: QMimeData, spot: QPoint) -> None:
    """A drag that is let go: what Qt sends, for offscreen nobody holds a mouse."""
    copy, left = Qt.DropAction.CopyAction, Qt.MouseButton.LeftButton
    held = Qt.KeyboardModifier.NoModifier
    QApplication.sendEvent(target, QDragEnterEvent(spot, copy, data, left, held))
    QApplication.sendEvent(target, QDragMoveEvent(spot, copy, data, left, held))
    QApplication.sendEvent(target, QDropEvent(QPointF(spot), copy, data, left, held))


def test_a_module_that_connects_to_the_robot_tells_of_itself_here(
    drawing: Any, robot: Any, until: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its row is dragged by the mouse onto a situation: all that comes of it is one step."""
    carried: list[QMimeData] = []

    def begin(rows: QListView, _actions: Qt.DropAction) -> None:
        # Qt's own drag waits for a hand that offscreen nobody has.
        carried.append(rows.model().mimeData(rows.selectedIndexes()))

    window = drawing.window
    # One draws while the robot runs: the outline stays, not the column of the moment.
    window.settings.setValue("moment_open/robot", False)
    monkeypatch.setattr(type(window.outline.more.list), "startDrag", begin, raising=False)
    there = robot(Path(drawing.session.project.root))
    link = window.robot.link
    drawing.answers.put("robot", there.endpoint)
    drawing.key(Qt.Key.Key_R, CONTROL)
    present = window.modules.present
    until(present.changed, lambda: link.connected)
    with situ.connect(
        there.endpoint,
        module="seer",
        resources=["head"],
        description=SEER.description,
        provides=[Offer("smoke.seen", "boolean")],
    ):
        until(present.changed, lambda: "seer" in {m.name for m in present.modules if m.present})
        assert names(drawing)[0] == "seer"
        before = drawing.session.document(SCRIPT)
        drawing.settle()
        rows = window.outline.more.list
        area = rows.visualRect(rows.model().index(0, 0))
        QTest.mousePress(rows.viewport(), LEFT, pos=area.center())
        for way in (4, 12, 30):
            held_move(rows.viewport(), area.center() + QPoint(way, 0))
        QTest.mouseRelease(rows.viewport(), LEFT, pos=area.center() + QPoint(30, 0))
        assert len(carried) == 1
        drop_on_sound(drawing, carried[0])
        script = drawing.session.document(SCRIPT)
        assert "seer" in {m.name for m in script.modules}
        assert "smoke.seen" in {o.tag for o in script.observe}
        assert "seer" in script.priorities(script.situation("sound"))
        information = drawing.session.document("modules.xml")
        assert information.modules[-1].description == SEER.description
        assert names(drawing)[:1] != ["seer"]
        window.actions_.actions["undo"].trigger()
        drawing.settle()
        assert drawing.session.document(SCRIPT) == before
        assert names(drawing)[0] == "seer"
    until(present.changed, lambda: not any(m.name == "seer" and m.present for m in present.modules))
    window.robot.disconnect_robot()
    assert present.modules == ()
