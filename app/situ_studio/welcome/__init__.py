"""The welcome page: what one can start with, and what was used lately."""
