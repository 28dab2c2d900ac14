"""Gathers the studio's texts for its translators, and makes what the studio reads of theirs.

    python packaging/texts.py        renews resources/i18n: runtime.txt, studio_*.ts and studio_*.qm

Three kinds of texts: ``self.tr("…")`` of QObjects and ``tr("…")`` of
``situ_studio.wording.language``, which lupdate finds itself, the tables of commands and kinds, and
the templates of the runtime.
Needs the studio's environment. Texts that are gone are taken out of the .ts files.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import msgspec
import runtime_texts

from situ_studio import actions, kinds
from situ_studio.canvas.gestures import FOLLOWS
from situ_studio.commands import shortcuts
from situ_studio.help import help_texts
from situ_studio.kinds import said
from situ_studio.panels import test_box
from situ_studio.panels.pairs import PAIRS
from situ_studio.screens import keyboard
from situ_studio.wording.language import LANGUAGES
from situ_studio.wording.runtime_words import GLUE

ROOT = Path(__file__).resolve().parent.parent
STUDIO = ROOT / "app" / "situ_studio"
I18N = ROOT / "resources" / "i18n"
SHOWN = {"title", "label", "help", "hint", "unit", "placeholder", "text", "tip"}
"""The fields of kinds and commands that people read."""


def gathered() -> Iterator[tuple[str, str]]:
    """(context, text) of everything that lupdate does not find by itself."""
    for template in runtime_texts.templates():
        yield "runtime", template
    for glue in (*GLUE, " or "):
        yield "runtime", glue
    for kind in kinds.KINDS:
        for text in _shown(kind):
            yield "kinds", text
    for table in (said.TESTS, said.GROUPS, said.TYPES, test_box.CHOICES):
        for _, text in table:
            yield "kinds", text
    for choice in FOLLOWS:
        yield "kinds", choice.label
        yield "kinds", choice.words
    for pairs in PAIRS.values():
        yield "kinds", pairs.noun
        for column in pairs.columns:
            yield "kinds", column.words
    for command in actions.COMMANDS:
        for text in (*_shown(command), *command.menu.split("/")):
            yield "actions", text
    for keys in (shortcuts.CANVAS, shortcuts.TREE, keyboard.KEYS):
        for pair in keys:
            for text in pair:
                yield "actions", text
    for page in help_texts.PAGES:
        for text in (page.title, *page.paragraphs):
            yield "help", text
    for text in help_texts.COMMANDS.values():
        yield "help", text
    for panel in help_texts.PANELS.values():
        yield "help", panel.title
        yield "help", panel.text


def _shown(value: msgspec.Struct) -> Iterator[str]:
    for name in value.__struct_fields__:
        found = getattr(value, name)
        if name in SHOWN and isinstance(found, str):
            yield found
        elif name == "choices":
            yield from (text for _, text in found)
        elif isinstance(found, tuple):
            for one in found:
                if isinstance(one, msgspec.Struct):
                    yield from _shown(one)


def renew(folder: Path) -> None:
    """Makes all files of ``folder`` as the sources want them, keeping what is translated there."""
    found = sorted({(context, text) for context, text in gathered() if text.strip()})
    (folder / "runtime.txt").write_text(
        "".join(f"{template}\n" for template in runtime_texts.templates()), encoding="utf-8"
    )
    with tempfile.TemporaryDirectory() as scratch:
        listed = Path(scratch) / "tables.py"
        listed.write_text(
            "".join(
                f'QCoreApplication.translate("{context}", {_quoted(text)})\n'
                for context, text in found
            ),
            encoding="utf-8",
        )
        sources = [*sorted(map(str, STUDIO.rglob("*.py"))), str(listed)]
        for code in LANGUAGES.keys() - {"en"}:
            texts = folder / f"studio_{code}.ts"
            _run("lupdate", *sources, "-no-obsolete", "-locations", "none", "-source-language",
                 "en", "-target-language", code, "-ts", str(texts))  # fmt: skip
            _run("lrelease", "-silent", str(texts), "-qm", str(texts.with_suffix(".qm")))


def _run(tool: str, *arguments: str) -> None:
    program = Path(sys.executable).parent / f"pyside6-{tool}"
    subprocess.run([program, *arguments], check=True, stdout=subprocess.DEVNULL)


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


if __name__ == "__main__":
    renew(I18N)
