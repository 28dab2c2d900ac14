"""Situ Studio: the desktop editor in which robots' behaviour is drawn, tried and watched."""
