"""How everything looks: the theme's tokens and style sheet, icons, letters."""
