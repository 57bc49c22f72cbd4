"""Projects on disk: their files, folder and history."""
