"""Each surface by Tab alone: what takes the keyboard is reached, seen, named, and something."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import shiboken6
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QAccessible
from PySide6.QtPrintSupport import QPrinter, QPrintPreviewDialog
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QCheckBox,
    QDialog,
    QTableView,
    QTreeView,
    QWidget,
)
from tests.gui.live.test_comparing import until as until_compared
from tests.gui.live.test_connecting import Told
from tests.gui.live.test_field import recorded, until_counted
from tests.gui.live.test_recordings import until_shown

from situ.blackboard.replies import Turn, Turns
from situ.document.change import Change
from situ_studio.canvas.viewer import Viewer
from situ_studio.commands.preferences import Preferences
from situ_studio.commands.shortcuts import Shortcuts
from situ_studio.edits.vocabulary import Vocabulary
from situ_studio.export.export_dialog import ExportDialog, What
from situ_studio.export.print_preview import reach_by_keys
from situ_studio.files.conflict import ConflictDialog
from situ_studio.live.connecting_dialog import ConnectDialog
from situ_studio.live.deploying import Deploying
from situ_studio.live.deploying_dialog import DeployDialog
from situ_studio.live.deploying_plan import Plan
from situ_studio.live.link import RobotLink
from situ_studio.live.nearby import Found
from situ_studio.live.raising_dialog import Offer, RaisingDialog
from situ_studio.live.setting_dialog import SettingDialog
from situ_studio.looks.theme import LIGHT
from situ_studio.project.differing import Differing
from situ_studio.screens.devices import USUAL
from situ_studio.screens.own_device import OwnDevice
from situ_studio.widgets.details import Details

Start = Callable[..., Any]
Copy = Callable[[str], Path]
NAME, DESCRIPTION = QAccessible.Text.Name, QAccessible.Text.Description
ROLE = QAccessible.Role
NOTHING = {ROLE.NoRole, ROLE.Client, ROLE.Border, ROLE.Pane, ROLE.Window}
"""What Qt takes for a widget of which nobody said what it is."""
MOST = 300
INSIDE = 12
"""Components of a screen that Tab goes through, and one more."""
CELLS = 60
"""Of a table that are heard."""


def faults(top: QWidget) -> list[str]:
    """Walks round once from what has the focus; what is wrong, a line each."""
    found: list[str] = []
    seen: list[QWidget] = []
    wanted = list(_stops(top))
    for _ in range(MOST):
        here = QApplication.focusWidget()
        if here is None:
            return [*found, "nothing has the focus"]
        if here in seen:
            break
        seen.append(here)
        found += _heard(here)
        if not _goes_on(here):
            return [*found, f"the focus stays at {_said(here)}"]
    else:
        found.append("it never comes round")
    # What the selection that a screen's components got on the way brings is not asked for.
    reached = [one for one in seen if shiboken6.isValid(one)]
    left = [one for one in _stops(top) if one in wanted and not _among(one, reached)]
    return found + [f"not reached: {_said(one)}" for one in left]


def _goes_on(here: QWidget) -> bool:
    """Tab leaves it: a drawing by F6, for in it Tab goes from card to card; a table at its end."""
    key = Qt.Key.Key_F6 if isinstance(here, Viewer) else Qt.Key.Key_Tab
    if isinstance(here, QTableView):
        QTest.keyClick(here, Qt.Key.Key_End, Qt.KeyboardModifier.ControlModifier)
    for _ in range(INSIDE):
        QTest.keyClick(here, key)
        QApplication.processEvents()
        if QApplication.focusWidget() is not here:
            return True
    return False


def _stops(top: QWidget) -> Iterator[QWidget]:
    for one in top.findChildren(QWidget):
        takes = one.focusPolicy() & Qt.FocusPolicy.TabFocus and not one.focusProxy()
        if takes and one.isVisible() and one.isEnabled() and one.window() is top.window():
            yield one


def _among(one: QWidget, reached: list[QWidget]) -> bool:
    """Itself, what it is in or holds; of several of which one is chosen, that one."""
    if any(it is one or it.isAncestorOf(one) or one.isAncestorOf(it) for it in reached):
        return True
    if QAccessible.queryAccessibleInterface(one).role() != ROLE.RadioButton:
        return False
    return any(it.parent() is one.parent() and type(it) is type(one) for it in reached)


def _heard(one: QWidget) -> list[str]:
    heard = QAccessible.queryAccessibleInterface(one)
    name, about = heard.text(NAME).strip(), heard.text(DESCRIPTION)
    if heard.role() == ROLE.ComboBox:
        # On Linux its name is what is chosen; readers take that of its label.
        name = " ".join(label.text(NAME) for label, _ in _labels(heard))
    wrong = []
    if not name:
        wrong.append("has no name")
    if heard.role() in NOTHING:
        wrong.append(f"is {heard.role().name}")
    if "<" in about:
        wrong.append(f"is described with tags: {about[:40]}")
    if one.visibleRegion().isEmpty():
        wrong.append("is not seen")
    wrong += [f"says {words} without the head of its column" for words in _headless(one)]
    return [f"{_said(one)} {fault}" for fault in wrong]


def _headless(one: QWidget) -> Iterator[str]:
    """The first cells of a table that are heard as a value of nothing."""
    if not isinstance(one, QTableView | QTreeView):
        return
    head = one.header() if isinstance(one, QTreeView) else one.horizontalHeader()
    model = one.model()
    heard: Any = QAccessible.queryAccessibleInterface(one)
    rows = [model.index(row, 0) for row in range(model.rowCount())]
    nested = isinstance(one, QTreeView) and any(map(model.hasChildren, rows))
    for part in map(heard.child, range(min(heard.childCount(), CELLS))):
        cell = part.tableCellInterface()
        # Where rows stand in rows, the first cell of each says which row it is.
        if head.isHidden() or cell is None or (nested and not cell.columnIndex()):
            continue
        title = model.headerData(cell.columnIndex(), Qt.Orientation.Horizontal)
        # Behind a comma stands how far a language is.
        if part.text(NAME) and title.partition(",")[0] not in part.text(NAME):
            yield part.text(NAME)


def _labels(heard: Any) -> list[Any]:
    return list(heard.relations(QAccessible.RelationFlag.Label))


def _said(one: QWidget) -> str:
    return f"{type(one).__name__} “{one.accessibleName()}” in {type(one.parent()).__name__}"


# -- the window ---------------------------------------------------------------------------------


def shown(used: Any, file: str, mode: str = "", *place: str) -> list[str]:
    """What is wrong with a view of a file, from the beginning of the next panel."""
    used.window.open_file(file)
    if mode:
        used.window.show_mode(mode)
    used.settle()
    if place:
        used.select(*place)
    return round_from_the_toolbar(used)


def round_from_the_toolbar(used: Any) -> list[str]:
    used.window.setFocus()
    used.key(Qt.Key.Key_F6)
    return faults(used.window)


def within(panel: QWidget) -> list[str]:
    """What is wrong with what Tab goes to in a panel."""
    QApplication.processEvents()
    return [fault for one in _stops(panel) for fault in _heard(one)]


def test_an_application_a_screen_and_the_pages(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    assert shown(used, "reception.rbd.xml", "graph", "state", "7") == []
    assert shown(used, "reception.rbd.xml", "split", "state", "5") == []
    assert shown(used, "reception.rbd.xml", "screen", "state", "5", "screen", "no") == []
    assert shown(used, "texts") == []
    assert shown(used, "media/") == []
    assert shown(used, "situ.toml") == []


def test_the_page_on_which_one_begins(studio: Start) -> None:
    assert round_from_the_toolbar(studio()) == []


def test_a_script_its_matrix_and_a_rehearsal(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    script = "conversation.spds.xml"
    assert shown(used, script, "both", "situation", "invited") == []
    used.window.rehearsing.clock = lambda: 0.0
    used.window.rehearsing.rehearse()
    used.settle()
    assert round_from_the_toolbar(used) == []
    used.window.rehearsing.end()


def test_the_panels_of_what_robots_did(studio: Start, project: Copy, tmp_path: Path) -> None:
    used = studio(project("reception"))
    window, robot = used.window, used.window.robot
    ours, other = recorded(tmp_path, "reception", "known-user.jsonl", "second-thoughts.jsonl")
    robot.open_recording(ours)
    until_shown(used)
    robot.follower.viewing.seek(16.0)
    used.select("state", "5")
    window.commands.ask_why()
    for panel in ("why", "trace", "blackboard", "authority", "problems"):
        window.bottom.choose(panel)
        assert within(window.bottom) == [], panel
    window.bottom.choose("timeline")
    robot.comparing.compare_with(other)
    until_compared(robot.comparing.comparing)
    window.commands.next_difference(1)
    assert round_from_the_toolbar(used) == []
    robot.close_recording()
    window.field.count([ours, other])
    until_counted(used)
    for panel in ("field", "scenarios", "find"):
        window.bottom.choose(panel)
        assert within(window.bottom) == [], panel


# -- dialogs ------------------------------------------------------------------------------------


def asked(dialog: QWidget) -> list[str]:
    """What is wrong with a dialog, which is gone after."""
    dialog.show()
    dialog.activateWindow()
    assert QTest.qWaitForWindowActive(dialog)
    QApplication.processEvents()
    found = faults(dialog)
    dialog.close()
    dialog.deleteLater()
    return found


def connecting(window: QWidget) -> QWidget:
    """Connect, with a robot that was found."""
    nearby = Told()
    dialog = ConnectDialog("tcp://127.0.0.1:5570", nearby, LIGHT, window)
    nearby.tell(Found("ward at rob1", "ready", "tcp://10.0.0.5:5570", "ab"))
    return dialog


def deploying(window: QWidget) -> QWidget:
    """Deploy, with something to send and a version to go back to."""
    link = Deploying(RobotLink(window), window)
    turn = Turn(0.0, 1, "operator:ann", "deployed")
    link.turns = Turns(id=1, turns=(turn,), version=1, kept=(0, 1))
    change = Change(file="a.rbd.xml", place=("state", "1"), text="state a: timeout 30 → 60 s")
    plan = Plan({"a.rbd.xml": b""}, "a.rbd.xml", (change,))
    dialog = DeployDialog(link, lambda: plan, LIGHT, window)
    dialog.settle()
    return dialog


def test_every_dialog(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    window = used.window
    areas: dict[What, QRectF] = {"whole": QRectF(0, 0, 9, 9), "seen": QRectF(0, 0, 5, 5)}
    known = Vocabulary(tags=("user.name",), data=(("near", "boolean", ""),))
    offers = [Offer("clickYes", "button"), Offer("timeout", "")]
    file = "reception.rbd.xml"
    document = used.session.document(file)
    differing = Differing(file, document, document, None, used.session.project, gone=True)
    assert asked(Preferences(window.windows, window)) == []
    assert asked(ExportDialog("a.png", areas, window)) == []
    assert asked(RaisingDialog(offers, "", ("clickYes",), window)) == []
    assert asked(SettingDialog(known, {"near": True}, window)) == []
    assert asked(ConflictDialog(differing, window)) == []
    assert asked(Details("A fault", "It went wrong.", "line", window, unfolded=True)) == []
    assert asked(OwnDevice(USUAL, window)) == []
    assert asked(connecting(window)) == []
    assert asked(deploying(window)) == []
    printer = QPrinter()
    printer.setOutputFormat(QPrinter.OutputFormat.PdfFormat)
    preview = QPrintPreviewDialog(printer, window)
    reach_by_keys(preview)
    preview.resize(960, 720)
    assert asked(preview) == []
    window.actions_.actions["shortcuts"].trigger()
    (keys,) = window.findChildren(Shortcuts)
    assert asked(keys) == []
    window.helping.show_topic("kind/state")
    assert asked(window.helping.shown) == []


def shown_dialog() -> QDialog:
    """The one that a command has opened."""
    every = (one for one in QApplication.topLevelWidgets() if isinstance(one, QDialog))
    (dialog,) = (one for one in every if one.isVisible())
    return dialog


def test_dialogs_that_commands_open(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    window = used.window
    window.open_file("register.rbd.xml")
    for command in ("rename_file", "delete_file"):
        window.actions_.actions[command].trigger()
        assert asked(shown_dialog()) == []
    window.rehearsing.clock = lambda: 0.0
    window.rehearsing.rehearse()
    used.settle()
    window.rehearsing.save()
    assert asked(shown_dialog()) == []
    window.rehearsing.end()


def test_the_preview_of_a_screen_and_its_sample_values(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.window.open_file("reception.rbd.xml")
    used.window.show_mode("screen")
    used.select("state", "5")
    designer = used.window.designing.designer
    designer.open_preview()
    used.settle()
    page = QAccessible.queryAccessibleInterface(designer.preview.page)
    assert "Are these your initials?" in page.text(DESCRIPTION)
    designer.preview.page.setFocus()
    told = []
    for _ in range(2):
        QTest.keyClick(designer.preview.page, Qt.Key.Key_Tab)
        told.append(page.text(DESCRIPTION))
    assert told == ["Home", "Repeat"]
    assert asked(designer.preview) == []
    designer.sampling.open()
    popup = QApplication.activePopupWidget()
    assert popup is not None
    assert QApplication.focusWidget() is popup.findChildren(QCheckBox)[0]
    assert faults(popup) == []
    popup.close()


# -- what lies over the window ------------------------------------------------------------------


def heard_after(used: Any, arrow: Qt.Key, view: QAbstractItemView) -> str:
    """The row that is current then, as it is heard; it is another than before."""
    before = view.currentIndex().row()
    used.key(arrow)
    assert view.currentIndex().row() != before
    row: Any = QAccessible.queryAccessibleInterface(view).focusChild()
    return str(row.text(NAME)) if row is not None else ""


def test_what_is_typed_for_is_gone_through_by_arrows_and_left_by_tab(
    studio: Start, project: Copy
) -> None:
    used = studio(project("reception"))
    finder = used.window.finder
    used.key(Qt.Key.Key_K, Qt.KeyboardModifier.ControlModifier)
    assert QApplication.focusWidget() is finder.field
    assert within(finder) == []
    assert heard_after(used, Qt.Key.Key_Down, finder.list)
    used.key(Qt.Key.Key_Tab)
    assert not finder.isVisible()
    assert used.window.current_view.isAncestorOf(QApplication.focusWidget())
    for kind, arrow in (("image", Qt.Key.Key_Down), ("sound", Qt.Key.Key_Up)):
        used.select("state", "5")
        used.window.commands.insert(kind)
        used.settle()
        picker = used.window.media_choice.picker
        assert within(picker) == []
        # There is nothing else to go to: Escape or a row leave it.
        used.key(Qt.Key.Key_Tab)
        assert picker.field.hasFocus()
        assert heard_after(used, arrow, picker.list)
        used.key(Qt.Key.Key_Escape)
        assert used.window.media_choice.picker is None
