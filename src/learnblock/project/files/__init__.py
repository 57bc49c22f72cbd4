"""Projects on disk: their files, folder and history."""

#: How the name of a project's file ends.
ENDING = ".learnblock"
