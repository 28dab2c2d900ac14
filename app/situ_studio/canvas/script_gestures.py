"""What gestures make of a script: pure functions, document in, document and words out. No Qt."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec.structs import replace

from situ.document.condition import Condition, Group, Test
from situ.document.spds import Declaration, Entry, Observed, Situation, Spds
from situ_studio import changes, places
from situ_studio.edit import Place

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
    return replace(script, situations=tuple(every)), f"Move {name} to place {index + 1}"


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
    said = "no priority" if priority is None else f"priority {priority}"
    return after, f"Give {module} {said} in {situation}"


def new_priority(script: Spds, situation: str) -> int:
    """A priority for one more module: above those that are there."""
    found = script.situation(situation)
    own = [e.priority for e in found.entries if e.priority is not None] if found else []
    every = list(script.priorities(found).values()) if found else []
    return max(own or every, default=FIRST_PRIORITY - 10) + 10


def _test(script: Spds, tag: str) -> Test:
    known = next((o for o in script.observe if o.tag == tag), None)
    kind = known.type if known is not None else None
    if kind == "boolean":
        return Test(tag=tag, test="is", value="true")
    if kind == "number":
        return Test(tag=tag, test="above", value="0")
    return Test(tag=tag, test="exists", value="true")


def observe(script: Spds, tag: str, situation: str) -> Done:
    """One more test of the tag in the situation's condition."""
    found = script.situation(situation)
    if found is None:
        return script, ""
    children = found.condition.children if found.condition is not None else ()
    aside = found.condition.aside if found.condition is not None else Condition().aside
    condition = Condition(children=(*children, _test(script, tag)), aside=aside)
    after = places.change(script, ("situation", situation), condition=condition)
    return after, f"Let {situation} look at {tag}"


def look_elsewhere(script: Spds, test: Place, tag: str) -> Done:
    """The test looks at another tag."""
    value = places.get(script, test)
    if not isinstance(value, Test) or value.tag == tag:
        return script, ""
    after = places.change(script, test, tag=tag)
    return after, f"Let {test[1]} look at {tag}"


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
    return replace(script, modules=every), f"Let {module} use {resource}"


def disuse(script: Spds, module: str, resource: str) -> Done:
    declared = next((m for m in script.modules if m.name == module), None)
    if declared is None or resource not in declared.resources:
        return script, ""
    kept = tuple(r for r in declared.resources if r != resource)
    every = tuple(replace(m, resources=kept) if m is declared else m for m in script.modules)
    return replace(script, modules=every), f"Let {module} not use {resource}"


def _free(word: str, taken: Iterable[str]) -> str:
    known = set(taken)
    if word not in known:
        return word
    number = 2
    while f"{word}{number}" in known:
        number += 1
    return f"{word}{number}"


def add_situation(script: Spds, index: int | None = None) -> tuple[Spds, str, str]:
    """A new situation before the last, which alone may hold always. Returns its name too."""
    name = _free("situation", (s.name for s in script.situations))
    made = Situation(name=name)
    if script.situations:
        tag = script.observe[0].tag if script.observe else "data"
        made = replace(made, condition=Condition((_test(script, tag),)))
    every = list(script.situations)
    every.insert(max(0, len(every) - 1) if index is None else index, made)
    return replace(script, situations=tuple(every)), f"Add situation {name}", name


def add_module(script: Spds, situation: str | None = None) -> tuple[Spds, str, str]:
    """A new module, with a priority in ``situation`` if one is given."""
    taken = {m.name for m in script.modules} | {
        e.module for s in script.situations for e in s.entries
    }
    name = _free("module", taken)
    after = replace(script, modules=(*script.modules, Declaration(name=name)))
    if situation is not None:
        after, _ = prioritise(after, situation, name, new_priority(script, situation))
    return after, f"Add module {name}", name


def add_data(script: Spds) -> tuple[Spds, str, str]:
    tag = _free("data", (o.tag for o in script.observe))
    return replace(script, observe=(*script.observe, Observed(tag=tag))), f"Add data {tag}", tag


def rename(script: Spds, kind: str, old: str, new: str) -> Done:
    """A datum, situation, module or resource, and everything that names it."""
    new = "".join(new.split()) if kind != "situation" else " ".join(new.split())
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
                    replace(m, resources=tuple(new if r == old else r for r in m.resources))
                    for m in script.modules
                ),
            )
        case _:
            return script, ""
    return (after, f"Rename {kind} {old} to {new}") if after != script else (script, "")


def _without_tag(condition: Condition | None, tag: str) -> Condition | None:
    def keep(children: Iterable[Test | Group]) -> tuple[Test | Group, ...]:
        kept: list[Test | Group] = []
        for child in children:
            if isinstance(child, Test):
                if child.tag != tag and not child.tag.startswith(f"{tag}."):
                    kept.append(child)
                continue
            inner = keep(child.children)
            if inner:
                kept.append(replace(child, children=inner))
        return tuple(kept)

    if condition is None:
        return None
    children = keep(condition.children)
    return replace(condition, children=children) if children else None


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
            after = places.change(after, place[:2], condition=None, until=None)
        else:
            after = _tidy(places.put(after, place, None), place)
        what.append(f"{'a priority' if place[2] == 'entry' else 'a test'} of {place[1]}")
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
                what.append(f"situation {name}")
            case ("module", name, "resource", resource):
                after, text = disuse(after, name, resource)
                what += [f"{resource} of {name}"] if text else []
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
                what += [f"module {name}"] if after != before else []
            case ("data", tag):
                before = after
                after = replace(
                    after,
                    observe=tuple(o for o in after.observe if o.tag != tag),
                    situations=tuple(
                        replace(
                            s,
                            condition=_without_tag(s.condition, tag),
                            until=_without_tag(s.until, tag),
                        )
                        for s in after.situations
                    ),
                )
                what += [f"data {tag}"] if after != before else []
            case ("resource", name):
                before = after
                for module in after.modules:
                    after, _ = disuse(after, module.name, name)
                what += [f"resource {name}"] if after is not before else []
    if not what:
        return script, ""
    return after, f"Delete {what[0]}" if len(what) == 1 else f"Delete {len(what)} things"


def _tidy(script: Spds, place: Place) -> Spds:
    """Without the empty group or condition that taking its last test leaves."""
    for end in range(len(place) - 1, 2, -1):
        holder = places.get(script, place[:end])
        if isinstance(holder, Group | Condition) and not holder.children:
            script = places.put(script, place[:end], None)
        else:
            break
    return script
