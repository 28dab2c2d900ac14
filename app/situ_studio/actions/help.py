"""The studio explained: the Help menu."""

from __future__ import annotations

from situ_studio.actions.command import Command, row

HELP: tuple[Command, ...] = (
    row("help", "Help", "show_help", icon="help", shortcut="F1", menu="Help"),
    row(
        "tutorial",
        "Tutorial",
        "show_tutorial",
        icon="play",
        menu="Help",
        tip="A first robot in a quarter of an hour, from nothing, one step at a time.",
    ),
    row(
        "whats_this",
        "What is this?",
        "ask_what_this_is",
        icon="pointed",
        shortcut="Shift+F1",
        menu="Help",
        tip="What you click next is explained, and nothing else is done with it.",
    ),
    row(
        "shortcuts",
        "Keyboard shortcuts",
        "show_shortcuts",
        icon="keyboard",
        shortcut="Ctrl+F1",
        menu="Help",
    ),
    row(
        "show_log",
        "Show the log",
        "show_log",
        icon="list",
        menu="Help",
        rule=True,
        tip="What the studio noted lately, for a report: names of files, no texts of yours.",
    ),
    row("about", "About Situ Studio", "about", icon="info", menu="Help"),
)
