"""The chosen row of a list: not by a pale ground alone."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractItemView

from situ_studio.looks import theme
from situ_studio.panels.project_tree import MEDIA
from situ_studio.panels.table import Row


def barred(view: QAbstractItemView, colour: int) -> list[bool]:
    """Of each of its first rows, whether it begins with a bar of that colour."""
    model, picture = view.model(), view.viewport().grab().toImage()
    rects = [view.visualRect(model.index(row, 0)) for row in range(min(3, model.rowCount()))]
    return [
        {picture.pixel(x, rect.center().y()) for x in (0, 1)} == {colour}
        and picture.pixel(3, rect.center().y()) != colour
        for rect in rects
    ]


@pytest.mark.parametrize("colours", [theme.LIGHT, theme.DARK], ids=lambda one: one.name)
def test_the_chosen_row_begins_with_a_bar_in_every_list_and_table(
    studio: Callable[..., Any], project: Callable[[str], Path], colours: theme.Theme
) -> None:
    it = studio(project("reception"), colours.name)
    window, accent = it.window, colours.color("accent").rgb()
    window.open_file(MEDIA)
    it.settle()
    media = window.pages.page(MEDIA).list
    media.setCurrentRow(1)
    assert barred(media, accent) == [False, True, False]
    window.open_file("reception.rbd.xml")
    it.select("state", "7")
    it.key(Qt.Key.Key_Delete)
    window.session.check_now()
    problems = window.problems.list
    problems.setCurrentIndex(problems.model().index(1, 0))
    it.settle()
    assert barred(problems, accent) == [False, True, False]
    window.bottom.choose("scenarios")
    table = window.scenarios.panel.table
    table.rows.show([Row(key, (key, "", "", "")) for key in ("a", "b", "c")])
    it.settle()
    assert barred(table, accent) == [False, False, False]
    table.choose("b")
    it.settle()
    assert barred(table, accent) == [False, True, False]
    it.key(Qt.Key.Key_Down)
    assert barred(table, accent) == [False, False, True]
