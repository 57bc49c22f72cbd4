from learnblock.runtime.limits import Limits
from learnblock.runtime.supervision import Supervision
from learnblock.runtime.waiting import STRIDE, Waiting


class World:
    """A world that only counts."""

    dt = 0.01
    is_over = False

    def __init__(self):
        self.steps = 0

    def advance(self, step):
        self.steps = step


def waiting(world, look=bool, seconds=None):
    supervision = Supervision(Limits(), None)
    supervision.seconds = seconds
    return Waiting(world, supervision, look)


def test_the_steps_of_a_wait_pass_and_no_more():
    world = World()
    assert waiting(world).wait(35) == world.steps == 35


def test_no_time_passes_in_a_wait_that_reaches_the_end_of_the_run():
    world = World()
    wait = waiting(world, seconds=0.3).wait
    assert (wait(29), wait(1)) == (29, None)
    assert world.steps == 29


def test_a_wait_ends_soon_after_it_is_known_that_the_run_has_to_end():
    world = World()
    assert waiting(world, lambda: world.steps > 0).wait(1000) is None
    assert world.steps == STRIDE
