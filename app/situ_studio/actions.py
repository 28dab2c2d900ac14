"""Every command of the studio in one table.

Menus, context menus, toolbar, shortcuts, the command palette and the list of shortcuts are made
from it (``menus.Actions``). A command's handler is a method of ``commands.Commands``, its
``when`` a method of the same that says whether it can be done now.
"""

from __future__ import annotations

from typing import Any, Literal

from msgspec import Struct

from situ.document.rbd import Application
from situ.document.spds import Spds
from situ_studio import kinds
from situ_studio.language import LANGUAGES, SYSTEM
from situ_studio.views import VIEWS


class Command(Struct, frozen=True, kw_only=True):
    """One command.

    menu: the menu's title, with the submenu's behind ``/``; "": in no menu.
    toolbar: at the left or right end of the toolbar; outlined buttons show their text.
    when: must hold for the command to be enabled; shown: for it to be there at all.
    choice: commands of one choice are exclusive and checkable, ``checked`` says which one is.
    rule: a line stands before it in its menu.
    argument: given to the handler, if not None.
    contexts: where it is in the context menu, divided by blanks: ``ground``, ``state`` (one),
        ``states`` (several), ``exit`` (a transition), ``always``, ``component`` (one or several),
        ``screen`` (its ground), ``thing`` (anything else).
    also: another shortcut.
    """

    id: str
    text: str
    handler: str
    icon: str = ""
    shortcut: str = ""
    menu: str = ""
    toolbar: Literal["", "left", "right"] = ""
    outlined: bool = False
    when: str = ""
    shown: str = ""
    choice: str = ""
    checked: str = ""
    rule: bool = False
    argument: Any = None
    tip: str = ""
    contexts: str = ""
    also: str = ""


def _c(id: str, text: str, handler: str, **rest: Any) -> Command:
    return Command(id=id, text=text, handler=handler, **rest)


_CONTEXTS = {
    "state": "ground",
    "part": "ground",
    "always": "ground",
    "note": "ground",
    "frame": "ground states",
    "event": "state always",
    "timeout": "state always",
}
"""Where a new thing of a kind is offered in a context menu."""

_INSERT = tuple(
    _c(
        f"insert.{kind.name}",
        kind.title,
        "insert",
        icon=kind.icon,
        menu="Insert",
        when=f"can_insert_{part}",
        shown=f"offers_{part}",
        argument=kind.name,
        rule=index == 0 and part != "application",
        tip=kind.help,
        contexts="screen" if part == "screen" else _CONTEXTS.get(kind.name, ""),
    )
    for part in ("application", "action", "screen", "drawing", "script", "modules")
    for index, kind in enumerate(k for k in kinds.KINDS if k.palette == part)
)

_ONLY: dict[tuple[type[Any], ...], str] = {
    (Application,): "is_application",
    (Spds,): "is_script",
    (Application, Spds): "has_graph",
}
"""The condition of a view that is not of every kind of document."""

_VIEWS = tuple(
    _c(
        f"view.{view.name}",
        view.text,
        "show_view",
        argument=view.name,
        icon=view.icon,
        shortcut=view.key,
        menu="View",
        when=_ONLY.get(view.kinds, "has_document"),
        choice="view",
        checked="shows_view",
        tip=view.tip,
    )
    for view in VIEWS
)

