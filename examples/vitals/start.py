"""Starts the whole of it until Ctrl-C: the records, the robot, its devices, and a broker.

    python examples/vitals/start.py

Each is a process of its own; where one ends, all end. The broker is Debian's mosquitto, where it
is installed and nobody else answers at the address of ``[mqtt]``. What the robot is told of the
records in confidence, and which programs it may start, is written into its state folder, once.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import tomllib
from pathlib import Path
from urllib.parse import urlsplit

HERE = Path(__file__).resolve().parent
DEVICES = ("cuff", "oximeter", "glucose_meter")


class Programs:
    """What has been started; at the end of its ``with`` all are told to end, and waited for."""

    def __init__(self) -> None:
        self._running: list[subprocess.Popen[str]] = []

    def __enter__(self) -> Programs:
        return self

    def __exit__(self, *_: object) -> None:
        for one in reversed(self._running):
            one.terminate()
        for one in self._running:
            one.wait()

    def start(self, *command: str | Path) -> subprocess.Popen[str]:
        """Its standard output is this program's to read."""
        made = subprocess.Popen(
            [str(part) for part in command], stdout=subprocess.PIPE, text=True, cwd=HERE
        )
        self._running.append(made)
        return made

    def python(self, *command: str | Path) -> subprocess.Popen[str]:
        return self.start(sys.executable, *command)


def first_line(program: subprocess.Popen[str]) -> str:
    """What it says when it is ready. Raises SystemExit where it ends before."""
    assert program.stdout is not None
    line = program.stdout.readline()
    if not line:
        raise SystemExit(program.wait() or 1)
    return line.strip()


def confide(records: Path, robot: Path, url: str) -> None:
    """Tells the robot its token of the records, where its state folder has no secrets yet."""
    file = robot / "secrets.toml"
    if file.exists():
        return
    token = json.loads((records / "tokens.json").read_text("utf-8"))["service"]
    said = f'[[service]]\nurl = "{url}/**"\nheaders = {{ Authorization = "Bearer {token}" }}\n'
    descriptor = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    with os.fdopen(descriptor, "w", encoding="utf-8") as out:
        out.write(said)


def allow(robot: Path) -> None:
    """The programs that the robot may start, where its state folder does not list any yet."""
    file = robot / "launch.toml"
    if not file.exists():
        command = [sys.executable, str(HERE / "programs" / "video_call.py"), "{address}"]
        file.write_text(f"video-call = {json.dumps(command)}\n", "utf-8")


def as_whom(robot: Path) -> str:
    """With which rights whoever connects to the robot comes in."""
    if (robot / "keys").exists():
        return "with a key that the robot knows"
    return "from this machine, as operator"


def start_broker(programs: Programs, url: str) -> None:
    host, port = urlsplit(url).hostname or "127.0.0.1", urlsplit(url).port or 1883
    with socket.socket() as look:
        if look.connect_ex((host, port)) == 0:
            return
    mosquitto = shutil.which("mosquitto", path=f"{os.environ.get('PATH', '')}:/usr/sbin")
    if mosquitto is None:
        print("without a broker: no falls are heard (apt-get install mosquitto)", flush=True)
    else:
        # On this port it is bound to this machine only.
        programs.start(mosquitto, "-p", str(port))


def main() -> int:
    home = os.environ.get("XDG_STATE_HOME")
    base = Path(home) if home else Path.home() / ".local" / "state"
    parser = argparse.ArgumentParser(description="Starts the whole of the example.")
    parser.add_argument("--state", type=Path, default=base / "situ" / "vitals", metavar="DIR")
    state: Path = parser.parse_args().state.resolve()
    project = tomllib.loads((HERE / "situ.toml").read_text("utf-8"))
    records = project["tags"]["services.records"]
    address = urlsplit(records)
    # Before the records make theirs in it: of a folder's parents nobody says for whom they are.
    state.mkdir(parents=True, exist_ok=True, mode=0o700)
    with Programs() as programs:
        told = ("--host", address.hostname or "", "--port", str(address.port))
        nurse = first_line(programs.python("-m", "ward_records", state / "records", *told))
        confide(state / "records", state, records)
        allow(state)
        start_broker(programs, project["mqtt"]["url"])
        run = programs.python("-m", "situ", "run", HERE, "--state", state, "--json")
        ready = json.loads(first_line(run))
        for device in DEVICES:
            programs.python(HERE / "modules" / f"{device}.py", ready["requests"])
        seen = ("--records", records, "--tokens", state / "records" / "tokens.json")
        programs.python(HERE / "modules" / "monitor.py", ready["requests"], *seen)
        print(f"the robot's screen: {ready['http']}\nthe nurse's page: {nurse}")
        print(f"the editor (Robot, Connect): {ready['requests']}, {as_whom(state)}", flush=True)
        os.wait()
    return 0


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(0)
