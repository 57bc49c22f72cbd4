"""A project's program in its three views: what an edit of one makes of the others, and undo."""
