"""What the commands of ``situ_studio.actions`` do, when they can be done, their menus and keys."""
