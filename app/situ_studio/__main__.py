"""``python -m situ_studio [PROJECT]``."""

import sys

from situ_studio.main import main

sys.exit(main())
