"""The hint for a message that no robot sends, with runs of two robots."""

import pytest

from hint_cases import Case, hints_for
from learnblock.lessons.reading import read_files

LESSON = b"""lesson = 1
title = "A signal"
level = 4
minutes = 5
aims = ["to wait for a message"]
robots = ["sim-thymio"]

[[step]]
title = "Wait"
phase = "make"
text = "Wait for the signal, and drive."
world = "empty"
seconds = 6
partners = [{ name = "Nova", robot = "sim-thymio", program = "nova.bt" }]

[[step.check]]
kind = "ends"
"""
NOVA = b'main:\n    function.send("go", 1)\n    function.sleep(4)\nend\n'


def rules(program):
    lesson = read_files("signal", {"lesson.toml": LESSON, "programs/nova.bt": NOVA})
    return [one.rule for one in hints_for(Case(lesson, 1, "signal", program, ()))]


def waiting_for(name):
    """A program that waits for a message, and then without end."""
    return f"""main:
    wait until function.received("{name}")
    forever:
        function.sleep(1)
    end
end
"""


@pytest.mark.slow
def test_a_program_that_waits_for_a_message_of_another_name_is_told_so():
    assert rules(waiting_for("gone"))[0] == "hint-message-name"
    assert "hint-message-name" not in rules(waiting_for("go"))
