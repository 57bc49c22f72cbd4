"""The command line's parts: a module for each group of commands that `learnblock.cli` has."""
