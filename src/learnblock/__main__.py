"""``python -m learnblock``."""

from learnblock.cli import main

main(prog_name="learnblock")
