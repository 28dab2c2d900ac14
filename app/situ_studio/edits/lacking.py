"""What states that come from elsewhere need and a project does not have."""

from __future__ import annotations

from collections.abc import Iterable

from situ.document.project import Project
from situ.document.rbd import Application
from situ_studio.edits import mentions
from situ_studio.edits.edit import Place


def lacking(
    project: Project, media: Iterable[str], document: Application, pasted: Iterable[Place]
) -> list[str]:
    """The files of parts and media that some places of a document mention and that are not here.

    media: the files that the project has, as ``vocabulary`` lists them.
    """
    roots = tuple(pasted)
    known = {("part", file) for file in project.flows} | {("media", file) for file in media}
    found: dict[str, None] = {}
    for mention in mentions.mentions(document):
        if any(mention.place[: len(root)] == root for root in roots):
            for role, name in mention.names:
                if role in ("part", "media") and (role, name) not in known:
                    found[name] = None
    return list(found)
