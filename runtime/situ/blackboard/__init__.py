"""The blackboard on the wire: protocol, sessions, the ZeroMQ door and the client (seed 000)."""
