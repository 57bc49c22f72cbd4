"""A program marks a Cozmo as in use, for other programs on this computer."""

from learnblock.robots.cozmo.use import Use, is_used

PLACE = ("192.0.2.7", 5551)
OTHER = ("192.0.2.8", 5551)


def test_a_robot_is_in_use_from_the_mark_to_its_end():
    assert not is_used(*PLACE)
    use = Use(*PLACE)
    assert is_used(*PLACE)
    assert not is_used(*OTHER)
    use.end()
    use.end()
    assert not is_used(*PLACE)


def test_a_second_mark_changes_nothing():
    use, second = Use(*PLACE), Use(*PLACE)
    second.end()
    assert is_used(*PLACE)
    use.end()
    assert not is_used(*PLACE)
