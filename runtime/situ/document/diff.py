"""What changed between two documents or projects, by meaning and in plain words.

States, situations and all else are recognised by number, name or content, so that
what was renamed, renumbered or put elsewhere is told as that. What ``compare`` finds
follows the table of elements: a new attribute is compared without a line here.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from situ.document import rbd, spds, words
from situ.document.aside import EDITOR, Aside
from situ.document.change import Change, Kind
from situ.document.codec import Document
from situ.document.condition import Condition, Group, Test
from situ.document.diff_match import passes, renamed
from situ.document.diff_words import (
    ORDER_COUNTS,
    PLACES,
    SILENT_FIELDS,
    attribute,
    member,
    subject,
)
from situ.document.elements import ROOTS
from situ.document.grammar import Attribute, Element, Slot
from situ.document.modules import Module
from situ.document.pairing import Paired, pair
from situ.document.project import Project
from situ.document.writer import XMLNS

__all__ = ["Change", "compare"]

Place = tuple[str, ...]


def compare(before: Document | Project, after: Document | Project, file: str = "") -> list[Change]:
    """Every difference between two documents of one kind, or two projects; never raises.

    Empty exactly where nothing differs but the places in the files. ``file``: what the
    changes of a document call it.
    """
    if isinstance(before, Project) and isinstance(after, Project):
        from situ.document.diff_project import compare_projects

        return compare_projects(before, after)
    assert not isinstance(before, Project)
    assert not isinstance(after, Project)
    if type(before) is not type(after):
        said = f"{words_of(before)} → {words_of(after)}"
        return [Change(file=file, place=(), text=said)]
    element = next(one for one in ROOTS if one.key is type(before))
    found = _Comparison(file, before, after)
    found.value(before, after, element, (), ())
    return found.changes


def words_of(document: Document) -> str:
    """What kind of document it is."""
    kinds = {rbd.Application: "an application", spds.Spds: "a script"}
    return kinds.get(type(document), "module information")


class _Comparison:
    """One comparison of two documents of one kind."""

    def __init__(self, file: str, before: Document, after: Document) -> None:
        self.changes: list[Change] = []
        self._file = file
        self._before, self._after = before, after
        self._renamed = renamed(before, after)

    def _add(
        self,
        place: Place,
        where: Place,
        what: str,
        behaviour: bool = True,
        kind: Kind = "changed",
    ) -> None:
        text = " ".join((f"{', '.join(where)}: {what}" if where else what).splitlines())
        self.changes.append(
            Change(file=self._file, place=place, text=text, behaviour=behaviour, kind=kind)
        )

    # -- values --------------------------------------------------------------

    def value(self, before: Any, after: Any, element: Element, place: Place, where: Place) -> None:
        """The same thing before and after: what of it changed, and what in it."""
        if before is after:
            return
        self._aside(before.aside, after.aside, place, where)
        self._fields(before, after, element, place, where)

    def _fields(
        self, before: Any, after: Any, element: Element, place: Place, where: Place
    ) -> None:
        own = list(element.attributes)
        if element.text is not None:
            own.append(Attribute("", element.text[1], element.text[0]))
        for one in own:
            self._attribute(before, after, element, one, place, where)
        for slot in element.slots:
            if not slot.field:
                self._fields(before, after, slot.elements[0], place, where)
            elif slot.many:
                self._many(before, after, slot, place, where)
            else:
                self._one(before, after, slot, place, where)

    def _attribute(
        self,
        before: Any,
        after: Any,
        element: Element,
        one: Attribute,
        place: Place,
        where: Place,
    ) -> None:
        old, new = getattr(before, one.field), getattr(after, one.field)
        if isinstance(before, rbd.Application) and one.field == "start":
            self._start(before, after)
            return
        if one.field in ("next", "extends"):
            if self._renamed.get(old, old) == new:
                return
            old, new = self._target(self._before, old), self._target(self._after, new)
            label = "extends" if one.field == "extends" else "leads to"
            if isinstance(before, rbd.Timeout):
                label = "timeout leads to"
            same = old == new
            said = f"{label} {old} → {new}" if not same else f"{label} another {new}"
            self._add(place, where, said)
        elif old != new:
            behaviour = (type(before), one.field) not in SILENT_FIELDS
            self._add(place, where, attribute(before, after, element.name, one), behaviour)

    def _target(self, document: Document, target: str | None) -> str:
        if isinstance(document, rbd.Application):
            return words.leads(document, target)
        return target if target is not None else "none"

    def _start(self, before: rbd.Application, after: rbd.Application) -> None:
        old, new = before.start_no, after.start_no
        if self._renamed.get(old, old) != new:
            first, then = self._target(before, old), self._target(after, new)
            self._add((), (), f"starts in {first} → {then}")
        elif before.start != after.start and self._renamed.get(before.start) != after.start:
            self._add((), (), "the same start, written out or left to the first state", False)

    def _one(self, before: Any, after: Any, slot: Slot, place: Place, where: Place) -> None:
        old, new = getattr(before, slot.field), getattr(after, slot.field)
        inner = (*place, slot.field)
        if old is None and new is None:
            return
        if old is None:
            self._add(inner, where, f"{self._single(slot, new, self._after)} added", kind="new")
        elif new is None:
            self._add(inner, where, f"{self._single(slot, old, self._before)} gone", kind="gone")
        elif isinstance(old, Condition):
            self._condition(old, new, slot, inner, where)
        else:
            named = (*where, "always") if slot.field == "always" else where
            self.value(old, new, slot.elements[0], inner, named)

    def _single(self, slot: Slot, value: Any, document: Document) -> str:
        if isinstance(value, Condition):
            return f"{attribute_of(slot)} {words.condition(value)}"
        if isinstance(value, rbd.Timeout):
            to = f", leads to {self._target(document, value.next)}" if value.next else ""
            return f"timeout {words.seconds(value.seconds)}{to}"
        if isinstance(value, rbd.Screen) and value == rbd.Screen():
            return "empty screen"
        return slot.field

    # -- lists ---------------------------------------------------------------

    def _many(self, before: Any, after: Any, slot: Slot, place: Place, where: Place) -> None:
        old, new = getattr(before, slot.field), getattr(after, slot.field)
        if old is new:
            return
        paired = pair(old, new, passes(slot.field, old, new))
        for index in paired.gone:
            self._come_or_gone("gone", before, old, index, slot, place, where)
        for index in paired.new:
            self._come_or_gone("new", after, new, index, slot, place, where)
        for first, then in paired.both:
            inner = _place(slot, new, then, place)
            named = (*where, subject(old[first], old))
            self.value(old[first], new[then], slot.element(new[then]), inner, named)
        self._order(old, new, paired, slot, place, where)

    def _come_or_gone(
        self,
        kind: Kind,
        parent: Any,
        among: Sequence[Any],
        index: int,
        slot: Slot,
        place: Place,
        where: Place,
    ) -> None:
        document = self._after if kind == "new" else self._before
        said = "added" if kind == "new" else "gone"
        value = among[index]
        inner = _place(slot, among, index, place)
        if isinstance(value, spds.Situation) and kind == "new" and index + 1 < len(among):
            said += f", goes before {among[index + 1].name}"
        if isinstance(value, rbd.State) and value.flow is not None:
            said += f", {'runs' if kind == 'new' else 'ran'} the part {value.flow}"
        if isinstance(value, rbd.State | spds.Situation | Module):
            # These are what everything else is told of.
            self._add(inner, (subject(value, among),), said, kind=kind)
        else:
            self._add(inner, where, f"{member(value, document)} {said}", kind=kind)

    def _order(
        self,
        old: Sequence[Any],
        new: Sequence[Any],
        paired: Paired[Any],
        slot: Slot,
        place: Place,
        where: Place,
    ) -> None:
        for first, then in paired.moved:
            value = new[then]
            after = f"after {subject(new[then - 1], new)}" if then else "first"
            behaviour = ORDER_COUNTS.get(slot.field, False)
            if slot.field == "events":
                behaviour = any(
                    (first < b) != (then < a) and _compete(value, new[a]) for b, a in paired.both
                )
            inner = _place(slot, new, then, place)
            self._add(inner, where, f"{subject(value, new)} now comes {after}", behaviour, "order")

    # -- conditions ----------------------------------------------------------

    def _condition(
        self, old: Condition, new: Condition, slot: Slot, place: Place, where: Place
    ) -> None:
        """Test by test where they are the same tests, else the whole of it."""
        self._aside(old.aside, new.aside, place, where)
        if old == new or _alike(old.children, new.children):
            self._tests(old.children, new.children, place, (*where, attribute_of(slot)))
            return
        first, then = words.condition(old), words.condition(new)
        if first == then:
            first, then = repr_of(old), repr_of(new)
        self._add(place, where, f"{attribute_of(slot)} {first} → {then}")

    def _tests(
        self,
        old: tuple[Test | Group, ...],
        new: tuple[Test | Group, ...],
        place: Place,
        where: Place,
    ) -> None:
        for index, (first, then) in enumerate(zip(old, new, strict=True)):
            inner = (*place, str(index))
            self._aside(first.aside, then.aside, inner, where)
            if isinstance(first, Group) and isinstance(then, Group):
                self._tests(first.children, then.children, inner, where)
            else:
                assert isinstance(first, Test)
                assert isinstance(then, Test)
                self._test(first, then, inner, where)

    def _test(self, old: Test, new: Test, place: Place, where: Place) -> None:
        if old == new:
            return
        if old.tag == new.tag and words.predicate(old) != words.predicate(new):
            said = f"{new.tag} {words.predicate(old)} → {words.predicate(new)}"
        elif words.child(old) != words.child(new):
            said = f"{words.child(old)} → {words.child(new)}"
        else:
            said = f"{repr_of(old)} → {repr_of(new)}"
        self._add(place, where, said)

    # -- what only the editor shows ------------------------------------------

    def _aside(self, old: Aside, new: Aside, place: Place, where: Place) -> None:
        if old is new:
            return
        named = where or ("the file",)
        first, then = (
            {k: v for k, v in one.attributes if not k.startswith(f"{{{XMLNS}}}")}
            for one in (old, new)
        )
        other = sorted(k for k in first.keys() | then.keys() if first.get(k) != then.get(k))
        spots = {f"{{{EDITOR}}}x", f"{{{EDITOR}}}y"}
        if spots & set(other):
            self._add(place, named, "moved in the drawing", False, "moved")
        if rest := [key for key in other if key not in spots]:
            said = ", ".join(key.rpartition("}")[2] for key in rest)
            self._add(place, named, f"looks or foreign data changed ({said})", False, "drawing")
        if (old.before, old.inside, old.after) != (new.before, new.inside, new.after):
            self._add(place, named, "comments or notes changed", False, "drawing")
        parts = [name for name, _ in (*old.parts, *new.parts)]
        for name in dict.fromkeys(parts):
            self._aside(old.part(name), new.part(name), place, where)


def attribute_of(slot: Slot) -> str:
    """What the condition of a slot is called."""
    return {"when": "guard"}.get(slot.field, slot.field)


def repr_of(value: Test | Condition) -> str:
    """A condition as it stands in the file, for differences that no words show."""
    if isinstance(value, Test):
        return f'{value.tag} {value.test}="{value.value}"'
    return " ".join(
        repr_of(one) if isinstance(one, Test) else f"{one.kind}({repr_of(Condition(one.children))})"
        for one in value.children
    )


def _alike(old: Sequence[Test | Group], new: Sequence[Test | Group]) -> bool:
    """Whether the same tests stand at the same places, their details aside."""
    if len(old) != len(new):
        return False
    for first, then in zip(old, new, strict=True):
        if isinstance(first, Group) or isinstance(then, Group):
            if not (isinstance(first, Group) and isinstance(then, Group)):
                return False
            if first.kind != then.kind or not _alike(first.children, then.children):
                return False
        elif first.tag != then.tag and (len(old) > 1 or first.test != then.test):
            return False
    return True


def _compete(one: rbd.Event, other: rbd.Event) -> bool:
    """Whether it matters which of two events comes first."""
    return one.name == other.name or (bool(one.says) and bool(other.says))


def _place(slot: Slot, among: Sequence[Any], index: int, place: Place) -> Place:
    word, name = PLACES[slot.field]
    last = str(index) if name is None else str(getattr(among[index], name))
    return (*place, word, last) if word else (*place, last)
