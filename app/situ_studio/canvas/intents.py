"""What a hand did to the pipes of an application's graph, as edits of its document."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from situ.document.rbd import Application
from situ_studio.canvas import gestures
from situ_studio.canvas.picture import Picture, place_of
from situ_studio.wording.language import tr


def connected(
    document: Application, picture: Picture, connections: Sequence[Any]
) -> tuple[Application, str]:
    """The pipe that was drawn last. connections: as ``Graph.take_intents`` has them."""
    _, pairs = connections[-1]
    for leaving, entry in pairs:
        source = picture.cards.get(leaving.node.uid)
        target = picture.cards.get(entry.node.uid)
        if source is not None and target is not None:
            return gestures.lead(document, source.place, leaving.name, target.no)
    return document, ""


def sliced(
    document: Application, picture: Picture, slices: Sequence[Any]
) -> tuple[Application, str]:
    """All pipes that were cut through. slices: as ``Graph.take_intents`` has them."""
    texts = []
    places = []
    for cut in slices:
        for _, leaving in cut:
            card = picture.cards.get(leaving.node.uid) if leaving.node is not None else None
            if card is not None:
                places.append(place_of(leaving.node.uid, leaving.name, card))
    # Unnamed events go when they are cut: the last ones first, so that positions still fit.
    for place in sorted(set(places), key=lambda p: (p[:-1], _number(p[-1])), reverse=True):
        document, text = gestures.disconnect(document, place)
        texts += [text] if text else []
    if len(texts) > 1:
        return document, tr("Cut {0} pipes").format(len(texts))
    return document, texts[0] if texts else ""


def _number(text: str) -> int:
    return int(text) if text.isdigit() else -1
