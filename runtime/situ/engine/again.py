"""``situ run`` by way of ``situ run``: the command lines of the processes that are supervised."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import msgspec

from situ.engine.parts import supervise
from situ.engine.readiness import ANNOUNCEMENT, say_ready

if TYPE_CHECKING:
    from situ.engine.announcing import Announcing

HANDED_ON = (
    *("endpoint", "notify", "http", "keys", "insecure", "services", "adapter", "state", "sync"),
    *("fresh", "as_given", "trace", "record", "seed", "speech", "patience", "log_level"),
)
"""The options of ``situ run`` that mean something to the processes that are started."""


def keep_running(options: Mapping[str, Any]) -> int:
    """Runs what the options of ``situ run`` say in processes that are started again when they die;
    the exit status."""
    services: tuple[str, ...] = options["services"]
    apart: bool = options["apart"]
    parts = services if apart else services[:1]
    begun: set[str] = set()
    announcing: Announcing | None = None

    def command(part: str, fresh: bool, told: Mapping[str, str]) -> list[str]:
        known = {name: msgspec.json.decode(line) for name, line in told.items()}
        given = dict(options, services=part if apart else ",".join(services))
        given["fresh"] = fresh or (options["fresh"] and part not in begun)
        given["as_given"] = options["as_given"] and part not in begun
        begun.add(part)
        if core := known.get(parts[0]):
            given["endpoint"] = core["requests"]
            if part == parts[0]:
                given["notify"] = core["notifications"]
        if part in known and known[part]["http"] is not None:
            # Pages that are open find the screen where it was.
            given["http"] = known[part]["http"].partition("//")[2].partition("/")[0]
        return arguments(given)

    def ready(told: Mapping[str, str]) -> None:
        nonlocal announcing
        lines = [msgspec.json.decode(line) for line in told.values()]
        http = next((line["http"] for line in lines if line["http"] is not None), None)
        announcement = lines[0].pop(ANNOUNCEMENT, None)
        line = msgspec.json.encode({**lines[0], "http": http}).decode()
        say_ready(line, as_json=options["json"], aside=options["trace"] == "-")
        if announcement is not None:
            from situ.engine.announcing import Announcement, Announcing

            announcing = announcing or Announcing()
            announcing.begin(msgspec.convert(announcement, Announcement))

    try:
        return supervise(parts, command, ready)
    finally:
        if announcing is not None:
            announcing.close()


def arguments(given: Mapping[str, Any]) -> list[str]:
    """The command line of one supervised process."""
    line = ["run", given["project"], "--supervised"]
    for name in HANDED_ON:
        value = given.get(name)
        option = f"--{name.replace('_', '-')}"
        if value is True:
            line.append(option)
        elif value is not None and value is not False:
            host_and_port = isinstance(value, tuple)
            line += [option, f"{value[0]}:{value[1]}" if host_and_port else str(value)]
    return line
