"""What a screen reader hears of a script: its nodes, and in them their pipes. No Qt.

Each pipe is heard in the node from which it leads, those of tests in their condition.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from situ.document.spds import Situation, Spds
from situ_studio.canvas.script_faces import LINE, STRIP, ScriptLink, ScriptNode, ScriptPicture
from situ_studio.canvas.script_projection import inherited, keyed
from situ_studio.canvas.spoken import Spoken
from situ_studio.edits import words
from situ_studio.wording.language import tr


def node(script: Spds, picture: ScriptPicture, face: ScriptNode) -> Spoken:
    """A node with its pipes, a condition with its lines."""
    return Spoken(
        face.uid,
        "node",
        face.called(),
        "; ".join((face.spoken(), *_joined(script, picture, face))),
        face.place,
        None,
        partial(_inside, script, picture, face),
    )


def _joined(script: Spds, picture: ScriptPicture, face: ScriptNode) -> Iterator[str]:
    """What pipes join it with, in few words: whoever hears it sees none."""
    links = picture.links.values()
    if face.kind == "situation":
        situation = _situation(script, face)
        if situation is not None and situation.condition is not None:
            yield tr("while {0}").format(words.condition_words(situation.condition))
        for link in links:
            if link.source == face.uid and link.priority is not None:
                yield _asks(link.priority, picture.cards[link.target].name)
    elif face.kind == "data":
        to = {picture.cards[one.target].name: None for one in links if one.source == face.uid}
        if to:
            yield tr("looked at in {0}").format(", ".join(to))
    elif face.kind in ("module", "resource"):
        told = tr("in {0}") if face.kind == "module" else tr("used by {0}")
        of = {picture.cards[one.source].name: None for one in links if one.target == face.uid}
        if of:
            yield told.format(", ".join(of))


def _asks(priority: int, module: str) -> str:
    return tr("priority {0} for {1}").format(priority, module)


def _inside(script: Spds, picture: ScriptPicture, face: ScriptNode) -> tuple[Spoken, ...]:
    if face.kind == "condition":
        return tuple(_lines(face))
    links = [link for link in picture.links.values() if link.source == face.uid and link.place]
    pipes = [_pipe(picture, link) for link in links if link.kind != "observes"]
    if face.kind == "situation":
        pipes += _taken_over(script, face)
    return tuple(pipes)


def _lines(face: ScriptNode) -> Iterator[Spoken]:
    for index, row in enumerate(face.rows):
        area = STRIP, face.line_at(index) - LINE / 2, face.width - STRIP, LINE
        what = tr("group of tests") if row.group else tr("test")
        name = f"{row.tag} {row.text}".strip()
        told = tr("{0} of {1}").format(what, face.name)
        yield Spoken(row.path, "transition", name, told, (*face.place, *row.tail), area)


def _pipe(picture: ScriptPicture, link: ScriptLink) -> Spoken:
    source, target = picture.cards[link.source], picture.cards[link.target]
    wrong = {"": "", "warning": tr("with a warning"), "error": tr("with an error")}[link.mark]
    if link.kind == "uses":
        name = tr("uses {0}").format(target.name)
        told = tr("resource of {0}").format(source.name)
    elif link.priority is None:
        name = tr("no priority for {0}").format(target.name)
        told = tr("taken away in {0}").format(source.name)
    else:
        name = _asks(link.priority, target.name)
        told = tr("priority in {0}").format(source.name)
    described = "; ".join(part for part in (told, wrong, *link.wrong.told()) if part)
    return Spoken(" ".join(link.place), "transition", name, described, link.place)


def _taken_over(script: Spds, face: ScriptNode) -> list[Spoken]:
    situation = _situation(script, face)
    if situation is None:
        return []
    told = tr("taken over from {0}").format(situation.extends)
    return [
        Spoken(f"over {one.module}", "transition", _asks(one.priority, one.module), told)
        for one in inherited(script, situation, _key(face))
    ]


def _situation(script: Spds, face: ScriptNode) -> Situation | None:
    return next((s for s, name in keyed(script) if name == _key(face)), None)


def _key(face: ScriptNode) -> str:
    return face.uid.removeprefix("situation ")
