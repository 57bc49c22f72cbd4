"""`learnblock new`: the files of a new robot, skill or world, from templates."""
