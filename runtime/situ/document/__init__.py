"""What designers wrote, as values: no Qt, no I/O beyond reading and writing files."""
