"""The icons: one family, each of them used, none missing."""

from __future__ import annotations

import ast
from pathlib import Path
from xml.etree import ElementTree

from PySide6.QtCore import QRectF
from PySide6.QtGui import QImage, QPainter
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QApplication

import situ_studio
from situ.resources import resource
from situ_studio import actions, kinds
from situ_studio.looks import icons

FILES = sorted(file for file in resource("icons").iterdir() if file.name.endswith(".svg"))
NAMES = {Path(file.name).stem for file in FILES}
FAMILY = [file for file in FILES if file.name != "situ.svg"]
"""All but the program's own sign, which has colours."""
ROOT = {
    "width": "20",
    "height": "20",
    "viewBox": "0 0 20 20",
    "fill": "none",
    "stroke": "currentColor",
    "stroke-width": "1.5",
    "stroke-linecap": "round",
    "stroke-linejoin": "round",
}


def written() -> set[str]:
    """Every word that stands in the studio's code between quotation marks."""
    found: set[str] = set()
    for file in Path(situ_studio.__file__).parent.rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                found.add(node.value)
    return found | {command.icon for command in actions.COMMANDS}


def asked() -> set[str]:
    """What is asked for by name where icons are made, drawn and shown."""
    makers = ("icon", "paint", "pixmap", "renderer", "IconLabel", "IconButton", "ThemedButton")
    found: set[str] = set()
    for file in Path(situ_studio.__file__).parent.rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.Call):
                continue
            name = node.func.attr if isinstance(node.func, ast.Attribute) else ""
            name = node.func.id if isinstance(node.func, ast.Name) else name
            arguments = [*node.args[:2]] if name in makers else []
            arguments += [word.value for word in node.keywords if word.arg == "icon"]
            for one in arguments:
                if isinstance(one, ast.Constant) and isinstance(one.value, str) and one.value:
                    found.add(one.value)
    return found


def faults_of(file: Path) -> list[str]:
    """What of a file is not of the family."""
    svg = ElementTree.fromstring(file.read_text(encoding="utf-8"))
    found = [] if dict(svg.attrib) == ROOT else [f"{file.name}: {svg.attrib}"]
    for shape in svg.iter():
        fill, line = shape.get("fill"), shape.get("stroke")
        # Lines of one width; what is filled has no line round it; no colour of its own.
        filled = (fill, line) == ("currentColor", "none")
        if shape is not svg and not (filled or (fill, line) == (None, None)):
            found.append(f"{file.name}: filled with {fill}, its line is {line}")
        if shape is not svg and {"stroke-width", "style", "transform"} & set(shape.attrib):
            found.append(f"{file.name}: {shape.attrib}")
    return found


def outside_of(file: Path, scale: int = 4, margin: float = 1.5) -> bool:
    """Whether anything is drawn over the grid's margin, in units of the grid."""
    side = 20 * scale
    drawn = QImage(side, side, QImage.Format.Format_Alpha8)
    drawn.fill(0)
    shape = QSvgRenderer(str(file))
    assert shape.isValid(), file.name
    painter = QPainter(drawn)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    shape.render(painter, QRectF(0, 0, side, side))
    painter.end()
    step, bits, edge = drawn.bytesPerLine(), bytes(drawn.constBits()), int(margin * scale)
    rows = [bits[y * step : y * step + side] for y in range(side)]
    assert any(map(any, rows)), f"{file.name} draws nothing"
    beside = [row[:edge] + row[-edge:] for row in rows[edge:-edge]]
    return max(max(row) for row in [*rows[:edge], *rows[-edge:], *beside]) > 40


def test_icons_are_of_one_family() -> None:
    assert [fault for file in FAMILY for fault in faults_of(file)] == []


def test_icons_keep_to_their_grid(qt: QApplication) -> None:
    assert [file.name for file in FAMILY if outside_of(file)] == []


def test_no_icon_is_missing_and_none_is_unused() -> None:
    named = asked() | {command.icon for command in actions.COMMANDS if command.icon}
    named |= {kind.icon for kind in kinds.KINDS} | set(actions.SUBMENU_ICONS.values())
    assert named - NAMES == set(), "asked for, but not in resources/icons"
    assert NAMES - written() == set(), "in resources/icons, but used nowhere"


def test_every_command_of_the_toolbar_has_an_icon_of_its_own() -> None:
    in_toolbar = [c for c in actions.COMMANDS if c.toolbar and not c.shown]
    given = [c.icon for c in in_toolbar]
    assert all(given), [c.id for c in in_toolbar if not c.icon]
    assert len(set(given)) == len(given)


def test_two_commands_that_stand_in_one_menu_do_not_look_the_same() -> None:
    same: dict[tuple[str, str], list[str]] = {}
    for command in actions.COMMANDS:
        if command.icon and not command.shown:
            same.setdefault((command.menu, command.icon), []).append(command.id)
    assert [ids for ids in same.values() if len(ids) > 1] == []


def test_an_icon_is_drawn_in_the_colour_asked_for(qt: QApplication) -> None:
    picture = icons.pixmap("start", "#FF0000", 20, 1.0).toImage()
    colours = {
        picture.pixelColor(x, y).name()
        for x in range(20)
        for y in range(20)
        if picture.pixelColor(x, y).alpha() == 255
    }
    assert colours == {"#ff0000"}
