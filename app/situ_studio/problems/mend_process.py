"""Planning how all problems of one kind are mended, in a process of its own: it takes many checks.

Started as ``python -m situ_studio.problems.mend_process`` by ``AlikeMending``.
"""

from __future__ import annotations

from situ_studio.problems.alike_mending import plan
from situ_studio.processes.answering import answer


def main() -> None:
    answer(lambda wanted, _: plan(wanted))


if __name__ == "__main__":
    main()
