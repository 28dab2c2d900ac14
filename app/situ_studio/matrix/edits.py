"""What typing, filling and pasting make of a script: pure functions. No Qt."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal

from msgspec.structs import replace

from situ.document.spds import Entry, Situation, Spds
from situ_studio.matrix.grid import Grid
from situ_studio.wording.language import tr

Wanted = int | Literal["none"] | None
"""What a cell shall say: a priority, that what is taken over is taken away, or nothing itself."""

Texts = Sequence[Sequence[str]]
"""Rows of cells as they are typed and copied."""

_DIGITS = 18
"""Of a priority; none in use has more, and every program reads so many."""


def read(text: str) -> Wanted:
    """What a text in a cell means; ValueError, with a sentence for the user, where it means nothing
    that can be.

    Empty is nothing of its own, ``none`` and a dash take away; 0 is a priority like any other.
    """
    said = text.strip().replace("\u2212", "-")
    if not said:
        return None
    if said.casefold() in ("none", tr("none").casefold()) or said in ("-", "–", "—"):
        return "none"
    whole, _, part = said.partition(".")
    digits = whole.removeprefix("-").removeprefix("+")
    if digits.isdecimal() and len(digits) <= _DIGITS and not part.strip("0"):
        return int(whole)
    shown = said if len(said) <= 20 else f"{said[:19]}…"
    raise ValueError(tr("A priority is a whole number or none, not {0}.").format(f"“{shown}”"))


def put(script: Spds, wanted: Mapping[tuple[int, str], Wanted]) -> Spds:
    """The script with these cells changed, by row and module; the same where nothing changes.

    A new ``none`` where nothing is taken over leaves no entry: there is nothing to take away.
    """
    rows: dict[int, dict[str, Wanted]] = {}
    for (row, module), value in wanted.items():
        rows.setdefault(row, {})[module] = value
    every = list(script.situations)
    for row, values in rows.items():
        every[row] = _with(every[row], values)
    after = replace(script, situations=tuple(every))
    for row, values in rows.items():
        new = {m for m, value in values.items() if value == "none"}
        new -= {e.module for e in script.situations[row].entries if e.priority is None}
        vain = new - _taken(after, every[row])
        if vain:
            every[row] = _with(every[row], dict.fromkeys(vain))
    if all(one is other for one, other in zip(every, script.situations, strict=True)):
        return script
    return replace(script, situations=tuple(every))


def _with(situation: Situation, values: Mapping[str, Wanted]) -> Situation:
    entries: list[Entry] = []
    left = dict(values)
    for entry in situation.entries:
        if entry.module not in values:
            entries.append(entry)
        elif entry.module in left:
            value = left.pop(entry.module)
            if value is not None:
                priority = None if value == "none" else value
                same = entry.priority == priority
                entries.append(entry if same else replace(entry, priority=priority))
    for module, value in left.items():
        if value is not None:
            entries.append(Entry(module, None if value == "none" else value))
    same = len(entries) == len(situation.entries) and all(
        one is other for one, other in zip(entries, situation.entries, strict=True)
    )
    return situation if same else replace(situation, entries=tuple(entries))


def _taken(script: Spds, situation: Situation) -> set[str]:
    """The modules that a situation has from the one that it extends."""
    above = script.situation(situation.extends) if situation.extends is not None else None
    return set(script.priorities(above)) if above is not None and above is not situation else set()


def reach(texts: Texts, high: int, wide: int) -> tuple[int, int]:
    """How many rows and columns pasting ``texts`` into ``high`` × ``wide`` cells covers: all of
    them where that is a multiple of what is pasted, else as many as are pasted.
    """
    rows, columns = len(texts), max((len(line) for line in texts), default=0)
    if not rows or not columns:
        return 0, 0
    return (rows, columns) if high % rows or wide % columns else (high, wide)


def spread(
    grid: Grid, texts: Texts, top: int, left: int, high: int, wide: int
) -> dict[tuple[int, str], Wanted]:
    """What pasting ``texts`` into a selection of ``high`` × ``wide`` cells makes of which cells.

    It begins at the corner, and reaches as far as ``reach`` says. What is taken over already
    becomes no entry by being pasted. ValueError, with a sentence, where there is no room, or a
    text that is no priority.
    """
    high, wide = reach(texts, high, wide)
    if not high:
        raise ValueError(tr("There is nothing to paste."))
    rows, columns = len(texts), max(len(line) for line in texts)
    if top + high > len(grid.lines) or left + wide > len(grid.modules):
        raise ValueError(
            tr("{0} rows and {1} columns do not fit here: begin further up or to the left.").format(
                high, wide
            )
        )
    found: dict[tuple[int, str], Wanted] = {}
    for down in range(high):
        line = texts[down % rows]
        for across in range(wide):
            at = across % columns
            module = grid.modules[left + across]
            cell = grid.lines[top + down].cell(module)
            text = line[at] if at < len(line) else ""
            try:
                value = read(text)
            except ValueError as wrong:
                name = grid.lines[top + down].situation.name
                raise ValueError(tr("{0} of {1}: {2}").format(module, name, wrong)) from None
            if not cell.own and value is not None and value == cell.taken:
                continue
            found[top + down, module] = value
    return found
