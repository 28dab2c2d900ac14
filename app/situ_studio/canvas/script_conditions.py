"""What gestures make of a script's conditions: pure functions, document in, document and words out.

A condition's place is ``("situation", name, "condition")`` or the same with ``until``; its tests
and groups go by their positions in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from msgspec.structs import replace

from situ.document.condition import Condition, Group, GroupName, Test
from situ.document.spds import Spds
from situ_studio.canvas.script_rows import whole_group
from situ_studio.edits import places
from situ_studio.edits.edit import Place
from situ_studio.wording.language import tr

Done = tuple[Spds, str]


def test_of(script: Spds, tag: str) -> Test:
    """A first test of a tag, by the type of its data."""
    known = next((o for o in script.observe if o.tag == tag), None)
    kind = known.type if known is not None else None
    if kind == "boolean":
        return Test(tag=tag, test="is", value="true")
    if kind == "number":
        return Test(tag=tag, test="above", value="0")
    return Test(tag=tag, test="exists", value="true")


def landing(script: Spds, place: Place) -> Place:
    """Where a test goes that is dropped at ``place``: a situation or a condition (its own group,
    where it has one), a group, or a test (beside it)."""
    if len(place) == 2:
        place = (*place, "condition")
    value = places.get(script, place)
    if isinstance(value, Test):
        return place[:-1]
    if isinstance(value, Condition) and whole_group(value) is not None:
        return (*place, "0")
    return place


def observe(script: Spds, tag: str, place: Place) -> Done:
    """One more test of the tag where ``place`` leads (``landing``)."""
    text = tr("Let {0} look at {1}").format(place[1], tag)
    return _put_in(script, landing(script, place), test_of(script, tag), text)


def _put_in(script: Spds, into: Place, value: Test | Group, text: str) -> Done:
    holder = places.get(script, into)
    if holder is None:
        if len(into) != 3 or script.situation(into[1]) is None:
            return script, ""
        made = Condition((value,))
        return places.change(script, into[:2], **{into[2]: made}), text
    children = (*holder.children, value)
    return places.change(script, into, children=children), text


def latest(script: Spds, place: Place) -> Place:
    """The place of the last test where ``place`` leads: the one that ``observe`` put there."""
    into = landing(script, place)
    holder = places.get(script, into)
    return (*into, str(len(holder.children) - 1)) if holder is not None else into


def move_test(script: Spds, test: Place, place: Place) -> Done:
    """The test, as it is, where ``place`` leads instead of where it is."""
    value, into = places.get(script, test), landing(script, place)
    if not isinstance(value, Test) or into == test[:-1]:
        return script, ""
    # Put in at the end first: nothing that stands before it moves.
    text = tr("Let {0} look at {1}").format(place[1], value.tag)
    after, text = _put_in(script, into, value, text)
    if not text:
        return script, ""
    return tidy(places.put(after, test, None), test), text


def change_test(script: Spds, place: Place, value: Test) -> Done:
    if places.get(script, place) == value:
        return script, ""
    return places.put(script, place, value), tr("Change a test of {0}").format(place[1])


def regroup(script: Spds, place: Place, kind: GroupName) -> Done:
    """A condition or a group of it asks for all, any or none of what is in it."""
    value = places.get(script, place)
    text = tr("Let {0} ask for {1}").format(place[1], _word(kind))
    if isinstance(value, Condition):
        whole = whole_group(value)
        if whole is not None:
            return regroup(script, (*place, "0"), kind)
        if kind == "all" or not value.children:
            return script, ""
        grouped: tuple[Test | Group, ...] = (Group(kind, value.children),)
        return places.change(script, place, children=grouped), text
    if not isinstance(value, Group) or value.kind == kind:
        return script, ""
    if kind == "all" and len(place) == 4:
        outer = places.get(script, place[:3])
        if isinstance(outer, Condition) and whole_group(outer) is value:
            # All of them is what a condition asks for anyhow.
            return places.change(script, place[:3], children=value.children), text
    return places.change(script, place, kind=kind), text


def wrap(script: Spds, chosen: Sequence[Place], kind: GroupName) -> Done:
    """These tests and groups, which stand in one group, become a group of their own in it.

    A group that asks for all of what is in it can be made of one test too.
    """
    outer = {place[:-1] for place in chosen}
    if len(outer) != 1:
        return script, ""
    into = next(iter(outer))
    holder = places.get(script, into)
    if not isinstance(holder, Condition | Group):
        return script, ""
    indices = sorted(int(place[-1]) for place in chosen)
    inside = tuple(holder.children[i] for i in indices)
    rest: list[Test | Group] = [c for i, c in enumerate(holder.children) if i not in indices]
    rest.insert(indices[0], Group(kind, inside))
    text = tr("Group tests of {0}: {1}").format(into[1], _word(kind))
    return places.change(script, into, children=tuple(rest)), text


def unwrap(script: Spds, place: Place) -> Done:
    """What is in a group stands where the group stood."""
    group = places.get(script, place)
    if not isinstance(group, Group):
        return script, ""
    holder: Any = places.get(script, place[:-1])
    at = int(place[-1])
    children = (*holder.children[:at], *group.children, *holder.children[at + 1 :])
    text = tr("Take a group of {0} away").format(place[1])
    return places.change(script, place[:-1], children=children), text


def tidy(script: Spds, place: Place) -> Spds:
    """Without the empty groups or the condition that taking the last test at ``place`` leaves."""
    for end in range(len(place) - 1, 2, -1):
        holder = places.get(script, place[:end])
        if isinstance(holder, Group | Condition) and not holder.children:
            script = places.put(script, place[:end], None)
        else:
            break
    return script


def without_tag(condition: Condition | None, tag: str) -> Condition | None:
    """A condition without the tests of a tag and of what is in it; None where none is left."""

    def keep(children: Sequence[Test | Group]) -> tuple[Test | Group, ...]:
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


def _word(kind: GroupName) -> str:
    return {"all": tr("all"), "any": tr("any"), "none": tr("none")}[kind]
