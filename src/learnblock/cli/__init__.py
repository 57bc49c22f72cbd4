"""The command line."""

from learnblock.cli.entry import main

__all__ = ["main"]
