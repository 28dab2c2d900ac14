"""What pipes of a script mean: pure functions, document in, document and words out."""

from __future__ import annotations

from situ.document.spds import Spds
from situ_studio.canvas import script_conditions as conditions
from situ_studio.canvas import script_gestures as gestures
from situ_studio.canvas.gestures import Follow
from situ_studio.canvas.script_faces import ScriptNode
from situ_studio.canvas.script_projection import modules
from situ_studio.edits import places
from situ_studio.edits.edit import Place
from situ_studio.wording.language import tr

Done = tuple[Spds, str, Place]

TAKES = {
    "data": ("condition", "situation"),
    "situation": ("module", "situation"),
    "module": ("resource",),
}
"""Which kinds a pipe from a kind may go to."""


def accepts(source: ScriptNode, target: ScriptNode) -> bool:
    return target is not source and target.kind in TAKES.get(source.kind, ())


def refusal(source: ScriptNode, target: ScriptNode) -> str:
    """Why a pipe from one node to another means nothing."""
    if source.uid == target.uid:
        return tr("A pipe leads to another card")
    match source.kind:
        case "data":
            told = tr("Data leads to a condition or a situation, and {0} is neither")
        case "situation":
            told = tr("A situation leads to a module, or to a situation that it takes over from")
        case "module":
            told = tr("A module leads to the resources that it uses, and {0} is none")
        case _:
            told = tr("A condition belongs to its situation: drag from data to {0} instead")
    return told.format(target.called())


def landing(target: ScriptNode, entry: str) -> Place:
    """Where what is dropped on an input of a node goes in the document."""
    row = next((row for row in target.rows if row.path == entry), None)
    return (*target.place, *row.tail) if row is not None else target.place


def connect(script: Spds, source: ScriptNode, target: ScriptNode, entry: str, old: Place) -> Done:
    """A pipe from one node to an input of another. old: what it was until now; () for a new one.

    Returns too what is selected then.
    """
    match source.kind, target.kind:
        case "data", _:
            place = landing(target, entry)
            if old:
                return *conditions.move_test(script, old, place), ()
            after, text = conditions.observe(script, source.name, place)
            return after, text, conditions.latest(after, place) if text else ()
        case "situation", "situation":
            after, text = gestures.extend(script, source.name, target.name)
            return after, text, source.place
        case "situation", _:
            return _prioritise(script, source.name, target.name, old)
        case _:
            if old:
                script, _ = gestures.delete(script, [old])
            return *gestures.use(script, source.name, target.name), ()


def _prioritise(script: Spds, situation: str, module: str, old: Place) -> Done:
    found = script.situation(situation)
    if found is None or any(e.module == module for e in found.entries):
        return script, "", ()
    if old:
        # The same number, for another module.
        after = places.change(script, old, module=module)
        priority = places.get(script, old).priority
        _, text = gestures.prioritise(script, situation, module, priority)
        return after, text, old
    number = gestures.new_priority(script, situation)
    after, text = gestures.prioritise(script, situation, module, number)
    return after, text, ("situation", situation, "entry", str(len(found.entries)))


def choices(script: Spds, source: ScriptNode) -> list[Follow]:
    """What a node can lead to, as ``follow`` takes it."""
    match source.kind:
        case "data":
            return [
                Follow("+situation", tr("New situation"), "plus", "add"),
                *_conditions(script, "condition", tr("{0} holds when")),
                *_conditions(script, "until", tr("{0} holds until")),
            ]
        case "situation":
            own = {e.module for s in script.situations if s.name == source.name for e in s.entries}
            free = [m for m in modules(script) if m not in own]
            return [
                Follow("+module", tr("New module"), "plus", "add"),
                *(Follow(f"module {m}", m, "module", tr("priority")) for m in free),
                *extensions(script, source.name),
            ]
        case "module":
            used = next((m.resources for m in script.modules if m.name == source.name), ())
            return [
                Follow(f"resource {r}", r, "resource") for r in resources(script) if r not in used
            ]
    return []


def _conditions(script: Spds, word: str, told: str) -> list[Follow]:
    # The last one always holds.
    every = script.situations[:-1]
    return [Follow(f"{word} {s.name}", told.format(s.name), "condition") for s in every]


def extensions(script: Spds, situation: str) -> list[Follow]:
    """From which other situations one can take over."""
    found = script.situation(situation)
    now = found.extends if found is not None else None
    said = tr("Take over from {0}")
    every = [
        Follow(f"extends {s.name}", said.format(s.name), "situation", "extends")
        for s in script.situations
        if s.name not in (situation, now) and not _leads(script, s.name, situation)
    ]
    if now is not None:
        every.append(Follow("extends", tr("Take over nothing"), "close", "extends none"))
    return every


def _leads(script: Spds, start: str, end: str) -> bool:
    """Whether one situation takes over from another, through several too."""
    seen: set[str] = set()
    at: str | None = start
    while at is not None and at not in seen:
        if at == end:
            return True
        seen.add(at)
        found = script.situation(at)
        at = found.extends if found is not None else None
    return False


def resources(script: Spds) -> list[str]:
    """Every resource that a module uses, and the two that every robot has."""
    used = (r for m in script.modules for r in m.resources)
    return list(dict.fromkeys((*used, "screen", "speech")))


def follow(script: Spds, source: ScriptNode, key: str, index: int | None = None) -> Done:
    """What was chosen from ``choices``. index: which place among the situations a new one gets."""
    word, _, name = key.partition(" ")
    match word:
        case "+situation":
            return _new_situation(script, source.name, index, name)
        case "+module":
            after, text, name = gestures.add_module(script, source.name, name)
            entry = len(next(s for s in after.situations if s.name == source.name).entries) - 1
            return after, text, ("situation", source.name, "entry", str(entry))
        case "condition" | "until":
            place = ("situation", name, word)
            after, text = conditions.observe(script, source.name, place)
            return after, text, conditions.latest(after, place)
        case "module":
            return _prioritise(script, source.name, name, ())
        case "extends":
            return *gestures.extend(script, source.name, name or None), source.place
        case "resource":
            return *gestures.use(script, source.name, "".join(name.split())), source.place
    return script, "", ()


def _new_situation(script: Spds, tag: str, index: int | None, name: str) -> Done:
    after, text, name = gestures.add_situation(script, index, tag, name)
    return after, text, ("situation", name)


NEW = {"data": "+situation", "situation": "+module", "module": "resource"}
"""What is new where a name was typed that nothing has."""


def new_words(kind: str) -> str:
    """How something new is offered by the name that was typed."""
    return {
        "data": tr("New situation “{0}”"),
        "situation": tr("New module “{0}”"),
        "module": tr("New resource “{0}”"),
    }.get(kind, "")
