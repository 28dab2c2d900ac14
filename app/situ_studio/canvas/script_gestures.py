"""What gestures make of a script: pure functions, document in, document and words out."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec.structs import replace

from situ.document.check_script import DEFAULT
from situ.document.condition import Condition
from situ.document.datatypes import write_number
from situ.document.spds import Declaration, Entry, Observed, Situation, Spds
from situ_studio.canvas.script_conditions import test_of, tidy, without_tag
from situ_studio.edits import changes, places
from situ_studio.edits.edit import Place
from situ_studio.wording.language import tr

Done = tuple[Spds, str]

FIRST_PRIORITY = 50
"""What a new entry gets where nothing says more."""


def reorder(script: Spds, name: str, index: int) -> Done:
    """The situation at another place of the precedence; 0 goes before all others."""
    every = list(script.situations)
    old = next((i for i, s in enumerate(every) if s.name == name), -1)
    index = max(0, min(len(every) - 1, index))
    if old < 0 or old == index:
        return script, ""
    every.insert(index, every.pop(old))
    text = tr("Move {0} to place {1}").format(name, index + 1)
    return replace(script, situations=tuple(every)), text


def prioritise(script: Spds, situation: str, module: str, priority: int | None) -> Done:
    """The module's priority in the situation; None takes away what is taken over from another."""
    found = script.situation(situation)
    if found is None:
        return script, ""
    entries = list(found.entries)
    index = next((i for i, e in enumerate(entries) if e.module == module), None)
    if index is None:
        entries.append(Entry(module=module, priority=priority))
    elif entries[index].priority == priority:
        return script, ""
    else:
        entries[index] = replace(entries[index], priority=priority)
    after = places.change(script, ("situation", situation), entries=tuple(entries))
    if priority is None:
        return after, tr("Give {0} no priority in {1}").format(module, situation)
    return after, tr("Give {0} priority {1} in {2}").format(module, priority, situation)


def new_priority(script: Spds, situation: str) -> int:
    """A priority for one more module: above those that are there."""
    found = script.situation(situation)
    own = [e.priority for e in found.entries if e.priority is not None] if found else []
    every = list(script.priorities(found).values()) if found else []
    return max(own or every, default=FIRST_PRIORITY - 10) + 10


def use(script: Spds, module: str, resource: str) -> Done:
    """The module may ask for the resource."""
    declared = next((m for m in script.modules if m.name == module), None)
    if declared is not None and resource in declared.resources:
        return script, ""
    if declared is None:
        every = (*script.modules, Declaration(name=module, resources=(resource,)))
    else:
        every = tuple(
            replace(m, resources=(*m.resources, resource)) if m is declared else m
            for m in script.modules
        )
    return replace(script, modules=every), tr("Let {0} use {1}").format(module, resource)


def disuse(script: Spds, module: str, resource: str) -> Done:
    declared = next((m for m in script.modules if m.name == module), None)
    if declared is None or resource not in declared.resources:
        return script, ""
    kept = tuple(r for r in declared.resources if r != resource)
    every = tuple(replace(m, resources=kept) if m is declared else m for m in script.modules)
    return replace(script, modules=every), tr("Let {0} not use {1}").format(module, resource)


def set_seconds(script: Spds, situation: str, which: str, seconds: float | None) -> Done:
    """How long a situation stays at least (``dwell``), or when it ends (``limit``)."""
    found = script.situation(situation)
    if found is None or getattr(found, which) == seconds:
        return script, ""
    after = places.change(script, ("situation", situation), **{which: seconds})
    if seconds is None:
        said = tr("Let {0} stay as long as it holds")
    elif which == "dwell":
        said = tr("Let {0} stay {1} s at least")
    else:
        said = tr("Let {0} end after {1} s")
    return after, said.format(situation, "" if seconds is None else write_number(seconds))


def extend(script: Spds, situation: str, other: str | None) -> Done:
    """The situation takes over the priorities of another; None: of none any more."""
    found = script.situation(situation)
    if found is None or found.extends == other:
        return script, ""
    after = places.change(script, ("situation", situation), extends=other)
    if other is None:
        return after, tr("Let {0} take over nothing").format(situation)
    return after, tr("Let {0} take over from {1}").format(situation, other)


def change_data(script: Spds, tag: str, **fields: str | None) -> Done:
    """Type or unit of a datum; one that was only used is observed from then on."""
    place = ("data", tag)
    if places.get(script, place) is None:
        script = replace(script, observe=(*script.observe, Observed(tag=tag)))
    after = places.change(script, place, **fields)
    return (after, tr("Change data {0}").format(tag)) if after != script else (script, "")


def free_name(word: str, taken: Iterable[str]) -> str:
    known = set(taken)
    if word not in known:
        return word
    number = 2
    while f"{word}{number}" in known:
        number += 1
    return f"{word}{number}"


