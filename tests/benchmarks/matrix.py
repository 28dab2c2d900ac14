"""The matrix of a script, beside Qt's own table and model of the same size."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from tests.benchmarks.drawing import qt
from tests.benchmarks.harness import CPU, Bench, Goal, Row, Sample, each

SITUATIONS, MODULES = 200, 100
RESOURCES = ("base", "head", "arm", "speech", "screen", "lights")
OWN = 6
"""Priorities of its own that each situation has; the others it takes over."""


def script() -> bytes:
    """Situations that take over from the one ten below them, all of it from the last."""
    modules = (
        f'<module name="m{m}" resources="{RESOURCES[m % 6]} {RESOURCES[(m * m + 1) % 6]}"/>'
        for m in range(MODULES)
    )
    lines = [f'<spds name="big"><modules>{"".join(modules)}</modules>']
    for s in range(SITUATIONS - 1):
        above = f"s{s + 10}" if s + 10 < SITUATIONS - 1 else "else"
        entries = (
            f'<module name="m{(s * 7 + e * 13) % MODULES}" priority="{s * e % 90}"/>'
            for e in range(OWN)
        )
        lines.append(
            f'<situation name="s{s}" extends="{above}"><condition><data tag="t{s}" is="true"/>'
            f"</condition>{''.join(entries)}</situation>"
        )
    every = (f'<module name="m{m}" priority="{m}"/>' for m in range(MODULES))
    return "".join([*lines, f'<situation name="else">{"".join(every)}</situation></spds>']).encode()


@contextlib.contextmanager
def _samples() -> Iterator[Mapping[str, Sample]]:
    """From the edit's value to the painted table, and one frame while it is scrolled."""
    with qt() as app:
        from PySide6.QtGui import QStandardItem, QStandardItemModel
        from PySide6.QtWidgets import QTableView

        from situ.document import codec
        from situ.document.spds import Spds
        from situ_studio.looks.theme import LIGHT
        from situ_studio.matrix import edits
        from situ_studio.matrix.view import MatrixView
        from situ_studio.views.table import Setting

        found, _ = codec.read(script(), "big.spds.xml")
        assert isinstance(found, Spds)
        document = found
        view = MatrixView(Setting(document, LIGHT, None))
        plain = QTableView()
        model = QStandardItemModel(SITUATIONS, MODULES)
        for row in range(SITUATIONS):
            for column in range(MODULES):
                model.setItem(row, column, QStandardItem(str(row * column % 90)))
        plain.setModel(model)
        for shown in (view, plain):
            shown.resize(1_040, 700)
            shown.show()
        view.show_document(document, [])
        app.processEvents()

        def edit(row: int) -> Callable[[int], None]:
            def work(turn: int) -> None:
                nonlocal document
                view.table.scrollTo(view.model.index(row, 3))
                document = edits.put(document, {(row, "m3"): 1_000 + turn})
                view.show_document(document, [])
                app.processEvents()

            return work

        def scroll(table: Any) -> Callable[[int], None]:
            down, across = table.verticalScrollBar(), table.horizontalScrollBar()

            def work(turn: int) -> None:
                """A notch of a wheel further, now and then to the side."""
                down.setValue(turn * 84 % down.maximum())
                across.setValue(turn // 8 * 84 % across.maximum())
                app.processEvents()

            return work

        yield {
            "an edit, 200 × 100": _sample(edit(3)),
            "an edit of what all take over": _sample(edit(SITUATIONS - 1)),
            "a frame, 200 × 100": _sample(scroll(view.table)),
            "a frame of a bare table": _sample(scroll(plain)),
        }
        for shown in (view, plain):
            shown.close()
            shown.deleteLater()


def _sample(work: Callable[[int], None]) -> Sample:
    turn = 0

    def several(times: int) -> None:
        nonlocal turn
        for _ in range(times):
            turn += 1
            work(turn)

    return each(several, CPU, unit=1e-3)


BENCHES = (
    Bench(
        "matrix",
        (
            Row(
                "editor: a priority in a matrix of 200 × 100, shown",
                "matrix",
                "an edit, 200 × 100",
                "a frame of a bare table",
                "ms",
                Goal(50.0, of="ours"),
            ),
            Row(
                "editor: a priority that all 200 situations take over, shown",
                "matrix",
                "an edit of what all take over",
                "a frame of a bare table",
                "ms",
                Goal(50.0, of="ours"),
            ),
            Row(
                "editor: a frame of a matrix of 200 × 100 while it is scrolled",
                "matrix",
                "a frame, 200 × 100",
                "a frame of a bare table",
                "ms",
                Goal(16.0, of="ours"),
            ),
        ),
        _samples,
    ),
)
