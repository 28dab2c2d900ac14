"""The service unit says what systemd and ``situ run`` understand."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from situ import cli

UNIT = Path(__file__).parent.parent / "packaging" / "situ@.service"


def test_the_unit_runs_a_command_that_there_is() -> None:
    command = re.search(r"^ExecStart=\S+/situ (.*)$", UNIT.read_text("utf-8"), re.MULTILINE)
    assert command is not None
    arguments = cli.parser().parse_args(command[1].replace("%i", "nurse").split())
    assert arguments.project == "/etc/situ/nurse"
    assert not arguments.no_restart


@pytest.mark.skipif(shutil.which("systemd-analyze") is None, reason="needs systemd")
def test_systemd_finds_no_fault_with_the_unit(tmp_path: Path) -> None:
    unit = tmp_path / "situ@nurse.service"
    unit.write_text(UNIT.read_text("utf-8").replace("/opt/situ/bin/situ", sys.executable))
    done = subprocess.run(
        ["systemd-analyze", "verify", "--man=no", str(unit)], capture_output=True, text=True
    )
    assert (done.returncode, done.stderr) == (0, "")
