"""The names of the folders in that of a pupil: settings and own blocks, projects, files of runs."""

HOME, PROJECTS, TEMPORARY = "home", "projects", "tmp"
