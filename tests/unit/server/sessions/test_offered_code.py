"""Before code that came with a project is installed, a page shows what it would replace."""

import homes
from learnblock.extensions import custom_blocks
from learnblock.project.files.carried import Code
from learnblock.server.sessions.offered_code import offer


def test_a_page_learns_which_of_the_users_own_code_would_be_replaced():
    custom_blocks.save("dances", homes.WALTZ)
    homes.install_library("0.9.0", homes.STEPS)
    file = {"source": ["def waltz(robot):", "    pass"]}
    offered = offer(Code({"dances": file, "turns": file}, {"moves": {"library.toml": ["a", "b"]}}))
    assert [(one.name, one.replaces) for one in offered.blocks] == [
        ("dances", True),
        ("turns", False),
    ]
    assert [(one.name, one.replaces) for one in offered.libraries] == [("moves", True)]
    assert offered.blocks[0].source == "def waltz(robot):\n    pass"
    assert offered.libraries[0].source == "# library.toml\na\nb"
