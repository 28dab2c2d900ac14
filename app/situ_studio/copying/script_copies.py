"""Copies of situations, data and modules, within a script and from one to another. No Qt."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from msgspec.structs import replace

from situ.document.check_script import DEFAULT
from situ.document.condition import Condition, Group, Test
from situ.document.spds import Declaration, Entry, Situation, Spds
from situ_studio.canvas import script_gestures as gestures
from situ_studio.edits.edit import Place
from situ_studio.wording.language import tr

Pasted = tuple[Spds, str, tuple[Place, ...]]
"""The script, the edit's name, and the places of the copies."""

KINDS = ("situation", "data", "module")
"""What can be copied by itself; a priority or a test goes with its situation."""


def can_be_copied(chosen: Iterable[Place]) -> bool:
    """Whether there is something among some places of a script that can be copied."""
    return any(len(place) == 2 and place[0] in KINDS for place in chosen)


def fragment(
    script: Spds, chosen: Iterable[Place], elsewhere: Mapping[str, Iterable[str]] | None = None
) -> Spds:
    """What stands at some places as a script of its own, with what its situations refer to.

    elsewhere: resources by module, of those that the project declares outside of scripts; they are
    declared here, so that the copy can go into another project.
    """
    wanted = set(chosen)
    situations = tuple(s for s in script.situations if ("situation", s.name) in wanted)
    tags = {tag for s in situations for tag in _tags(s)}
    observe = tuple(
        o
        for o in script.observe
        if ("data", o.tag) in wanted or any(_looks_into(tag, o.tag) for tag in tags)
    )
    named = {e.module for s in situations for e in s.entries}
    named |= {m for s in situations for m in script.priorities(s)}
    modules = [m for m in script.modules if ("module", m.name) in wanted or m.name in named]
    there = {m.name for m in modules}
    modules += [
        Declaration(name, tuple(resources))
        for name, resources in (elsewhere or {}).items()
        if name in named and name not in there
    ]
    return Spds(script.name, observe, tuple(modules), situations)


def by_itself(script: Spds, copied: Spds) -> Spds:
    """A fragment of ``script`` that takes over from none but what is in it: where a situation took
    over from another, it has those priorities itself."""
    here = {s.name for s in copied.situations}

    def alone(situation: Situation) -> Situation:
        if situation.extends is None or situation.extends in here:
            return situation
        own = {e.module for e in situation.entries}
        base = script.situation(situation.extends)
        over = script.priorities(base) if base is not None else {}
        taken = tuple(Entry(m, p) for m, p in over.items() if m not in own)
        kept = tuple(e for e in situation.entries if e.priority is not None)
        return replace(situation, extends=None, entries=(*kept, *taken))

    return replace(copied, situations=tuple(alone(s) for s in copied.situations))


def is_empty(copied: Spds) -> bool:
    """Whether there is nothing in it to be pasted."""
    return not (copied.situations or copied.observe or copied.modules)


def named(copied: Spds) -> str:
    """``situation called``, ``3 situations``, ``data heat``; ``4 things`` of several kinds."""
    every = _places(copied)
    kinds = {place[0] for place in every}
    if len(every) == 1:
        said = {
            "situation": tr("situation {0}"),
            "data": tr("data {0}"),
            "module": tr("module {0}"),
        }
        return said[every[0][0]].format(every[0][1])
    if kinds == {"situation"}:
        return tr("{0} situations").format(len(every))
    if kinds == {"module"}:
        return tr("{0} modules").format(len(every))
    return tr("{0} things").format(len(every))


def paste(
    script: Spds,
    copied: Spds,
    index: int | None = None,
    elsewhere: Iterable[str] = (),
    text: str = "",
) -> Pasted:
    """What was copied, its situations at ``index`` of the precedence, or before the last.

    A situation whose name is taken gets another. Situations take along the data and modules that
    they refer to, where the script does not have them by that name; without situations data and
    modules are copies, with names of their own. A situation that took over from another goes on
    doing so where that is, or a copy of it. elsewhere: modules that the project declares outside.
    """
    if is_empty(copied):
        return script, "", ()
    text = (text or tr("Paste {0}")).format(named(copied))
    if not copied.situations:
        after, made = _doubled(script, copied)
        return after, text, made
    here = {s.name for s in script.situations}
    names = _free_names(here, (s.name for s in copied.situations))

    def base(name: str | None) -> str | None:
        if name is None:
            return None
        return names.get(name) or (name if name in here else None)

    new = [replace(s, name=names[s.name], extends=base(s.extends)) for s in copied.situations]
    every = list(script.situations)
    if not every and new[-1].condition is not None:
        # The last of all always holds.
        every = [Situation(gestures.free_name(DEFAULT, names.values()))]
    last = max(0, len(every) - 1)
    at = last if index is None else max(0, min(last, index))
    every[at:at] = new
    tags = {o.tag for o in script.observe}
    known = {m.name for m in script.modules} | set(elsewhere)
    after = replace(
        script,
        observe=(*script.observe, *(o for o in copied.observe if o.tag not in tags)),
        modules=(*script.modules, *(m for m in copied.modules if m.name not in known)),
        situations=tuple(every),
    )
    return after, text, tuple(("situation", s.name) for s in new)


def duplicate(script: Spds, chosen: Iterable[Place]) -> Pasted:
    """Copies of what stands at some places, situations right after the last of them."""
    copied = fragment(script, chosen)
    names = {s.name for s in copied.situations}
    index = max((i for i, s in enumerate(script.situations, 1) if s.name in names), default=None)
    return paste(script, copied, index, text=tr("Duplicate {0}"))


def _doubled(script: Spds, copied: Spds) -> tuple[Spds, tuple[Place, ...]]:
    """Data and modules once more, by other names where theirs are taken."""
    used = {m.name for m in script.modules}
    used |= {e.module for s in script.situations for e in s.entries}
    tags = _free_names({o.tag for o in script.observe}, (o.tag for o in copied.observe))
    names = _free_names(used, (m.name for m in copied.modules))
    after = replace(
        script,
        observe=(*script.observe, *(replace(o, tag=tags[o.tag]) for o in copied.observe)),
        modules=(*script.modules, *(replace(m, name=names[m.name]) for m in copied.modules)),
    )
    return after, (
        *(("data", tag) for tag in tags.values()),
        *(("module", name) for name in names.values()),
    )


def _free_names(taken: set[str], wanted: Iterable[str]) -> dict[str, str]:
    """What each is called where some names are taken: ``called2`` is followed by ``called3``."""
    taken, found = set(taken), {}
    for name in wanted:
        stem = name.rstrip("0123456789") or name
        found[name] = name if name not in taken else gestures.free_name(stem, {stem, *taken})
        taken.add(found[name])
    return found


def _places(copied: Spds) -> list[Place]:
    """What was copied for its own sake."""
    if copied.situations:
        return [("situation", s.name) for s in copied.situations]
    return [
        *(("data", o.tag) for o in copied.observe),
        *(("module", m.name) for m in copied.modules),
    ]


def _tags(situation: Situation) -> Iterator[str]:
    for condition in (situation.condition, situation.until):
        if condition is not None:
            yield from _tested(condition)


def _tested(holder: Condition | Group) -> Iterator[str]:
    for child in holder.children:
        if isinstance(child, Test):
            yield child.tag
        else:
            yield from _tested(child)


def _looks_into(tag: str, observed: str) -> bool:
    return tag == observed or tag.startswith(f"{observed}.")
