"""A project's program in its three views: keeping them in step, and undo."""
