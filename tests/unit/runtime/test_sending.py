"""Messages between programs that do not keep to the rules: the host has its own limits."""

import pytest

from learnblock.runtime.ending import How

pytestmark = pytest.mark.slow

CHEAT = "from learnblock.runtime.messages import Send\nrobot._wire.send(Send({}))\nrobot.time()\n"
DEEP = "value = []\nfor _ in range({}): value = [value]\n"


@pytest.mark.parametrize(
    ("message", "code"),
    [
        ("'x' * 101, 1", "robot-message-name"),
        ("'', 1", "robot-message-name"),
        ("'go', 'x' * 5000", "robot-message-too-large"),
        ("'go', b'x'", "robot-message-value"),
        ("'go', {1: 2}", "robot-message-value"),
    ],
)
def test_the_host_refuses_a_message_that_a_program_should_not_have_sent(run, message, code):
    result = run(CHEAT.replace("{}", message) + "robot.clock.sleep(1)\n")
    assert (result.how, result.ending.phrase.code) == (How.ERROR, code)
    assert result.log[-1] == ("disconnect",)


@pytest.mark.parametrize("levels", [21, 500, 5000])
def test_a_value_with_too_many_levels_ends_only_its_program(run, levels):
    result = run(DEEP.replace("{}", str(levels)) + CHEAT.replace("{}", "'go', value"))
    assert result.how in {How.ERROR, How.KILLED}
    assert result.log[-1] == ("disconnect",)


def test_a_program_that_sends_without_end_lets_time_pass(stage):
    """Ten calls take a step, so the others go on."""
    sender = (
        "from learnblock.client import skills\n"
        "send = skills.find({'send'})['send']\n"
        "while robot.clock.time() < 2: send(robot, 'go', 1)\n"
    )
    receiver = (
        "from learnblock.client import skills\n"
        "robot.clock.sleep(2)\n"
        "print(skills.find({'received'})['received'](robot, 'go'))\n"
    )
    stage.add(sender)
    stage.add(receiver)
    stage.host().run()
    first, second = stage.results()
    assert (first.how, second.how) == (How.FINISHED, How.FINISHED)
    # Each program of this stage is alone: no box connects them.
    assert second.output == "False\n"
