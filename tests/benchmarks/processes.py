"""The processes that the live benches start: a core, and peers beside it."""

from __future__ import annotations

import contextlib
import json
import select
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import IO

from tests.benchmarks.peers import PATIENCE

PROJECT = '[project]\nname = "bench"\napplications = ["idle.rbd.xml"]\n'
IDLE = '<application name="idle"><state no="1"/></application>'


OPTIONS = ("--services", "core")
CORE = " ".join(("situ run", *OPTIONS))
"""What is measured; the table says it."""


@contextlib.contextmanager
def started(*command: str) -> Iterator[subprocess.Popen[str]]:
    """Ended with the block, gently, then not."""
    process = subprocess.Popen(
        [sys.executable, *command], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    try:
        yield process
    finally:
        process.terminate()
        try:
            process.communicate(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()


def line_of(process: subprocess.Popen[str]) -> str:
    """The next line that it prints; RuntimeError where it prints none."""
    assert process.stdout is not None
    if not readable(process.stdout, PATIENCE) or not (line := process.stdout.readline()):
        raise RuntimeError(f"{process.args!r} says nothing")
    return line.strip()


def readable(stream: IO[str], seconds: float) -> bool:
    """Whether something comes within so many seconds."""
    return bool(select.select([stream], [], [], seconds)[0])


@contextlib.contextmanager
def peer(role: str, *arguments: str) -> Iterator[list[str]]:
    """The addresses of a peer that is ready."""
    with started("-m", "tests.benchmarks.peers", role, *arguments) as process:
        yield line_of(process).split()[1:]


@contextlib.contextmanager
def core() -> Iterator[tuple[subprocess.Popen[str], str]]:
    """A running core and where to ask it."""
    with tempfile.TemporaryDirectory(prefix="situ-bench-") as folder:
        (Path(folder) / "situ.toml").write_text(PROJECT)
        (Path(folder) / "idle.rbd.xml").write_text(IDLE)
        command = ["-m", "situ", "run", folder, "--no-restart", "--json"]
        command += ["--endpoint", "tcp://127.0.0.1:0"]
        with started(*command, "--state", f"{folder}/state", *OPTIONS) as process:
            yield process, json.loads(line_of(process))["requests"]
