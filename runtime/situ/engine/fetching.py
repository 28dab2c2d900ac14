"""Services apart need the media of the version that their core runs: they ask it for them."""

from __future__ import annotations

import os
import shutil
from functools import partial
from pathlib import Path
from typing import Any

from situ.blackboard import protocol
from situ.blackboard.asynchronous import AsyncBoard
from situ.document.folder import PROJECT_FILE, load
from situ.document.project import Project
from situ.engine.staging import Staging
from situ.errors import ProjectError


async def fetch(board: AsyncBoard, folder: Path, own: Project) -> tuple[int, Project]:
    """The version that the robot runs, and its project in a folder inside of ``folder``; version 0
    is what the robot was given, which is ``own`` here. What was fetched before need not come again.

    Raises SituError where the core does not give it or it can not be kept; then what was there
    before is there still.
    """
    told: Any = await board.give(lambda number: protocol.Bundle(id=number))
    if told.version == 0:
        return 0, own
    home = folder / str(told.version)
    if not home.is_dir():
        coming = Staging(folder / "coming", told.files, {})
        for path in coming.wanted:
            await _file(board, told.version, path, coming)
        coming.check_whole()
        coming.complete()
        os.rename(coming.folder, home)
    project, _ = load(home if told.main == PROJECT_FILE else home / told.main)
    if project is None:
        raise ProjectError(f"version {told.version} can not be read")
    for one in folder.iterdir():
        # A core that was set up anew counts anew.
        if one != home:
            shutil.rmtree(one, ignore_errors=True)
    return told.version, project


async def _file(board: AsyncBoard, version: int, path: str, coming: Staging) -> None:
    size, offset = coming.files[path].size, 0
    while offset < size:
        reply: Any = await board.give(partial(_request, version, path, offset))
        if not reply.data:
            raise ProjectError(f"{path}: it ends before its end")
        coming.piece(path, offset, reply.data)
        offset += len(reply.data)


def _request(version: int, path: str, offset: int, number: int) -> protocol.Fetch:
    return protocol.Fetch(id=number, version=version, path=path, offset=offset)
