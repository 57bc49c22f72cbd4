from dataclasses import dataclass, field

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.client.events import Events
from learnblock.devices import DistanceSensors
from learnblock.testing import FakeRobot, VirtualClock


class Stage(Events):
    """Events in virtual time that end after some cycles."""

    def __init__(self, cycles=3):
        super().__init__()
        self.clock = VirtualClock()
        self._left = cycles
        self.seen = []

    @property
    def stopped(self):
        return self._left <= 0

    def stop(self):
        self._left = 0

    def _cycle(self):
        super()._cycle()
        self._left -= 1

    def note(self, *what):
        self.seen.append((*what, self.clock.time()))


def test_when_start_runs_once_before_the_first_cycle():
    robot = Stage(cycles=2)

    @robot.when(lambda: True)
    def always():
        robot.seen.append("always")

    @robot.when_start
    def start():
        robot.seen.append("start")

    robot.run()
    assert robot.seen == ["start", "always", "always"]


def test_without_a_when_the_run_ends_after_the_start():
    robot = Stage()
    robot.when_start(lambda: robot.seen.append("start"))
    robot.run()
    assert robot.seen == ["start"]


def test_a_conditional_when_follows_its_condition():
    robot = Stage(cycles=4)
    answers = iter([True, False, True, True])

    @robot.when(lambda: next(answers))
    def body():
        robot.seen.append(robot.clock.time())

    robot.run()
    assert robot.seen == [0.0, 0.04, 0.06]


def test_conditions_are_evaluated_in_source_order_before_any_body():
    robot = Stage(cycles=1)
    for name in "ab":
        robot.when(lambda name=name: robot.seen.append("condition " + name) or True)(
            lambda name=name: robot.seen.append("body " + name)
        )
    robot.run()
    assert robot.seen == ["condition a", "condition b", "body a", "body b"]


def test_an_unconditional_when_is_inactive_until_it_is_activated():
    robot = Stage(cycles=2)
    when = robot.when(lambda: robot.seen.append("body"))
    assert not when.active
    robot.run()
    assert robot.seen == []


def test_activating_a_later_when_takes_effect_in_the_same_cycle():
    robot = Stage(cycles=2)

    @robot.when(lambda: robot.clock.time() == 0)
    def first():
        second.activate()

    @robot.when
    def second():
        robot.seen.append(robot.clock.time())

    robot.run()
    assert robot.seen == [0.0, 0.02]


def test_activating_an_earlier_when_takes_effect_in_the_next_cycle():
    robot = Stage(cycles=3)

    @robot.when
    def first():
        robot.seen.append(robot.clock.time())

    @robot.when(lambda: robot.clock.time() == 0)
    def second():
        first.activate()

    robot.run()
    assert robot.seen == [0.02, 0.04]


def test_deactivating_a_later_conditional_when_lasts_until_its_next_evaluation():
    robot = Stage(cycles=2)

    @robot.when(lambda: robot.clock.time() == 0)
    def first():
        second.deactivate()

    @robot.when(lambda: True)
    def second():
        robot.seen.append(robot.clock.time())

    robot.run()
    assert robot.seen == [0.02]


def test_activating_a_conditional_when_lasts_until_its_next_evaluation():
    robot = Stage(cycles=3)

    @robot.when(lambda: robot.clock.time() == 0)
    def first():
        second.activate()

    @robot.when(lambda: False)
    def second():
        robot.seen.append(robot.clock.time())

    robot.run()
    assert robot.seen == [0.0]


def test_the_time_is_the_seconds_since_activation_at_every_moment_of_a_body():
    robot = Stage(cycles=3)

    @robot.when(lambda: True)
    def body():
        robot.note(body.time)
        robot.clock.sleep(0.05)
        robot.note(body.time)

    robot.run()
    assert robot.seen == [
        (0.0, 0.0), (0.05, 0.05),
        (0.05, 0.05), (0.1, 0.1),
        (0.1, 0.1), (pytest.approx(0.15), pytest.approx(0.15)),
    ]  # fmt: skip