def add_situation(
    script: Spds, index: int | None = None, tag: str = "", name: str = ""
) -> tuple[Spds, str, str]:
    """A new situation before the last, which alone may hold always. Returns its name too.

    index: its place among the others. tag: what it looks at; without one the first datum, where
    it has to look at something. The first of all holds always, unless it is to look at ``tag``:
    then one that does follows it.
    """
    taken = {s.name for s in script.situations}
    name = name if name and name not in taken else free_name(name or "situation", taken)
    every = list(script.situations)
    made = Situation(name=name)
    if every or tag:
        tag = tag or (script.observe[0].tag if script.observe else "data")
        made = replace(made, condition=Condition((test_of(script, tag),)))
    if not every and tag:
        every = [Situation(name=free_name(DEFAULT, {name}))]
    last = max(0, len(every) - 1)
    every.insert(last if index is None else max(0, min(last, index)), made)
    after = replace(script, situations=tuple(every))
    return after, tr("Add situation {0}").format(name), name


def add_module(script: Spds, situation: str | None = None, name: str = "") -> tuple[Spds, str, str]:
    """A new module, with a priority in ``situation`` if one is given. Returns its name too."""
    taken = {m.name for m in script.modules} | {
        e.module for s in script.situations for e in s.entries
    }
    name = name if name and name not in taken else free_name(name or "module", taken)
    after = replace(script, modules=(*script.modules, Declaration(name=name)))
    if situation is not None:
        after, _ = prioritise(after, situation, name, new_priority(script, situation))
    return after, tr("Add module {0}").format(name), name


def add_data(script: Spds) -> tuple[Spds, str, str]:
    tag = free_name("data", (o.tag for o in script.observe))
    after = replace(script, observe=(*script.observe, Observed(tag=tag)))
    return after, tr("Add data {0}").format(tag), tag


def cleaned(kind: str, name: str) -> str:
    """A name as it can stand in a file: only situations have blanks in theirs."""
    return (" " if kind == "situation" else "").join(name.split())


def rename(script: Spds, kind: str, old: str, new: str) -> Done:
    """A datum, situation, module or resource, and everything that names it."""
    new = cleaned(kind, new)
    if not new or new == old:
        return script, ""
    match kind:
        case "data":
            after = changes.rename_data(script, old, new)
        case "situation":
            after = changes.rename_situation(script, old, new)
        case "module":
            after = changes.rename_module(script, old, new)
        case "resource":
            after = replace(
                script,
                modules=tuple(
                    replace(
                        m,
                        resources=tuple(dict.fromkeys(new if r == old else r for r in m.resources)),
                    )
                    for m in script.modules
                ),
            )
        case _:
            return script, ""
    if after == script:
        return script, ""
    said = {
        "data": tr("Rename data {0} to {1}"),
        "situation": tr("Rename situation {0} to {1}"),
        "module": tr("Rename module {0} to {1}"),
        "resource": tr("Rename resource {0} to {1}"),
    }
    return after, said[kind].format(old, new)


def delete(script: Spds, gone: Iterable[Place]) -> Done:
    """Situations, modules, data, entries, tests and uses of resources."""
    after = script
    what: list[str] = []
    wanted = list(dict.fromkeys(gone))
    # Members that go by position: from the last to the first.
    parts = [p for p in wanted if len(p) > 2 and p[0] == "situation"]
    parts.sort(key=lambda p: [int(x) if x.isdigit() else -1 for x in p[3:]], reverse=True)
    for place in parts:
        if places.get(after, place) is None:
            continue
        if len(place) == 3:
            after = places.change(after, place[:2], **{place[2]: None})
        else:
            after = tidy(places.put(after, place, None), place)
        told = tr("a priority of {0}") if place[2] == "entry" else tr("a test of {0}")
        what.append(told.format(place[1]))
    for place in wanted:
        match place:
            case ("situation", name) if after.situation(name) is not None:
                after = replace(
                    after,
                    situations=tuple(
                        replace(s, extends=None) if s.extends == name else s
                        for s in after.situations
                        if s.name != name
                    ),
                )
                what.append(tr("situation {0}").format(name))
            case ("module", name, "resource", resource):
                after, text = disuse(after, name, resource)
                what += [tr("{0} of {1}").format(resource, name)] if text else []
            case ("module", name):
                before = after
                after = replace(
                    after,
                    modules=tuple(m for m in after.modules if m.name != name),
                    situations=tuple(
                        replace(s, entries=tuple(e for e in s.entries if e.module != name))
                        if any(e.module == name for e in s.entries)
                        else s
                        for s in after.situations
                    ),
                )
                what += [tr("module {0}").format(name)] if after != before else []
            case ("data", tag):
                before = after
                after = replace(
                    after,
                    observe=tuple(o for o in after.observe if o.tag != tag),
                    situations=tuple(
                        replace(
                            s,
                            condition=without_tag(s.condition, tag),
                            until=without_tag(s.until, tag),
                        )
                        for s in after.situations
                    ),
                )
                what += [tr("data {0}").format(tag)] if after != before else []
            case ("resource", name):
                before = after
                for module in after.modules:
                    after, _ = disuse(after, module.name, name)
                what += [tr("resource {0}").format(name)] if after is not before else []
    if not what:
        return script, ""
    if len(what) > 1:
        return after, tr("Delete {0} things").format(len(what))
    return after, tr("Delete {0}").format(what[0])
