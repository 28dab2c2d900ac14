"""Why not?, answered in a process of its own: a long trace would hold up the window.

Started as ``python -m situ_studio.live.why_not_process`` by ``AskingWhyNot``.
"""

from __future__ import annotations

from situ_studio.live.why_not import answered
from situ_studio.processes.answering import answer


def main() -> None:
    answer(lambda question, _: answered(question))


if __name__ == "__main__":
    main()
