"""Projects on disk: their files, their folder and their history."""
