"""Games in a world: what is in its file, its things, and what they count."""
