"""How often a project's runs came through each thing, as its drawings show it. No Qt."""

from __future__ import annotations

from collections import Counter, defaultdict

from situ.document.project import Project
from situ.rehearse.coverage import Coverage
from situ_studio.canvas.live import LiveScript, LiveView


def painted(project: Project, coverage: Coverage) -> dict[str, LiveView | LiveScript]:
    """By file. What a part was run by counts together; a situation that was current once holds."""
    states: dict[str, Counter[str]] = defaultdict(Counter)
    for seen in coverage.states.values():
        # Also those that none came through: 0 is what somebody looks for.
        states[seen.file][seen.place[1]] += seen.times
    ways: dict[str, Counter[tuple[str, str]]] = defaultdict(Counter)
    for way in coverage.transitions.values():
        match tuple(way.place):
            case ("state", no, "event", index):
                ways[way.file][no, index] += way.times
            case ("state", no, "timeout", *_):
                ways[way.file][no, "timeout"] += way.times
            case _:
                pass  # of every state: it has no line of its own in the drawing
    found: dict[str, LiveView | LiveScript] = {
        file: LiveView(counts=counts, transitions=ways[file]) for file, counts in states.items()
    }
    if project.spds_file is not None:
        came = [name for name, seen in coverage.situations.items() if seen.covered]
        times = {name: seen.times for name, seen in coverage.situations.items()}
        found[project.spds_file] = LiveScript(holds=frozenset(came), counts=times)
    return found
