"""The timeline: what the robot did on one axis of time, and the cursor in it."""
