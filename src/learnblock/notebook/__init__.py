"""Notebooks: ``%load_ext learnblock.notebook`` adds the magic ``%%blocktext``.

A robot that is made in a notebook joins its `session` by itself, without the extension.
"""

from typing import Any


def load_ipython_extension(shell: Any) -> None:
    """Add the magic to IPython, which calls this for ``%load_ext``."""
    # Who only makes a robot needs nothing of what runs programs.
    from learnblock.notebook.program_cells import blocktext  # noqa: PLC0415
    from learnblock.notebook.session import session_of  # noqa: PLC0415

    # From now on cells note their steps, also the one that makes the robot.
    session_of(shell)
    shell.register_magic_function(blocktext, "cell")
