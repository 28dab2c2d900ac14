"""Small widgets that any panel, page or dialog is made of."""
