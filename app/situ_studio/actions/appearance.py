"""How the studio looks, speaks and lies on the screen: the rest of the View menu."""

from __future__ import annotations

from situ_studio.actions.command import Command, row
from situ_studio.looks import letters
from situ_studio.wording.language import LANGUAGES, SYSTEM

APPEARANCE: tuple[Command, ...] = (
    row(
        "theme.system",
        "Like the system",
        "choose_theme",
        icon="screen",
        argument="system",
        menu="View/Colours",
        choice="theme",
        checked="has_theme",
    ),
    row(
        "theme.light",
        "Light",
        "choose_theme",
        icon="sun",
        argument="light",
        menu="View/Colours",
        choice="theme",
        checked="has_theme",
    ),
    row(
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
        row(
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
    *(
        row(
            f"letters.{size}",
            name,
            "choose_letters",
            argument=size,
            menu="View/Letters",
            choice="letters",
            checked="has_letters",
        )
        for size, name in (
            (letters.SYSTEM, "Like the system"),
            *((str(size), f"{size} %") for size in letters.SIZES),
        )
    ),
    row(
        "next_panel",
        "Next panel",
        "next_panel",
        argument=1,
        shortcut="F6",
        menu="View",
        rule=True,
    ),
    row(
        "previous_panel",
        "Panel before",
        "next_panel",
        argument=-1,
        shortcut="Shift+F6",
        menu="View",
    ),
)
