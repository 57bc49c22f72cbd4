"""The keyboard, as a program asks for it."""

from learnblock.client.keyboard import Keyboard


def test_an_event_reacts_to_a_key(robot):
    robot.keyboard = Keyboard(lambda: ["up"] if 1 <= robot.clock.time() < 2 else [])
    pressed = []

    @robot.when(lambda: robot.is_key_pressed("up"))
    def up():
        pressed.append(robot.time())
        robot.sleep(0.5)

    @robot.when(lambda: robot.time() > 3)
    def end():
        robot.stop()

    robot.run()
    assert pressed
    assert min(pressed) >= 1
    assert max(pressed) < 2.5


def test_asking_for_keys_takes_time():
    """A program that only asks would otherwise stop the time of its world."""
    from learnblock.robots.sim_ebo import Robot

    with Robot() as robot:
        for _ in range(100):
            robot.is_key_pressed()
        assert robot.clock.time() >= 0.1
