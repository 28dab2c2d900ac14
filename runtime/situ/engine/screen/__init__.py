"""The robot's touch screen: a page over HTTP, kept up to date over a WebSocket."""