def test_the_time_is_0_after_deactivation_and_begins_again_with_the_next_activation():
    robot = Stage(cycles=6)
    answers = iter([True, True, False, True, True, False])

    @robot.when(lambda: next(answers))
    def body():
        robot.seen.append(body.time)

    @robot.when(lambda: True)
    def watch():
        robot.seen.append(("watched", body.time))

    robot.run()
    times = [0.0, ("watched", 0.0), 0.02, ("watched", 0.02), ("watched", 0.0)]
    assert robot.seen == times * 2


def test_a_loop_that_waits_for_the_time_of_its_own_event_ends():
    robot = Stage(cycles=1)

    @robot.when
    def body():
        while body.time < 3:
            robot.clock.sleep(0.5)
        robot.note(body.time)

    body.activate()
    robot.run()
    assert robot.seen == [(3.0, 3.0)]


def test_time_counts_from_the_activation_also_while_another_body_runs():
    robot = Stage(cycles=1)

    @robot.when_start
    def start():
        body.activate()
        robot.clock.sleep(2)

    @robot.when
    def body():
        robot.note(body.time)

    robot.run()
    assert robot.seen == [(2.0, 2.0)]


def test_times_have_no_rounding_errors():
    robot = Stage(cycles=1)
    when = robot.when(bool)
    robot.clock.sleep(0.1)
    when.activate()
    when.run()
    robot.clock.sleep(0.2)
    assert when.time == 0.2


def test_the_time_of_a_body_that_reactivates_itself_begins_again():
    robot = Stage(cycles=3)

    @robot.when
    def body():
        robot.seen.append(body.time)
        robot.clock.sleep(1)
        body.deactivate()
        body.activate()
        robot.seen.append(body.time)

    body.activate()
    robot.run()
    assert robot.seen == [0.0, 0.0] * 3


def test_activating_an_active_when_changes_nothing():
    robot = Stage(cycles=3)

    @robot.when
    def body():
        robot.seen.append(body.time)
        body.activate()

    body.activate()
    robot.run()
    assert robot.seen == [0.0, 0.02, 0.04]


def test_bodies_never_overlap_and_a_sleep_delays_the_others():
    robot = Stage(cycles=1)
    for name in "ab":

        @robot.when(lambda: True)
        def body(name=name):
            robot.note(name, "begins")
            robot.clock.sleep(1)
            robot.note(name, "ends")

    robot.run()
    assert robot.seen == [
        ("a", "begins", 0.0), ("a", "ends", 1.0), ("b", "begins", 1.0), ("b", "ends", 2.0),
    ]  # fmt: skip


def test_a_cycle_takes_at_least_20_ms():
    robot = Stage(cycles=5)
    robot.when(lambda: False)(bool)
    robot.run()
    assert robot.clock.time() == pytest.approx(0.1)


def test_no_sleep_follows_a_long_cycle():
    robot = Stage(cycles=3)
    robot.when(lambda: True)(lambda: robot.clock.sleep(0.5))
    robot.run()
    assert robot.clock.time() == pytest.approx(1.5)


def test_stop_in_a_body_ends_the_run_before_the_next_body_and_without_waiting():
    robot = Stage(cycles=9)
    robot.when(lambda: True)(robot.stop)
    robot.when(lambda: True)(lambda: robot.seen.append("next"))
    robot.run()
    assert robot.seen == []
    robot = Stage(cycles=9)
    robot.when(lambda: True)(robot.stop)
    robot.run()
    assert robot.clock.time() == 0.0


def test_stop_in_the_start_ends_the_run():
    robot = Stage(cycles=9)
    robot.when_start(robot.stop)
    robot.when(lambda: True)(lambda: robot.seen.append("body"))
    robot.run()
    assert robot.seen == []


def test_all_conditions_of_a_cycle_see_one_reading():
    with FakeRobot(skills=[]) as robot:
        reads, seen = [], []

        def read():
            reads.append(len(reads))
            return {"front": [len(reads)]}

        robot.device(DistanceSensors).read = read
        for _ in range(2):
            robot.when(lambda: seen.append(robot.read(DistanceSensors)["front"][0]))(bool)
        robot.when(lambda: robot.time() > 0)(robot.stop)
        robot.run()
    assert seen == [1, 1, 2, 2]


def test_a_when_describes_itself():
    robot = Stage()

    @robot.when
    def dance():
        pass

    assert repr(dance) == "<when dance: inactive>"
    dance.activate()
    assert repr(dance) == "<when dance: active>"


