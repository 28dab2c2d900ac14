"""The command ``situ``, and ``python -m situ``: quiet from its first moment."""

from __future__ import annotations

import signal
import sys


def main() -> int:
    """Runs the command line and returns its exit status.

    Ctrl-C while the modules are still being read ends the process as it ends any other, where
    Python would show where it was.
    """
    usual = signal.getsignal(signal.SIGINT)
    if usual is signal.default_int_handler:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    from situ import cli

    try:
        signal.signal(signal.SIGINT, usual)
        return cli.main()
    except KeyboardInterrupt:
        return 128 + signal.SIGINT


if __name__ == "__main__":
    sys.exit(main())
