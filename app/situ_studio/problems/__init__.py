"""A project's problems: found, told, gone to and mended."""
