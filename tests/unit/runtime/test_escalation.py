"""Something that does not end is ended by stronger and stronger measures."""

import pytest

from learnblock.runtime.escalation import PATIENCE, Measure, escalate


class Stubborn:
    """Ends only after the measure with this name.

    Time passes only in `wait`.
    """

    def __init__(self, gives_way_to):
        self.taken = []
        self.waited = 0.0
        self._gives_way_to = gives_way_to

    def measures(self, **seconds):
        return [
            Measure(lambda name=name: self.taken.append(name), each)
            for name, each in seconds.items()
        ]

    def wait(self, seconds):
        ended = self._gives_way_to in self.taken
        self.waited += 0 if ended else seconds
        return ended


@pytest.mark.parametrize(
    ("gives_way_to", "taken", "waited"),
    [
        ("stop", ["stop"], 0),
        ("kill", ["stop", "kill"], 1.5),
        ("nothing", ["stop", "kill"], 2.5),
    ],
)
def test_a_stronger_measure_follows_only_when_the_time_of_the_weaker_one_is_up(
    gives_way_to, taken, waited
):
    program = Stubborn(gives_way_to)
    ended = escalate(program.measures(stop=1.5, kill=1), program.wait)
    assert (ended, program.taken, program.waited) == (gives_way_to != "nothing", taken, waited)


def test_a_run_that_does_not_end_is_left_behind_within_two_seconds():
    run = Stubborn("nothing")
    measures = PATIENCE.measures(lambda: run.taken.append("stop"), lambda: run.taken.append("kill"))

    assert not escalate(measures, run.wait)
    assert run.taken == ["stop", "kill"]
    assert run.waited < 2
