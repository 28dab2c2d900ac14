"""The style sheet of the whole window, made from a theme's tokens.

What a style sheet can not say (arrows, ticks, list rows) is painted by the
widgets themselves from the same tokens.
"""

from __future__ import annotations

import re

import msgspec
from PySide6.QtGui import QPalette

from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme

# Doubled braces are the style sheet's own. Widgets say what they are by their property `role`.
_SHEET = """
* {{ font-family: "Inter", "Noto Sans CJK JP", "Noto Sans", sans-serif; font-size: 13px; }}
QWidget {{ color: {text}; }}
QMainWindow, QDialog {{ background: {panel}; }}
QMainWindow::separator {{ background: {line}; width: 1px; height: 1px; }}
QMainWindow::separator:hover {{ background: {accent}; }}
QToolTip {{ background: {text}; color: {panel}; border: 0; padding: 4px 8px; font-size: 12px; }}

QMenuBar {{ background: {panel}; color: {text2}; padding: 0 4px; spacing: 0; font-size: 13px; }}
QMenuBar::item {{ padding: 6px 8px; border-radius: 6px; background: transparent; }}
QMenuBar::item:selected, QMenuBar::item:pressed {{ background: {hover}; color: {text}; }}
QMenu {{ background: {panel}; border: 1px solid {line_strong}; padding: 4px;
  menu-scrollable: 1; }}
QMenu::item {{ padding: 5px 28px 5px 8px; border-radius: 4px; }}
QMenu::item:selected {{ background: {accent_soft}; color: {text}; }}
QMenu::item:disabled {{ color: {text3}; }}
QMenu::icon {{ margin-left: 6px; border: 1px solid transparent; border-radius: 4px; padding: 1px; }}
QMenu::icon:checked {{ background: {accent_soft}; border-color: {accent}; }}
QMenu::separator {{ height: 1px; background: {line}; margin: 4px 8px; }}

QToolBar {{ background: {panel}; border: 0; border-bottom: 1px solid {line};
  padding: 0 8px; spacing: 4px; }}
QToolBar::separator {{ background: {line}; width: 1px; margin: 0 8px; }}
QToolBar QToolButton {{ border: 0; border-radius: 6px; padding: 0 5px; min-width: 18px;
  min-height: 28px; max-height: 28px; color: {text2}; font-weight: 500; }}
QToolBar QToolButton:hover {{ background: {hover}; }}
QToolBar QToolButton:pressed, QToolBar QToolButton:checked {{ background: {accent_soft};
  color: {accent}; }}
QToolBar QToolButton:disabled {{ color: {text3}; }}
QToolBar QToolButton[role="outlined"] {{ border: 1px solid {line_strong}; color: {text};
  padding: 0 2px 0 10px; min-height: 26px; max-height: 26px; }}
QToolBar QToolButton:focus {{ border: 2px solid {accent}; padding: 0 3px; min-height: 24px;
  max-height: 24px; }}
QToolBar QToolButton[role="outlined"]:focus {{ padding: 0 1px 0 9px; }}

QPushButton {{ border: 1px solid {line_strong}; border-radius: 6px; background: {panel};
  color: {text}; padding: 0 12px; min-height: 26px; font-weight: 500; }}
QPushButton:hover {{ background: {hover}; }}
QPushButton:pressed {{ background: {accent_soft}; }}
QPushButton:focus {{ border: 2px solid {accent}; padding: 0 11px; min-height: 24px; }}
QPushButton:disabled {{ color: {text3}; }}
QPushButton[role="filled"] {{ background: {accent}; border-color: {accent}; color: {on_accent};
  font-weight: 600; }}
QPushButton[role="filled"]:hover {{ background: {accent_over}; border-color: {accent_over}; }}
QPushButton[role="filled"]:focus {{ border-color: {text}; }}
QPushButton[role="filled"]:disabled {{ background: {hover}; border-color: {line};
  color: {text3}; }}
QPushButton[role="mend"] {{ border-color: {accent_line}; color: {accent}; font-size: 12px;
  padding: 0 8px; min-height: 20px; border-radius: 5px; }}
QPushButton[role="mend"]:disabled {{ border-color: {line}; color: {text3}; }}
QPushButton[role="bare"], QToolButton[role="bare"] {{ border: 1px solid transparent;
  background: transparent; border-radius: 6px; padding: 0; color: {text2}; }}
QPushButton[role="bare"]:hover, QToolButton[role="bare"]:hover {{ background: {hover}; }}
QToolButton[role="bare"]:focus, QPushButton[role="bare"]:focus {{ border: 2px solid {accent};
  padding: 0; }}
QToolButton[role="opens"] {{ border: 1px solid transparent; background: transparent;
  border-radius: 6px; padding: 2px 16px 2px 6px; color: {text2}; }}
QToolButton[role="opens"]:hover {{ background: {hover}; }}
QToolButton[role="opens"]:focus {{ border-color: {accent}; }}
QPushButton[role="link"] {{ border: 1px solid transparent; background: transparent;
  color: {text2}; padding: 0 4px; }}
QPushButton[role="link"]:hover {{ color: {accent}; }}
QPushButton[role="link"]:focus {{ border: 2px solid {accent}; padding: 0 3px; }}
QPushButton[role="search"] {{ border: 1px solid {line}; background: {field}; color: {text3};
  font-weight: 400; text-align: left; padding: 0 8px; }}
QPushButton[role="search"]:hover {{ border-color: {line_strong}; background: {hover}; }}
QPushButton[role="search"]:focus {{ border: 2px solid {accent}; padding: 0 7px; }}
QPushButton[role="palette"] {{ border: 1px solid {line}; color: {text}; font-size: 12px;
  font-weight: 400; text-align: left; padding: 0 7px; min-height: 26px; max-height: 26px; }}
QPushButton[role="palette"][dense="true"] {{ min-height: 22px; max-height: 22px; }}
QPushButton[role="palette"]:hover {{ border-color: {line_strong}; background: {hover}; }}
QPushButton[role="palette"]:focus {{ border: 2px solid {accent}; padding: 0 6px;
  min-height: 24px; max-height: 24px; }}
QPushButton[role="palette"][dense="true"]:focus {{ min-height: 20px; max-height: 20px; }}

QToolButton[role="cell"] {{ border: 1px solid {line}; border-radius: 6px; background: {panel}; }}
QToolButton[role="cell"]:hover {{ border-color: {line_strong}; background: {hover}; }}
QToolButton[role="cell"]:checked {{ border-color: {accent_line}; background: {accent_soft}; }}
QToolButton[role="cell"]:focus {{ border: 2px solid {accent}; }}
QPushButton[role="answer"] {{ border-color: {line}; text-align: left; padding: 0 8px;
  min-height: 28px; font-size: 12px; }}
QPushButton[role="answer"]:focus {{ border: 2px solid {accent}; padding: 0 7px; min-height: 26px; }}

QLabel {{ background: transparent; }}
QLabel[role="heading"] {{ font-size: 12px; font-weight: 600; }}
QLabel[role="subject"] {{ font-size: 13px; font-weight: 600; }}
QLabel[role="section"] {{ font-size: 15px; font-weight: 600; }}
QLabel[role="welcome"] {{ font-size: 28px; font-weight: 600; }}
QLabel[role="lead"] {{ font-size: 15px; color: {text2}; }}
QLabel[role="strong"] {{ font-weight: 600; }}
QLabel[role="medium"] {{ font-weight: 500; }}
QLabel[role="label"] {{ font-size: 12px; color: {text2}; }}
QLabel[role="dim"] {{ color: {text2}; }}
QLabel[role="hint"] {{ font-size: 11px; color: {text3}; }}
QLabel[role="under"] {{ font-size: 12px; }}
QLabel[role="rowtitle"] {{ font-size: 12px; font-weight: 500; }}
QToolButton[role="over"] {{ border: 0; border-radius: 4px; background: {hover}; }}
QToolButton[role="over"]:hover {{ background: {line}; }}
QLabel[role="words"] {{ font-size: 12px; color: {text2}; }}
QLabel[role="refused"] {{ font-size: 11px; color: {error}; }}
QLabel[severity="error"] {{ font-size: 12px; color: {error}; }}
QLabel[severity="warning"] {{ font-size: 12px; color: {warning}; }}
QLabel[role="kbd"] {{ font-size: 11px; color: {text3}; border: 1px solid {line};
  border-radius: 4px; padding: 0 4px; background: {panel}; }}
QLabel[role="pill"] {{ font-size: 11px; font-weight: 500; border-radius: 4px; padding: 1px 6px;
  background: {state_soft}; color: {state}; }}
{pills}
QLabel[role="count"] {{ font-size: 11px; font-weight: 500; border-radius: 8px; padding: 0 5px;
  background: {hover}; color: {text2}; }}

QScrollArea, QAbstractScrollArea {{ border: 0; }}
QLineEdit, QPlainTextEdit, QComboBox, QAbstractSpinBox {{ border: 1px solid {line};
  border-radius: 6px; background: {field}; color: {text}; selection-background-color: {accent};
  selection-color: {on_accent}; placeholder-text-color: {text3}; }}
QLineEdit, QComboBox, QAbstractSpinBox {{ padding: 0 7px; min-height: 26px; max-height: 26px; }}
QComboBox {{ padding-left: 9px; padding-right: 22px; }}
QPlainTextEdit {{ padding: 2px 4px; }}
QLineEdit:hover, QComboBox:hover, QPlainTextEdit:hover,
QAbstractSpinBox:hover {{ border-color: {line_strong}; }}
QLineEdit:focus, QComboBox:focus, QPlainTextEdit:focus,
QAbstractSpinBox:focus {{ border: 2px solid {accent}; background: {panel}; }}
QLineEdit:focus, QComboBox:focus,
QAbstractSpinBox:focus {{ padding-left: 6px; min-height: 24px; max-height: 24px; }}
QAbstractSpinBox QLineEdit, QAbstractSpinBox QLineEdit:focus {{ border: 0;
  background: transparent; padding: 0; margin: 0; min-height: 24px; max-height: 24px; }}
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button {{ width: 0; border: 0; }}
QComboBox:focus {{ padding-left: 8px; padding-right: 21px; }}
QPlainTextEdit:focus {{ padding: 1px 3px; }}
QLineEdit[role="refused"] {{ border-color: {error}; }}
QLineEdit:read-only {{ color: {text2}; }}
QComboBox::drop-down {{ width: 0; border: 0; }}
QComboBox::down-arrow {{ image: none; width: 0; height: 0; }}
QComboBox QLineEdit, QComboBox QLineEdit:focus {{ border: 0; background: transparent;
  padding: 0; margin: 0; min-height: 24px; max-height: 24px; }}
QComboBox QAbstractItemView, QAbstractItemView[role="completions"] {{ background: {panel};
  border: 1px solid {line_strong}; padding: 4px; outline: 0;
  selection-background-color: {accent_soft}; selection-color: {text}; }}
QComboBox QAbstractItemView::item, QAbstractItemView[role="completions"]::item {{
  min-height: 24px; padding: 0 4px; border-radius: 4px; }}
QComboBox QAbstractItemView::item:selected, QAbstractItemView[role="completions"]::item:selected {{
  background: {accent_soft}; color: {text}; }}
QCheckBox {{ spacing: 8px; min-height: 24px; background: transparent; }}
QCheckBox::indicator {{ width: 14px; height: 14px; border: 1px solid {line_strong};
  border-radius: 4px; background: {field}; }}
QCheckBox::indicator:checked {{ background: {accent}; border-color: {accent}; }}
QCheckBox:focus {{ outline: 0; }}
QCheckBox::indicator:hover {{ border-color: {pipe}; }}
QCheckBox::indicator:focus {{ border: 2px solid {accent}; width: 12px; height: 12px; }}

QSlider {{ min-height: 22px; }}
QSlider::groove {{ height: 4px; border-radius: 2px; background: {pipe}; }}
QSlider::sub-page {{ border-radius: 2px; background: {accent}; }}
QSlider::handle {{ width: 16px; margin: -6px 0; border-radius: 7px; background: {accent}; }}
QSlider::handle:hover {{ background: {accent_over}; }}

QTreeView, QListView, QTableView {{ background: {panel}; border: 0; outline: 0;
  alternate-background-color: {row_alt}; selection-background-color: {accent_soft};
  selection-color: {text}; }}
QTreeView::item {{ height: 24px; border: 0; }}
QTableView::item {{ padding: 0 5px; border: 0; }}
QTreeView::item:hover, QListView::item:hover {{ background: {hover}; }}
QTreeView::item:selected, QListView::item:selected {{ background: {accent_soft}; color: {text}; }}
QTreeView QLineEdit, QTableView QLineEdit, QListView QLineEdit {{ border-radius: 0;
  min-height: 20px; max-height: 22px; padding: 0 4px; }}
QHeaderView {{ background: {panel}; }}
QHeaderView::section {{ background: {panel}; color: {text2}; border: 0;
  border-bottom: 1px solid {line}; padding: 0 3px; height: 31px; font-size: 12px;
  font-weight: 600; }}
QHeaderView::section:first {{ padding-left: 12px; }}
QTableView QHeaderView::section, QTableView QHeaderView::section:first {{ padding: 0 8px; }}
QScrollArea > #qt_scrollarea_viewport {{ background: {panel}; }}
QScrollArea[role="page"] {{ border-top: 1px solid {line}; }}
QScrollArea[role="page"] > #qt_scrollarea_viewport {{ background: {window}; }}
QScrollBar {{ background: transparent; border: 0; }}
QScrollBar:vertical {{ width: 10px; }}
QScrollBar:horizontal {{ height: 10px; }}
QScrollBar::handle {{ background: {line_strong}; border-radius: 3px; margin: 2px; }}
QScrollBar::handle:vertical {{ min-height: 32px; }}
QScrollBar::handle:horizontal {{ min-width: 32px; }}
QScrollBar::handle:hover {{ background: {pipe}; }}
QScrollBar::add-line, QScrollBar::sub-line {{ width: 0; height: 0; }}
QScrollBar::add-page, QScrollBar::sub-page {{ background: transparent; }}

QTabBar {{ background: {window}; qproperty-drawBase: 0; }}
QTabBar[role="documents"]::tab {{ height: 35px; padding: 0 12px; background: {window};
  color: {text2}; border: 0; border-right: 1px solid {line}; border-top: 2px solid transparent;
  border-bottom: 1px solid {line}; }}
QTabBar[role="documents"]::tab:selected {{ background: {panel}; color: {text};
  border-top-color: {accent}; border-bottom-color: {panel}; }}
QTabBar[role="documents"][aside="true"]::tab:selected {{ border-top-color: {line_strong}; }}
QTabBar[role="documents"]::tab:hover:!selected {{ background: {hover}; }}
QSplitter::handle {{ background: {line}; }}
QSplitter::handle:hover {{ background: {accent}; }}
QSplitter::handle:horizontal {{ width: 1px; margin: 0 2px; }}
QTabBar[role="documents"]::scroller, QTabBar[role="documents"]::tear {{ width: 0; }}
QFrame[role="tabs"] {{ background: {window}; border: 0; border-bottom: 1px solid {line}; }}

QFrame[role="segments"] {{ border: 1px solid {line_strong}; border-radius: 6px;
  background: {panel}; }}
QFrame[role="segments"] QPushButton {{ border: 0; border-radius: 5px; padding: 0 9px;
  min-height: 24px; max-height: 24px; font-size: 12px; font-weight: 400; color: {text2};
  background: transparent; }}
QFrame[role="segments"] QPushButton:hover {{ background: {hover}; }}
QFrame[role="segments"] QPushButton:checked {{ background: {accent_soft}; color: {accent};
  font-weight: 500; }}
QFrame[role="segments"] QPushButton:focus {{ border: 1px solid {accent}; padding: 0 8px;
  min-height: 22px; max-height: 22px; }}

QFrame[role="panel"], QWidget[role="panel"] {{ background: {panel}; }}
QFrame[role="page"], QWidget[role="page"] {{ background: {window}; }}
QFrame[role="canvas"], QWidget[role="canvas"] {{ background: {canvas}; }}
QFrame[role="rule"] {{ background: {line}; border: 0; max-height: 1px; min-height: 1px; }}
QFrame[role="box"] {{ border: 1px solid {line}; border-radius: 6px; background: {panel}; }}
QFrame[role="row"] {{ border: 0; border-radius: 5px; background: transparent; }}
QFrame[role="row"]:hover {{ background: {hover}; }}
QFrame[role="row"]:focus {{ background: {accent_soft}; }}
QFrame[role="card"] {{ border: 1px solid {line}; border-radius: 8px; background: {panel}; }}
QFrame[role="card"]:hover {{ border-color: {line_strong}; }}
QFrame[role="card"]:focus {{ border: 2px solid {accent}; }}
QFrame[role="first"] {{ border: 1px solid {accent}; border-radius: 8px; background: {accent}; }}
QFrame[role="first"]:focus {{ border: 2px solid {text}; }}
QFrame[role="first"] QLabel {{ color: {on_accent}; }}
QFrame[role="first"] QLabel[role="kbd"] {{ background: transparent; border-color: {on_accent}; }}
QFrame[role="empty"] {{ border: 1px dashed {line_strong}; border-radius: 8px;
  background: transparent; }}
QFrame[role="notice"] {{ background: {warning_soft}; border: 0;
  border-bottom: 1px solid {line}; }}
QFrame[role="popup"] {{ background: {panel}; border: 1px solid {line_strong};
  border-radius: 8px; }}
QFrame[role="situation"] {{ background: {situation_soft}; border: 1px solid {situation};
  border-radius: 6px; }}
QFrame[role="situation"]:focus {{ border: 2px solid {accent}; }}

QFrame[role="bottomtabs"] {{ background: {panel}; border: 0; }}
QFrame[role="bottomtabs"] QPushButton {{ border: 0; border-radius: 0; background: transparent;
  border-bottom: 2px solid transparent; border-top: 2px solid transparent; padding: 0 10px;
  min-height: 28px; max-height: 28px; font-size: 12px; font-weight: 400; color: {text2}; }}
QFrame[role="bottomtabs"] QPushButton:hover {{ color: {text}; }}
QFrame[role="bottomtabs"] QPushButton:checked {{ color: {text}; font-weight: 600;
  border-bottom-color: {accent}; }}
QFrame[role="bottomtabs"] QPushButton:focus {{ border: 2px solid {accent}; padding: 0 8px; }}

QStatusBar {{ background: {panel}; border-top: 1px solid {line}; min-height: 23px;
  max-height: 23px; }}
QStatusBar::item {{ border: 0; }}
QStatusBar QLabel, QStatusBar QPushButton {{ font-size: 12px; color: {text2}; }}
QStatusBar QPushButton {{ border: 0; background: transparent; padding: 0 4px; min-height: 20px;
  max-height: 20px; font-weight: 400; }}
QStatusBar QPushButton:hover {{ color: {text}; }}
QStatusBar QLabel[live="true"] {{ color: {live}; font-weight: 600; }}
QStatusBar QLabel[live="lost"] {{ color: {error}; font-weight: 600; }}
"""

