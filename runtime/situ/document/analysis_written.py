"""What is written in a step, followed with conditions as sets of values."""

from __future__ import annotations

from typing import Any

from situ.document import names
from situ.document.rbd import Action, Add, Append, Clear, Message, Set, Take
from situ.document.satisfy import ALL, ALWAYS, LITERAL, Node
from situ.document.satisfy_names import NO, Variables
from situ.document.value_sets import MISSING
from situ.document.values import reach, read

QUICK = (Set, Add, Append, Take, Clear, Message)
"""Actions that end at once."""

Written = dict[int, int | None]
"""By variable: what is left of it by what was written; None: something, nobody knows what."""


def write(variables: Variables, written: Written, action: Action) -> None:
    """One action that ends at once writes what it writes."""
    if isinstance(action, Set):
        known, value = constant(action.text)
        _set(variables, written, action.tag, known, value)
    elif isinstance(action, (Add, Append)):
        _set(variables, written, action.tag, False, None)
    elif isinstance(action, Take):
        _set(variables, written, action.tag, False, None)
        _set(variables, written, action.source, False, None)
    elif isinstance(action, Clear) and not names.is_reserved(action.tag):
        _cleared(variables, written, action.tag)


def _set(variables: Variables, written: Written, tag: str, known: bool, value: Any) -> None:
    """``tag`` is set, to ``value`` where that is known."""
    for name in variables.var:
        if name == tag:
            # Where a longer tag is gone, a shorter one may still reach there.
            sure = known and not (value is None and "." in name)
            cell = variables.values[name].cell(value) if sure else None
            _now_has(variables, written, name, cell, is_set=known and value is not None)
        elif name.startswith(f"{tag}."):
            path = name[len(tag) + 1 :]
            step = f"{tag}.{path.partition('.')[0]}"
            sure = known and not names.is_tag(step)
            inner = reach(value, path) if sure and isinstance(value, (list, dict)) else None
            cell = variables.values[name].cell(inner) if sure else None
            _now_has(variables, written, name, cell, is_set=False)


def _cleared(variables: Variables, written: Written, pattern: str) -> None:
    for name in variables.var:
        parts = name.split(".")
        tags = [".".join(parts[:count]) for count in range(1, len(parts) + 1)]
        held = [tag for tag in tags if names.is_tag(tag)]
        gone = [names.matches(pattern, tag) for tag in held]
        if any(gone):
            _now_has(variables, written, name, MISSING if all(gone) else None, is_set=False)


def _now_has(
    variables: Variables, written: Written, name: str, cell: int | None, is_set: bool
) -> None:
    """A name has another value; its tests that lasted may not any more."""
    written[variables.var[name]] = cell
    for var in variables.beside(name):
        lasting = variables.lasting.get(var)
        if lasting is not None and lasting.base == variables.var[name]:
            if cell is None:
                written[var] = None
            elif not cell & lasting.mask:
                written[var] = NO
        elif variables.is_age(name, var):
            written[var] = 1 if is_set else None
        else:
            written[var] = None


def now(written: Written, node: Node) -> tuple[Node | None, bool]:
    """What a condition asks of the values at first, before anything was written, and whether
    that is known; None where it does not hold now.
    """
    if not written:
        return node, True
    if node.kind == LITERAL:
        if node.var not in written:
            return node, True
        left = written[node.var]
        if left is None:
            return ALWAYS, False
        return (ALWAYS if left & node.mask else None), True
    found = [now(written, child) for child in node.children]
    known = all(sure for _, sure in found)
    left_over = [one for one, _ in found if one is not None]
    if node.kind == ALL:
        return (None if len(left_over) < len(found) else Node(node.kind, tuple(left_over))), known
    return (Node(node.kind, tuple(left_over)) if left_over else None), known


def entered_state(variables: Variables, written: Written, application: str, no: str) -> None:
    """The runtime tells of the state that an application has entered."""
    own = f"application/{application}"
    for name, var in variables.var.items():
        if name == f"{own}.state":
            written[var] = variables.values[name].cell(no)
        elif name == own or name.startswith(f"{own}."):
            written[var] = None


def constant(text: str) -> tuple[bool, Any]:
    """Whether a text (of ``set``) always gives one value, and that value."""
    if names.references(text) or "{{" in text or "}}" in text:
        return False, None
    return True, read(text.strip())
