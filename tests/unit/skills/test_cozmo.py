import pytest

BEHAVIOURS = [
    "Bored",
    "Cat",
    "Dances",
    "Dog",
    "Duck",
    "Elephant",
    "Idle",
    "Sheep",
    "Sleep",
    "Sneezes",
    "Vampire",
    "Zombie",
]


@pytest.mark.parametrize("behaviour", BEHAVIOURS)
def test_a_behaviour_is_played(robot, behaviour):
    getattr(robot, f"cozmo{behaviour}")()

    assert [("Animator.play", behaviour)] == robot.commands