_PILL = """QLabel[pill="{kind}"] {{ background: {soft}; color: {color}; }}"""


_LENGTH = re.compile(r"\b([3-9]|\d{2,})px")
"""A length that grows with the letters; lines do not."""


def qss(theme: Theme) -> str:
    """The style sheet for ``theme`` and letters as they are now; set it on a window."""
    tokens = msgspec.structs.asdict(theme)
    pairs = [k.removesuffix("_soft") for k in tokens if k.endswith("_soft")]
    pills = "\n".join(
        _PILL.format(kind=kind, soft=tokens[f"{kind}_soft"], color=tokens[kind]) for kind in pairs
    )
    return _LENGTH.sub(lambda found: f"{px(int(found[1]))}px", _SHEET.format(**tokens, pills=pills))


def palette(theme: Theme) -> QPalette:
    """What is not styled by the sheet: the ground of views, selections, placeholders."""
    made = QPalette()
    role = QPalette.ColorRole
    for one, token in (
        (role.Window, "panel"),
        (role.Base, "panel"),
        (role.AlternateBase, "row_alt"),
        (role.Button, "panel"),
        (role.Text, "text"),
        (role.WindowText, "text"),
        (role.ButtonText, "text"),
        (role.PlaceholderText, "text3"),
        (role.Highlight, "accent"),
        (role.HighlightedText, "on_accent"),
        (role.ToolTipBase, "text"),
        (role.ToolTipText, "panel"),
        (role.Mid, "line"),
        (role.Link, "accent"),
    ):
        made.setColor(one, theme.color(token))
    disabled = QPalette.ColorGroup.Disabled
    for one in (role.Text, role.WindowText, role.ButtonText):
        made.setColor(disabled, one, theme.color("text3"))
    return made
