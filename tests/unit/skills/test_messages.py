"""Messages between robots, as a program sends and receives them."""

from learnblock.client.mailbox import Mailbox


def test_a_message_is_sent_with_its_value(robot):
    sent = []
    robot.mailbox = Mailbox(send=lambda *message: sent.append(message))

    robot.send("go")
    robot.send("go", [1, "two"])

    assert sent == [("go", None), ("go", [1, "two"])]


def test_an_event_runs_once_for_each_message(robot):
    waiting = [("go", 1), ("go", 2)]
    robot.mailbox = Mailbox(collect=lambda: [waiting.pop(0)] if waiting else [])
    values = []

    @robot.when(lambda: robot.received("go"))
    def go():
        values.append(robot.message_value("go"))

    @robot.when(lambda: robot.received("go"))
    def go_too():
        values.append(robot.message_value("go") * 10)

    @robot.when(lambda: robot.time() > 1)
    def end():
        robot.stop()

    robot.run()
    assert values == [1, 10, 2, 20]


def test_asking_for_messages_takes_time():
    """A program that only asks would otherwise stop the time of its world."""
    from learnblock.robots.sim_ebo import Robot

    with Robot() as robot:
        for _ in range(100):
            robot.received("go")
            robot.send("here")
        assert robot.clock.time() > 0.15
