"""``python -m situ``: the same as the command ``situ``."""

from __future__ import annotations

import sys

from situ.cli import main

sys.exit(main())
