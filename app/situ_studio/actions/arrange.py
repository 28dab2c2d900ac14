"""Where things lie, and which states are a part of their own: the Arrange menu."""

from __future__ import annotations

from situ_studio.actions.command import Command, row

ARRANGE: tuple[Command, ...] = (
    *(
        row(
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
    row(
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
    row(
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
        row(
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
    row(
        "snap",
        "Put on the grid",
        "on_view",
        icon="grid",
        argument="snap_to_grid",
        menu="Arrange",
        when="on_application",
        tip="The selected cards, or all, to the nearest points of the grid.",
    ),
    *(
        row(
            f"guide.{name}",
            text,
            "add_guide",
            argument=axis,
            icon=icon,
            menu="Arrange/Guides",
            when="has_designer",
            tip=tip,
            contexts="screen",
        )
        for name, axis, icon, text, tip in (
            (
                "upright",
                "x",
                "guide_upright",
                "New upright guide",
                (
                    "A line down the screens of this application, which edges are drawn to; "
                    "arrows move it."
                ),
            ),
            (
                "lying",
                "y",
                "guide_lying",
                "New lying guide",
                (
                    "A line across the screens of this application, which edges are drawn to; "
                    "arrows move it."
                ),
            ),
        )
    ),
    row(
        "guide.clear",
        "Remove all guides",
        "clear_guides",
        icon="trash",
        menu="Arrange/Guides",
        when="has_designer has_guides",
        tip="Of all screens of this application.",
        contexts="screen",
    ),
    row(
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
    row(
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
    row(
        "part.dissolve",
        "Dissolve the part",
        "dissolve_part",
        icon="dissolve",
        menu="Arrange",
        when="can_enter_part",
        tip="The states of the part stand here again; its file stays.",
        contexts="state",
    ),
)
