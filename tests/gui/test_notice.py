"""What a strip above the canvas asks is read, and answered, in a narrow window too."""

from __future__ import annotations

from typing import Any

from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QVBoxLayout, QWidget

from situ_studio.looks.theme import LIGHT
from situ_studio.panels.notice import Notice


def test_answers_stand_beside_the_words_and_below_them_where_these_had_no_room(qt: Any) -> None:
    window, notice = QWidget(), Notice(LIGHT)
    column = QVBoxLayout(window)
    column.setContentsMargins(0, 0, 0, 0)
    column.addWidget(notice)
    column.addStretch(1)
    window.resize(700, 300)
    window.show()
    assert QTest.qWaitForWindowExposed(window)
    asked = "There are changes to reception.rbd.xml of 2026-11-22 17:35 that were not saved."
    notice.ask(asked, ("Bring them back", list), ("Forget them", list))
    for wide in (700, 330, 700):
        window.resize(wide, 300)
        for _ in range(3):
            QApplication.processEvents()
        words = notice.words.geometry()
        assert words.height() >= notice.words.heightForWidth(words.width())
        for button in notice.buttons:
            assert notice.rect().contains(button.geometry())
            if wide == 700:
                assert button.geometry().left() > words.right()
            else:
                assert button.geometry().top() > words.bottom()
                assert words.width() > wide / 2
    window.close()
    window.deleteLater()
