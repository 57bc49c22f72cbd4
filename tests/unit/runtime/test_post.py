from learnblock.client.mailbox import MOST_WAITING
from learnblock.runtime.post import Post


def test_a_message_reaches_all_others_a_step_later_and_only_once():
    first, second, third = map(Post(3).box, range(3))
    first.send("go", 1, step=5)
    assert second.collect(step=5) == []
    assert second.collect(step=6) == [("go", 1)]
    assert second.collect(step=6) == []
    assert third.collect(step=9) == [("go", 1)]
    assert first.collect(step=9) == []


def test_messages_arrive_in_the_order_in_which_they_were_sent():
    first, second, third = map(Post(3).box, range(3))
    first.send("a", 1, step=1)
    second.send("b", 2, step=1)
    first.send("a", 3, step=2)
    assert third.collect(step=2) == [("a", 1), ("b", 2)]
    assert third.collect(step=3) == [("a", 3)]


def test_a_message_of_a_real_robot_or_to_one_arrives_at_once():
    twin, real = map(Post(2).box, range(2))
    real.send("go", 1, step=None)
    assert twin.collect(step=0) == [("go", 1)]
    twin.send("here", 2, step=7)
    assert real.collect(step=None) == [("here", 2)]


def test_a_robot_that_never_reads_keeps_only_the_newest_messages():
    first, second = map(Post(2).box, range(2))
    for number in range(MOST_WAITING + 3):
        first.send("go", number, step=0)
    arrived = second.collect(step=1)
    assert len(arrived) == MOST_WAITING
    assert arrived[0] == ("go", 3)
