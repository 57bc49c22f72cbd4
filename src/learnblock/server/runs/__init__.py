"""Running the program of a session, and telling its pages what happens."""
