import threading

import pytest

from learnblock.clock import WallClock
from learnblock.readings import SENSORS, Glance, PolledReadings, Readings
from learnblock.testing import VirtualClock


class Counter:
    """A sensor that answers how often it was read."""

    def __init__(self):
        self.reads = 0

    def __call__(self):
        self.reads += 1
        return self.reads


@pytest.fixture
def clock():
    return VirtualClock()


@pytest.fixture
def sensor():
    return Counter()


def test_a_sensor_is_read_once_at_one_instant(clock, sensor):
    readings = Readings(clock)
    assert [readings.latest("a", sensor) for _ in range(3)] == [1, 1, 1]


def test_a_sensor_is_read_anew_at_the_next_instant(clock, sensor):
    readings = Readings(clock)
    readings.latest("a", sensor)
    clock.sleep(0.01)
    assert readings.latest("a", sensor) == 2


def test_a_clock_that_flows_has_every_question_read_anew(sensor):
    readings = Readings(WallClock())
    assert [readings.latest("a", sensor) for _ in range(3)] == [1, 2, 3]


def test_sensors_are_kept_apart(clock):
    readings = Readings(clock)
    assert readings.latest("a", lambda: 1) == 1
    assert readings.latest("b", lambda: 2) == 2


def test_forgetting_reads_anew(clock, sensor):
    readings = Readings(clock)
    readings.latest("a", sensor)
    readings.forget()
    assert readings.latest("a", sensor) == 2


def test_within_a_snapshot_every_reading_is_made_once_whatever_the_clock(sensor):
    readings = Readings(WallClock())
    with readings.snapshot():
        assert [readings.latest("a", sensor) for _ in range(3)] == [1, 1, 1]
        readings.forget()
        assert readings.latest("a", sensor) == 1
    assert readings.latest("a", sensor) == 2


def test_different_questions_of_one_glance_see_one_picture(clock, sensor):
    glance = Glance(clock)
    assert [glance.see(question, "lines", sensor) for question in "abc"] == [1, 1, 1]
    assert glance.see("d", "tags", lambda: "tag") == "tag"


def test_a_question_that_is_repeated_is_a_new_glance(clock, sensor):
    glance = Glance(clock)
    assert [glance.see(question, "lines", sensor) for question in "abaab"] == [1, 1, 2, 3, 3]


def test_a_glance_is_short(clock, sensor):
    glance = Glance(clock)
    glance.see("a", "lines", sensor)
    clock.sleep(Glance.LASTS)
    assert glance.see("b", "lines", sensor) == 2


def test_a_snapshot_begins_with_new_readings(clock, sensor):
    readings = Readings(clock)
    readings.latest("a", sensor)
    with readings.snapshot():
        assert readings.latest("a", sensor) == 2


def test_a_snapshot_that_fails_is_over(clock):
    readings = Readings(clock)
    with pytest.raises(OSError, match="out"), readings.snapshot():
        raise OSError("out")
    assert not readings.frozen


def test_an_error_of_a_sensor_is_raised_at_the_asking_place_alone(clock):
    def fail():
        raise OSError("the cable is out")

    with pytest.raises(OSError, match="the cable is out") as caught:
        Readings(clock).latest("a", fail)
    assert caught.value.__context__ is None


@pytest.fixture
def polled():
    # So long a period that the thread does nothing: the tests poll themselves.
    readings = PolledReadings(WallClock(), period=3600)
    yield readings
    readings.close()


def test_the_first_question_reads_at_once_and_the_next_ones_never_wait(polled, sensor):
    assert polled.latest("a", sensor) == 1
    assert polled.latest("a", sensor) == 1
    polled.poll()
    assert polled.latest("a", sensor) == 2
    assert sensor.reads == 2


def test_only_sensors_in_use_are_polled(polled, sensor):
    unused = Counter()
    polled.latest("a", sensor)
    polled.poll()
    assert (2, 0) == (sensor.reads, unused.reads)


def test_no_thread_runs_before_a_sensor_is_in_use():
    before = threading.active_count()
    PolledReadings(WallClock(), period=3600)
    assert before == threading.active_count()


def test_an_error_of_the_reading_thread_is_raised_where_the_program_asks(polled):
    answers = iter([1])

    def read():
        try:
            return next(answers)
        except StopIteration:
            raise OSError("the cable is out") from None

    assert polled.latest("a", read) == 1
    polled.poll()
    with pytest.raises(OSError, match="the cable is out"):
        polled.latest("a", read)


def test_a_sensor_that_recovers_is_read_on(polled):
    answers = iter([OSError("loose"), 5])

    def read():
        answer = next(answers)
        if isinstance(answer, Exception):
            raise answer
        return answer

    with pytest.raises(OSError, match="loose"):
        polled.latest("a", read)
    polled.poll()
    assert polled.latest("a", read) == 5


def test_a_reading_from_before_a_reset_is_never_answered_after_it(polled):
    angle = [90.0]
    polled.latest("gyroscope", lambda: angle[0])
    angle[0] = 0.0
    polled.forget()
    assert polled.latest("gyroscope", lambda: angle[0]) == 0.0


def test_a_reading_under_way_during_a_reset_is_thrown_away(polled):
    angle = [90.0]
    resetting = []

    def read():
        answer = angle[0]
        if resetting:
            resetting.clear()
            angle[0] = 0.0
            polled.forget()
        return answer

    polled.latest("gyroscope", read)
    resetting.append(True)
    polled.poll()
    assert polled.latest("gyroscope", read) == 0.0


def test_the_thread_polls_by_itself_until_it_is_closed():
    third = threading.Event()
    sensor = Counter()

    def read():
        if sensor() == 3:
            third.set()

    readings = PolledReadings(WallClock(), period=0.001)
    readings.latest("a", read)
    assert third.wait(5)
    readings.close()
    assert not readings._pollers[SENSORS]._thread.is_alive()


def test_a_sensor_that_hangs_does_not_hold_up_the_end():
    hanging, free = threading.Event(), threading.Event()
    sensor = Counter()

    def read():
        if sensor() > 1:
            hanging.set()
            free.wait(10)

    readings = PolledReadings(WallClock(), period=0.001)
    readings.latest("a", read)
    assert hanging.wait(5)
    readings.close()
    thread = readings._pollers[SENSORS]._thread
    assert thread.is_alive()
    free.set()
    thread.join(5)


def test_what_is_read_slowly_holds_up_nothing_of_another_pace():
    looking, read_on, free = threading.Event(), threading.Event(), threading.Event()
    looks, distance = Counter(), Counter()

    def look():
        if looks() > 1:
            looking.set()
            free.wait(10)

    def measure():
        # The fifth time while the slow one is under way.
        if looking.is_set() and distance() == 5:
            read_on.set()

    readings = PolledReadings(WallClock(), period=0.001)
    readings.latest("faces", look, "camera")
    readings.latest("distance", measure)
    assert looking.wait(5)
    assert read_on.wait(5)
    free.set()
    readings.close()


def test_no_more_is_read_once_it_is_closed(sensor):
    readings = PolledReadings(WallClock(), period=0.001)
    readings.latest("a", sensor)
    readings.close()
    read = sensor.reads
    readings.latest("b", lambda: 1, "camera")
    assert sensor.reads == read