def test_an_error_in_a_body_ends_the_run_at_its_line():
    robot = Stage()
    robot.when(lambda: True)(lambda: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        robot.run()


# The cycle again, as the three rules of the language reference on plain values.


@dataclass
class Model:
    """The state of every `when` as a plain value."""

    programs: list
    active: list = field(default_factory=list)
    since: list = field(default_factory=list)
    now: int = 0
    seen: list = field(default_factory=list)

    def __post_init__(self):
        count = len(self.programs)
        self.active, self.since = [False] * count, [0] * count

    def set(self, index, active):
        if active and not self.active[index]:
            self.since[index] = self.now
        self.active[index] = active

    def time(self, index):
        return self.now - self.since[index] if self.active[index] else 0

    def cycle(self, number):
        began = self.now
        for index, (condition, _) in enumerate(self.programs):
            if condition is not None:
                self.set(index, condition[number])
        for index, (_, actions) in enumerate(self.programs):
            if self.active[index]:
                self.run(index, actions[number])
        self.now = max(self.now, began + 20)

    def run(self, index, actions):
        self.seen.append((index, self.time(index), self.now))
        for kind, value in actions:
            if kind == "sleep":
                self.now += value
            elif value < len(self.programs):
                self.set(value, kind == "activate")


CYCLES = 4
actions = st.lists(
    st.one_of(
        st.tuples(st.just("sleep"), st.sampled_from([5, 20, 70])),
        st.tuples(st.sampled_from(["activate", "deactivate"]), st.integers(0, 3)),
    ),
    max_size=3,
)
whens = st.tuples(
    st.none() | st.lists(st.booleans(), min_size=CYCLES, max_size=CYCLES),
    st.lists(actions, min_size=CYCLES, max_size=CYCLES),
)


@given(st.lists(whens, min_size=1, max_size=4))
def test_any_event_driven_program_follows_the_rules(programs):
    model = Model(programs)
    for number in range(CYCLES):
        model.cycle(number)
    assert model.seen == performed(programs)


def performed(programs):
    """Return the behaviour of the real code: (index, time, now) of every body that runs, in ms."""
    robot = Stage(CYCLES)
    made = []
    for index, (condition, actions) in enumerate(programs):

        def body(index=index, actions=actions):
            robot.seen.append(
                (index, round(made[index].time * 1000), round(robot.clock.time() * 1000))
            )
            for kind, value in actions[CYCLES - robot._left]:
                if kind == "sleep":
                    robot.clock.sleep(value / 1000)
                elif value < len(made):
                    getattr(made[value], kind)()

        if condition is None:
            made.append(robot.when(body))
        else:
            made.append(robot.when(lambda c=condition: c[CYCLES - robot._left])(body))
    robot.run()
    return robot.seen


def test_waiting_until_a_condition_asks_it_at_once_and_in_every_period():
    robot = Stage()
    answers = iter([False, False, True])

    def asked():
        robot.note("asked")
        return next(answers)

    robot.wait_until(asked)

    assert robot.seen == [("asked", 0.0), ("asked", 0.02), ("asked", 0.04)]


def test_waiting_until_what_is_true_already_takes_no_time():
    robot = Stage()
    robot.wait_until(lambda: True)
    assert robot.clock.time() == 0


def test_waiting_reads_the_sensors_anew():
    ahead = iter([900, 900, 100])
    with FakeRobot() as robot:
        robot.device(DistanceSensors).read = lambda: {"front": [next(ahead)]}
        robot.wait_until(lambda: robot.is_front_obstacle(200))
    assert list(ahead) == []


def test_an_event_that_waits_holds_the_others():
    robot = Stage(cycles=1)

    @robot.when(lambda: True)
    def first():
        robot.wait_until(lambda: robot.clock.time() > 0.05)
        robot.note("first")

    @robot.when(lambda: True)
    def second():
        robot.note("second")

    robot.run()

    assert robot.seen == [("first", 0.06), ("second", 0.06)]


def test_several_starts_run_in_order_before_the_first_cycle():
    robot = Stage(cycles=1)
    robot.when_start(lambda: robot.seen.append("first"))
    robot.when_start(lambda: robot.seen.append("second"))
    robot.when(lambda: robot.seen.append("when")).activate()
    robot.run()
    assert robot.seen == ["first", "second", "when"]