COMMANDS: tuple[Command, ...] = (
    _c("new", "New project…", "new_project", icon="new", shortcut="Ctrl+N", menu="File"),
    _c(
        "new_window",
        "New window",
        "new_window",
        icon="new_window",
        shortcut="Ctrl+Shift+N",
        menu="File",
    ),
    _c("open", "Open a project…", "open_project", icon="folder", shortcut="Ctrl+O", menu="File"),
    _c("welcome", "Welcome page", "show_welcome", icon="home", menu="File"),
    _c(
        "save",
        "Save",
        "save",
        icon="save",
        shortcut="Ctrl+S",
        menu="File",
        toolbar="left",
        when="has_project",
        rule=True,
    ),
    _c(
        "save_copy",
        "Save a copy…",
        "save_copy",
        icon="copy",
        shortcut="Ctrl+Shift+S",
        menu="File",
        when="has_project",
        tip="The project goes into another folder as it is here, and you go on there.",
    ),
    _c(
        "export",
        "Export picture…",
        "export_picture",
        icon="export",
        menu="File",
        when="has_graph",
        rule=True,
        tip="The drawing, or a part of it, as SVG, PDF or PNG.",
    ),
    _c(
        "print",
        "Print…",
        "print_drawing",
        icon="print",
        shortcut="Ctrl+P",
        menu="File",
        when="has_graph",
    ),
    _c(
        "close_tab",
        "Close tab",
        "close_tab",
        icon="close",
        shortcut="Ctrl+W",
        menu="File",
        when="has_document",
        rule=True,
    ),
    _c(
        "reopen_tab",
        "Reopen closed tab",
        "reopen_tab",
        icon="history",
        shortcut="Ctrl+Shift+T",
        menu="File",
        when="can_reopen_tab",
    ),
    _c(
        "close_window",
        "Close window",
        "close_window",
        icon="close_window",
        shortcut="Ctrl+Shift+W",
        menu="File",
    ),
    _c("quit", "Quit", "quit", icon="quit", shortcut="Ctrl+Q", menu="File", rule=True),
    _c(
        "undo",
        "Undo",
        "undo",
        icon="undo",
        shortcut="Ctrl+Z",
        menu="Edit",
        toolbar="left",
        when="can_undo",
        rule=True,
    ),
    _c(
        "redo",
        "Redo",
        "redo",
        icon="redo",
        shortcut="Ctrl+Shift+Z",
        menu="Edit",
        toolbar="left",
        when="can_redo",
    ),
    _c(
        "cut",
        "Cut",
        "cut",
        icon="cut",
        shortcut="Ctrl+X",
        menu="Edit",
        when="can_copy",
        rule=True,
        contexts="state states component",
    ),
    _c(
        "copy",
        "Copy",
        "copy",
        icon="copy",
        shortcut="Ctrl+C",
        menu="Edit",
        when="can_copy",
        contexts="state states component",
    ),
    _c(
        "paste",
        "Paste",
        "paste",
        icon="paste",
        shortcut="Ctrl+V",
        menu="Edit",
        when="can_paste",
        contexts="ground component screen",
    ),
    _c(
        "duplicate",
        "Duplicate",
        "duplicate",
        icon="duplicate",
        shortcut="Ctrl+D",
        menu="Edit",
        when="can_copy",
        contexts="state states component",
    ),
    _c(
        "delete",
        "Delete",
        "delete",
        icon="trash",
        shortcut="Del",
        menu="Edit",
        when="has_selection",
        contexts="state states exit always thing component",
    ),
    _c(
        "rename",
        "Rename",
        "rename",
        icon="rename",
        shortcut="F2",
        menu="Edit",
        when="has_selection",
        contexts="state thing component",
    ),
    _c(
        "rename_everywhere",
        "Rename everywhere…",
        "rename_everywhere",
        shortcut="Shift+F2",
        menu="Edit",
        when="can_rename_everywhere",
        contexts="exit thing",
        tip="An event, tag or module gets another name in every document of the project.",
    ),
    _c(
        "select_all",
        "Everything",
        "on_view",
        icon="select_all",
        argument="select_all",
        shortcut="Ctrl+A",
        menu="Edit/Select",
        when="has_document",
        contexts="ground",
    ),
    _c(
        "select_followers",
        "What follows too",
        "on_view",
        argument="select_followers",
        shortcut="Ctrl+Shift+Right",
        menu="Edit/Select",
        when="has_cards",
        contexts="state states",
        tip="Adds the states to which the selected ones lead.",
    ),
    _c(
        "select_leading",
        "What leads here too",
        "on_view",
        argument="select_leading",
        shortcut="Ctrl+Shift+Left",
        menu="Edit/Select",
        when="has_cards",
        contexts="state states",
        tip="Adds the states that lead to the selected ones.",
    ),
    _c(
        "find",
        "Find anything, run a command…",
        "find",
        icon="search",
        shortcut="Ctrl+K",
        menu="Edit",
        rule=True,
    ),
    _c(
        "find_in_project",
        "Find in the project…",
        "find_in_project",
        icon="find",
        shortcut="Ctrl+F",
        menu="Edit",
        when="has_project",
        contexts="ground",
        tip="States, texts, events and tags in every document.",
    ),
    _c(
        "find_next",
        "Next found",
        "find_next",
        icon="down",
        argument=1,
        shortcut="F3",
        menu="Edit",
        when="has_found",
    ),
    _c(
        "find_previous",
        "Found before",
        "find_next",
        icon="up",
        argument=-1,
        shortcut="Shift+F3",
        menu="Edit",
        when="has_found",
    ),
    _c(
        "find_usages",
        "Find usages…",
        "find_usages",
        icon="usages",
        shortcut="Ctrl+Shift+F",
        menu="Edit",
        when="can_find_usages",
        contexts="state exit thing",
        tip="Every place that mentions the selected event, tag, state, module or file.",
    ),
    _c(
        "find_here",
        "Filter the outline",
        "find_here",
        icon="filter",
        shortcut="Ctrl+Shift+O",
        menu="Edit",
        when="has_document",
    ),
    _c(
        "preferences",
        "Preferences…",
        "show_preferences",
        shortcut="Ctrl+,",
        menu="Edit",
        rule=True,
        tip="Language, colours, and the keys of the commands.",
    ),
    *_VIEWS,
    _c(
        "zoom_in",
        "Zoom in",
        "zoom_by",
        argument=1.25,
        icon="zoom_in",
        shortcut="Ctrl++",
        menu="View",
        when="on_graph",
        rule=True,
    ),
    _c(
        "zoom_out",
        "Zoom out",
        "zoom_by",
        argument=0.8,
        icon="zoom_out",
        shortcut="Ctrl+-",
        menu="View",
        when="on_graph",
    ),
    _c(
        "zoom_100",
        "Actual size",
        "zoom_to_actual_size",
        icon="zoom_actual",
        shortcut="Ctrl+0",
        menu="View",
        when="on_graph",
    ),
    _c(
        "zoom_fit",
        "Show everything",
        "on_view",
        argument="zoom_to_fit",
        icon="fit",
        shortcut="Ctrl+9",
        menu="View",
        when="on_graph",
        contexts="ground",
    ),
    _c(
        "zoom_selection",
        "Show the selection",
        "zoom_to_selection",
        icon="zoom_selection",
        shortcut="Ctrl+8",
        menu="View",
        when="has_selection",
        contexts="states",
    ),
    _c(
        "reset_layout",
        "Reset layout",
        "reset_layout",
        icon="layers",
        menu="View",
        when="has_project",
        rule=True,
        tip="Every panel back to where it lies at first",
    ),
    _c(
        "go_start",
        "The start",
        "go_to_start",
        icon="start",
        shortcut="Ctrl+Home",
        menu="Go",
        when="is_application",
        contexts="ground",
    ),
    _c(
        "go_target",
        "Where it leads",
        "go_to_target",
        icon="target",
        shortcut="Ctrl+J",
        menu="Go",
        when="has_exit",
        contexts="exit",
    ),
    _c(
        "next_exit",
        "Next transition of the state",
        "on_view",
        argument="next_exit",
        shortcut="Alt+Down",
        menu="Go",
        when="can_step_exit",
    ),
    _c(
        "previous_exit",
        "Transition before",
        "on_view",
        argument="previous_exit",
        shortcut="Alt+Up",
        menu="Go",
        when="can_step_exit",
    ),
    _c(
        "next_problem",
        "Next problem",
        "next_problem",
        argument=1,
        shortcut="F8",
        menu="Go",
        when="has_problems",
        rule=True,
    ),
    _c(
        "previous_problem",
        "Problem before",
        "next_problem",
        argument=-1,
        shortcut="Shift+F8",
        menu="Go",
        when="has_problems",
    ),
    _c(
        "next_tab",
        "Next document",
        "next_tab",
        argument=1,
        shortcut="Ctrl+PgDown",
        also="Ctrl+Tab",
        menu="Go",
        when="has_document",
        rule=True,
    ),
    _c(
        "previous_tab",
        "Document before",
        "next_tab",
        argument=-1,
        shortcut="Ctrl+PgUp",
        also="Ctrl+Shift+Tab",
        menu="Go",
        when="has_document",
    ),
    _c(
        "context_menu",
        "What can be done with the selection",
        "context_menu",
        icon="more",
        shortcut="Shift+F10",
        also="Menu",
        menu="Go",
        when="has_document",
        rule=True,
    ),
    _c(
        "part.enter",
        "Into the part",
        "enter_part",
        icon="enter",
        shortcut="Alt+Right",
        menu="Go",
        when="can_enter_part",
        rule=True,
        tip="Shows the application that the selected state runs.",
        contexts="state",
    ),
    _c(
        "part.leave",
        "Back out of the part",
        "leave_part",
        icon="leave",
        shortcut="Alt+Left",
        menu="Go",
        when="can_leave_part",
        contexts="ground",
    ),
    _c(
        "theme.system",
        "Like the system",
        "choose_theme",
        icon="screen",
        argument="system",
        menu="View/Colours",
        choice="theme",
        checked="has_theme",
    ),
    _c(
        "theme.light",
        "Light",
        "choose_theme",
        icon="sun",
        argument="light",
        menu="View/Colours",
        choice="theme",
        checked="has_theme",
    ),
    _c(
        "theme.dark",
        "Dark",
        "choose_theme",
        icon="moon",
        argument="dark",
        menu="View/Colours",
        choice="theme",
        checked="has_theme",
    ),
    *(
        _c(
            f"language.{code}",
            name,
            "choose_language",
            argument=code,
            menu="View/Language",
            choice="language",
            checked="has_language",
        )
        for code, name in ((SYSTEM, "Like the system"), *LANGUAGES.items())
    ),
    _c(
        "next_panel",
        "Next panel",
        "next_panel",
        argument=1,
        shortcut="F6",
        menu="View",
        rule=True,
    ),
    _c(
        "previous_panel",
        "Panel before",
        "next_panel",
        argument=-1,
        shortcut="Shift+F6",
        menu="View",
    ),
    *_INSERT,
    _c(
        "lead_to",
        "Lead to…",
        "ask_where_to",
        icon="lead",
        shortcut="Ctrl+E",
        menu="Insert",
        when="has_card_or_exit",
        rule=True,
        contexts="state exit always",
        tip="A new transition of the selected state, or another target of the selected one.",
    ),
    _c(
        "turn_pipe",
        "Draw the folded pipe, or fold it",
        "on_view",
        icon="fold",
        argument="turn_pipe",
        menu="Arrange",
        when="has_drawn_exit",
        contexts="exit",
        tip="Long pipes are folded into a chip with the number of the state.",
    ),
    _c(
        "connect_states",
        "Connect one after the other",
        "on_view",
        icon="chain",
        argument="connect_selected",
        menu="Insert",
        when="has_two_cards",
        contexts="states",
    ),
    _c(
        "guard",
        "Guard",
        "guard",
        icon="guard",
        menu="Insert",
        when="has_exit",
        contexts="exit",
        tip="When the selected transition may be taken.",
    ),
    _c(
        "mark_start",
        "Start here",
        "mark_start",
        icon="start",
        menu="Insert",
        when="has_one_state",
        contexts="state",
    ),
    *(
        _c(
            f"align.{edge}",
            text,
            "align",
            argument=edge,
            icon=f"align_{edge}",
            menu="Arrange/Align",
            toolbar="left" if edge == "left" else "",
            when="can_align",
            rule=edge in ("left", "top"),
            contexts="states component",
        )
        for edge, text in (
            ("left", "Left edges"),
            ("center", "Middles, one above the other"),
            ("right", "Right edges"),
            ("top", "Upper edges"),
            ("middle", "Middles, side by side"),
            ("bottom", "Lower edges"),
        )
    ),
    _c(
        "distribute.across",
        "Evenly side by side",
        "align",
        argument="across",
        icon="distribute",
        menu="Arrange/Align",
        toolbar="left",
        when="can_space",
        rule=True,
        contexts="states component",
    ),
    _c(
        "distribute.down",
        "Evenly one above the other",
        "align",
        icon="distribute_down",
        argument="down",
        menu="Arrange/Align",
        when="can_space",
        contexts="states component",
    ),
    *(
        _c(
            f"order.{way}",
            text,
            "order",
            argument=way,
            icon=f"to_{way}",
            shortcut=key,
            menu="Arrange/Order",
            when="can_order",
            contexts="component",
        )
        for way, text, key in (
            ("front", "Bring to the front", "Ctrl+Shift+]"),
            ("forward", "Bring forward", "Ctrl+]"),
            ("backward", "Send backward", "Ctrl+["),
            ("back", "Send to the back", "Ctrl+Shift+["),
        )
    ),
    _c(
        "snap",
        "Put on the grid",
        "on_view",
        icon="grid",
        argument="snap_to_grid",
        menu="Arrange",
        when="on_application",
        tip="The selected cards, or all, to the nearest points of the grid.",
    ),
    _c(
        "layout",
        "Arrange by itself",
        "on_view",
        argument="auto_layout",
        icon="layout",
        shortcut="Ctrl+L",
        menu="Arrange",
        toolbar="left",
        when="can_auto_layout",
        rule=True,
        tip="Moves every card to a place where the arrows are easy to follow.",
        contexts="ground",
    ),
    _c(
        "part.make",
        "Make a part…",
        "make_part",
        icon="part",
        shortcut="Ctrl+G",
        menu="Arrange",
        when="can_make_part",
        rule=True,
        tip="The selected states become an application of their own, which one state runs.",
        contexts="state states",
    ),
    _c(
        "part.dissolve",
        "Dissolve the part",
        "dissolve_part",
        icon="dissolve",
        menu="Arrange",
        when="can_enter_part",
        tip="The states of the part stand here again; its file stays.",
        contexts="state",
    ),
    _c(
        "connect",
        "Connect",
        "connect_robot",
        icon="unlink",
        shortcut="Ctrl+R",
        menu="Robot",
        toolbar="right",
        outlined=True,
        shown="can_connect",
        tip="Follow a robot live.",
    ),
    _c(
        "disconnect",
        "Disconnect",
        "disconnect_robot",
        icon="unlink",
        menu="Robot",
        toolbar="right",
        outlined=True,
        shown="is_connected",
    ),
    _c(
        "shortcuts",
        "Keyboard shortcuts",
        "show_shortcuts",
        icon="keyboard",
        shortcut="Shift+F1",
        menu="Help",
    ),
    _c(
        "show_log",
        "Show the log",
        "show_log",
        icon="list",
        menu="Help",
        rule=True,
        tip="What the studio noted lately, for a report: names of files, no texts of yours.",
    ),
    _c("about", "About Situ Studio", "about", icon="info", menu="Help"),
)

MENUS = ("File", "Edit", "View", "Go", "Insert", "Arrange", "Robot", "Help")
"""In this order; Alt and the first letter opens one."""

SUBMENU_ICONS = {
    "Edit/Select": "select_all",
    "View/Colours": "theme",
    "View/Language": "language",
    "Arrange/Align": "align_left",
    "Arrange/Order": "layers",
    "Insert": "plus",
}
"""Of submenus, and of a menu that is one in a context menu."""


def command(id: str) -> Command:
    """The command of that id; KeyError where there is none."""
    for one in COMMANDS:
        if one.id == id:
            return one
    raise KeyError(id)
