"""What a robot runs, as a project of its own on disk."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from situ.document import folder
from situ.errors import UsageError
from situ_studio.wording.language import tr


def keep(theirs: Mapping[str, str], media: Mapping[str, bytes], target: Path) -> None:
    """Writes the robot's texts into ``target``, a new folder, and the media that are here: a robot
    gives those to nobody. Raises UsageError where it can not.
    """
    files = {**media, **{file: text.encode() for file, text in theirs.items()}}
    for file in files:
        if not folder.stays_inside(file):
            raise UsageError(tr("{0} leads out of the project: nothing is written.").format(file))
    try:
        target.mkdir(parents=True)
        for file, data in files.items():
            (target / file).parent.mkdir(parents=True, exist_ok=True)
            (target / file).write_bytes(data)
    except FileExistsError:
        raise UsageError(
            tr("{0} is there already: choose another folder.").format(target)
        ) from None
    except OSError as error:
        raise UsageError(f"{target}: {error.strerror}") from None
