"""The canvas of a script: opened, edited, painted, beside a small one."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from tests.benchmarks.drawing import qt
from tests.benchmarks.harness import CPU, Bench, Goal, Row, Sample, each

LARGE, SMALL = (200, 100), (10, 5)
"""Situations and modules."""
RESOURCES = 6
WORKS = ("priority", "rename", "reorder", "add", "dwell", "select")


def script(situations: int, modules: int) -> bytes:
    """Each situation looks at two data, has four priorities, and every other one takes over from
    the last."""
    data = max(4, situations * 3 // 10)
    lines = [
        '<spds name="big"><observe>',
        *(f'<data tag="d{d}" type="boolean"/>' for d in range(data)),
        "</observe><modules>",
        *(f'<module name="m{m}" resources="r{m % RESOURCES}"/>' for m in range(modules)),
        "</modules>",
    ]
    for s in range(situations):
        last = s == situations - 1
        extends = f' extends="s{situations - 1}"' if s % 2 and not last else ""
        lines.append(f'<situation name="s{s}"{extends}>')
        if not last:
            lines.append(
                f'<condition><data tag="d{s % data}" is="true" within="5"/>'
                f'<data tag="d{(s * 7 + 3) % data}" is="true"/></condition>'
            )
        every = dict.fromkeys((s * 3 + e) % modules for e in range(4))
        lines += (f'<module name="m{m}" priority="{10 * e}"/>' for e, m in enumerate(every))
        lines.append("</situation>")
    return "".join([*lines, "</spds>"]).encode()


@contextlib.contextmanager
def _samples() -> Iterator[Mapping[str, Sample]]:
    with qt() as app:
        samples: dict[str, Sample] = {}
        shown = []
        for size, word in ((LARGE, "large"), (SMALL, "small")):
            samples[f"opened, {word}"] = _sample(_opening(size, app))
            canvas = _open(size, app)
            shown.append(canvas)
            for name, work in _works(canvas).items():
                samples[f"{name}, {word}"] = _settled(_sample(work), canvas, app)
            samples[f"frame, {word}"] = _sample(_frame(canvas))
        yield samples
        for canvas in shown:
            _close(canvas)


def _open(size: tuple[int, int], app: Any) -> Any:
    """A canvas with all cards and pipes, at the size and place at which it opens."""
    from situ.document import codec
    from situ.document.spds import Spds
    from situ_studio.canvas.script import ScriptCanvas
    from situ_studio.looks.theme import LIGHT

    document, problems = codec.read(script(*size), "big.spds.xml")
    assert isinstance(document, Spds)
    assert not problems
    canvas = ScriptCanvas(LIGHT)
    canvas.resize(1_100, 760)
    canvas.show()
    canvas.show_document(document)
    while canvas.filling.is_filling or canvas.curving.is_curving():
        app.processEvents()
    canvas.edited.connect(lambda after, text: canvas.show_document(after))
    canvas.viewer.viewport().repaint()
    return canvas


def _opening(size: tuple[int, int], app: Any) -> Callable[[int], None]:
    return lambda turn: _close(_open(size, app))


def _close(canvas: Any) -> None:
    canvas.close()
    canvas.deleteLater()


def _works(canvas: Any) -> dict[str, Callable[[int], None]]:
    """What a hand does, each time another value, from the gesture to the painted frame."""
    from situ_studio.canvas import script_gestures as gestures

    def edit(after: Any, text: str) -> None:
        assert canvas._edit(after, text)
        canvas.viewer.viewport().repaint()

    def priority(turn: int) -> None:
        edit(*gestures.prioritise(canvas.document, "s2", "m4", 100 + turn))

    def rename(turn: int) -> None:
        old = canvas.document.situations[3].name
        edit(*gestures.rename(canvas.document, "situation", old, f"name {turn}"))

    def reorder(turn: int) -> None:
        edit(*gestures.reorder(canvas.document, canvas.document.situations[4].name, 6))

    def add(turn: int) -> None:
        """One before nearly all others, and taken away again in the next turn."""
        if turn % 2:
            after, text, _ = gestures.add_situation(canvas.document, 8, "d0", "new")
            edit(after, text)
        else:
            edit(*gestures.delete(canvas.document, [("situation", "new")]))

    def dwell(turn: int) -> None:
        """One that takes over gets a line more, and all below it move."""
        name = next(s.name for s in canvas.document.situations if s.extends)
        edit(*gestures.set_seconds(canvas.document, name, "dwell", 2.0 if turn % 2 else None))

    def select(turn: int) -> None:
        canvas.select([("situation", canvas.document.situations[turn % 4].name)])
        canvas.viewer.viewport().repaint()

    works = priority, rename, reorder, add, dwell, select
    return dict(zip(WORKS, works, strict=True))


def _frame(canvas: Any) -> Callable[[int], None]:
    return lambda turn: canvas.viewer.viewport().repaint()


def _sample(work: Callable[[int], None]) -> Sample:
    turn = 0

    def several(times: int) -> None:
        nonlocal turn
        for _ in range(times):
            turn += 1
            work(turn)

    return each(several, CPU, unit=1e-3)


def _settled(sample: Sample, canvas: Any, app: Any) -> Sample:
    """Ways that nobody sees belong to the frames after."""

    def settled() -> float:
        took = sample()
        while canvas.curving.is_curving():
            app.processEvents()
        return took

    return settled


SIZE = "200 situations and 100 modules"
BENCHES = (
    Bench(
        "script",
        (
            Row(
                f"editor: read and show a script of {SIZE}",
                "open",
                "opened, large",
                "opened, small",
                "ms",
                Goal(1_000.0, of="ours"),
            ),
            *(
                Row(
                    f"editor: {name} in a script of {SIZE}, shown",
                    "edit",
                    f"{name}, large",
                    f"{name}, small",
                    "ms",
                    Goal(50.0, of="ours"),
                )
                for name in WORKS
            ),
            Row(
                f"editor: frame of a script of {SIZE}",
                "frame",
                "frame, large",
                "frame, small",
                "ms",
                Goal(16.0, of="ours"),
            ),
        ),
        _samples,
    ),
)
