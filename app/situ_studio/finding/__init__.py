"""Finding: commands and anything by Ctrl+K, in the whole project by Ctrl+F."""
