"""Block configurations: their types, and how they are read from JSON and written to it."""
