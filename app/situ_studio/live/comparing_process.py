"""Two long runs put beside one another, in a process of its own.

Started as ``python -m situ_studio.live.comparing_process`` by ``Comparing``.
"""

from __future__ import annotations

from situ_studio.answering import answer
from situ_studio.live.alike import alike


def main() -> None:
    answer(lambda runs, _: alike(runs))


if __name__ == "__main__":
    main()
