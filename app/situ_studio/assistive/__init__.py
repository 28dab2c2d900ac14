"""For who can not see the window or has no mouse: names, announcements, the way of Tab."""
