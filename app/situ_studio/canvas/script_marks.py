"""What is wrong in a script, by the node or the priority at which its sign stands. Pure."""

from __future__ import annotations

from collections.abc import Iterable

from situ.document.problem import Problem
from situ.document.spds import Entry, Spds
from situ_studio.canvas.problem_marks import NONE, Mark
from situ_studio.edits import places
from situ_studio.edits.edit import Place


def marks_of(problems: Iterable[Problem], script: Spds) -> dict[Place, Mark]:
    """Marks by place: of nodes, and of entries for their pills, of a tie both."""
    marks: dict[Place, Mark] = {}
    for problem in sorted(problems, key=lambda one: one.severity):
        place = problem.place
        if place[:1] == ("situation",) and len(place) > 3 and place[2] == "entry":
            root = place[:4]
        elif place[:1] == ("situation",) and len(place) > 2 and place[2] in ("condition", "until"):
            root = place[:3]
        else:
            root = place[:2]
        roots = [root] if root else []
        if problem.code == "tie":
            roots += _tied_with(script, place)
        for one in roots:
            before = marks.get(one, NONE)
            if problem.message not in before.messages:
                messages = (*before.messages, problem.message)
                marks[one] = Mark(before.sign or problem.severity, messages)
    return marks


def _tied_with(script: Spds, place: Place) -> list[Place]:
    """The other entries of a tie: those of the same priority in the situation, which can use
    something that the first can use."""
    situation = script.situation(place[1])
    mine = places.get(script, place[:4]) if len(place) > 3 else None
    if situation is None or not isinstance(mine, Entry):
        return []
    uses = {m.name: set(m.resources) for m in script.modules}
    nothing: set[str] = set()
    return [
        ("situation", place[1], "entry", str(number))
        for number, entry in enumerate(situation.entries)
        if entry.module != mine.module
        and entry.priority == mine.priority
        # What a module declares elsewhere is not known here.
        and (
            not {mine.module, entry.module} <= uses.keys()
            or uses.get(mine.module, nothing) & uses.get(entry.module, nothing)
        )
    ]
