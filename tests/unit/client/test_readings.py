import threading

import pytest

from learnblock.client.clock import WallClock
from learnblock.client.readings import (
    PICTURE,
    READING,
    SENSORS,
    WATCHED,
    Glance,
    PolledReadings,
    Readings,
    SteppedReadings,
)
from learnblock.testing import VirtualClock

pytestmark = pytest.mark.realtime


class Counter:
    """A sensor that returns how often it was read."""

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
    readings = SteppedReadings(clock)
    assert [readings.latest("a", sensor) for _ in range(3)] == [1, 1, 1]


def test_a_sensor_is_read_again_at_the_next_instant(clock, sensor):
    readings = SteppedReadings(clock)
    readings.latest("a", sensor)
    clock.sleep(0.01)
    assert readings.latest("a", sensor) == 2


def test_with_a_wall_clock_every_query_reads_again(sensor):
    readings = Readings(WallClock())
    assert [readings.latest("a", sensor) for _ in range(3)] == [1, 2, 3]


def test_sensors_are_independent(clock):
    readings = Readings(clock)
    assert readings.latest("a", lambda: 1) == 1
    assert readings.latest("b", lambda: 2) == 2


@pytest.mark.parametrize("pace", [SENSORS, "camera"])
def test_after_forgetting_sensors_are_read_again(clock, sensor, pace):
    readings = SteppedReadings(clock)
    readings.latest("a", sensor, pace)
    readings.forget()
    assert readings.latest("a", sensor, pace) == 2


def test_a_picture_lasts_until_the_next_one(clock, sensor):
    readings = SteppedReadings(clock)
    readings.latest("lines", sensor, "camera")
    clock.sleep(PICTURE - 0.01)
    assert readings.latest("lines", sensor, "camera") == 1
    clock.sleep(0.01)
    assert readings.latest("lines", sensor, "camera") == 2


@pytest.mark.parametrize(("pace", "period"), [(SENSORS, READING), ("camera", PICTURE)])
def test_a_repeated_question_waits_for_something_new(clock, pace, period):
    readings = SteppedReadings(clock)
    clock.sleep(0.01)
    for question in ("left", "right", "left", "right", "left"):
        readings.ask((question,), pace)
    assert clock.time() == pytest.approx(0.01 + 2 * period)


def test_a_question_that_was_answered_long_ago_does_not_wait(clock):
    readings = SteppedReadings(clock)
    readings.ask(("left",))
    clock.sleep(READING)
    readings.ask(("left",))
    assert clock.time() == READING


def test_one_question_may_read_several_sensors(clock):
    readings, question = SteppedReadings(clock), ("is_line",)
    for _ in range(3):
        readings.ask(question)
    assert clock.time() == 0


def test_a_snapshot_asks_without_waiting_and_its_questions_are_not_counted(clock):
    readings = SteppedReadings(clock)
    readings.ask(("left",))
    with readings.snapshot():
        readings.ask(("left",))
        readings.ask(("right",))
    readings.ask(("right",))
    assert clock.time() == 0


def test_a_question_with_arguments_of_any_kind_is_recognized(clock):
    readings = SteppedReadings(clock)
    for place in ([1], [2], [1]):
        readings.ask(("near", place))
    assert clock.time() == READING


def test_after_forgetting_its_questions_each_is_answered_at_once(clock):
    readings = SteppedReadings(clock)
    readings.ask(("left",))
    readings.forget_questions()
    readings.ask(("left",))
    assert clock.time() == 0


def test_within_a_snapshot_every_sensor_is_read_once_with_any_clock(sensor):
    readings = Readings(WallClock())
    with readings.snapshot():
        assert [readings.latest("a", sensor) for _ in range(3)] == [1, 1, 1]
        readings.forget()
        assert readings.latest("a", sensor) == 1
    assert readings.latest("a", sensor) == 2


def test_different_queries_of_one_glance_use_the_same_picture(clock, sensor):
    glance = Glance(clock)
    assert [glance.see(question, "lines", sensor) for question in "abc"] == [1, 1, 1]
    assert glance.see("d", "tags", lambda: "tag") == "tag"


def test_a_repeated_query_starts_a_new_glance(clock, sensor):
    glance = Glance(clock)
    assert [glance.see(question, "lines", sensor) for question in "abaab"] == [1, 1, 2, 3, 3]


def test_a_glance_is_short(clock, sensor):
    glance = Glance(clock)
    glance.see("a", "lines", sensor)
    clock.sleep(PICTURE)
    assert glance.see("b", "lines", sensor) == 2


def test_a_snapshot_begins_with_new_readings(clock, sensor):
    readings = Readings(clock)
    readings.latest("a", sensor)
    with readings.snapshot():
        assert readings.latest("a", sensor) == 2


def test_a_failed_snapshot_ends(clock):
    readings = Readings(clock)
    with pytest.raises(OSError, match="out"), readings.snapshot():
        raise OSError("out")
    assert not readings.frozen


def test_a_sensor_error_is_raised_only_if_the_program_reads_it(clock):
    def fail():
        raise OSError("the cable is out")

    with pytest.raises(OSError, match="the cable is out") as caught:
        Readings(clock).latest("a", fail)
    assert caught.value.__context__ is None


@pytest.fixture
def polled():
    # The period is so long that the thread does nothing: the tests poll.
    readings = PolledReadings(WallClock(), period=3600)
    yield readings
    readings.close()


def test_the_first_query_reads_at_once_and_the_next_ones_never_wait(polled, sensor):
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


def test_an_error_of_the_polling_thread_is_raised_where_the_program_reads(polled):
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


def test_a_sensor_that_recovers_is_read_again(polled):
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


def test_a_reading_from_before_a_reset_is_not_used_after_it(polled):
    angle = [90.0]
    polled.latest("gyroscope", lambda: angle[0])
    angle[0] = 0.0
    polled.forget()
    assert polled.latest("gyroscope", lambda: angle[0]) == 0.0


def test_a_reading_that_overlaps_a_reset_is_discarded(polled):
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


def test_the_thread_polls_until_it_is_closed():
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


def test_a_sensor_that_hangs_does_not_delay_the_end():
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


def test_a_slow_sensor_does_not_delay_another_pace():
    looking, read_on, free = threading.Event(), threading.Event(), threading.Event()
    looks, distance = Counter(), Counter()

    def look():
        if looks() > 1:
            looking.set()
            free.wait(10)

    def measure():
        # The fifth read starts while the slow one is still running.
        if looking.is_set() and distance() == 5:
            read_on.set()

    readings = PolledReadings(WallClock(), period=0.001)
    readings.latest("faces", look, "camera")
    readings.latest("distance", measure)
    assert looking.wait(5)
    assert read_on.wait(5)
    free.set()
    readings.close()


def test_nothing_is_read_after_close(sensor):
    readings = PolledReadings(WallClock(), period=0.001)
    readings.latest("a", sensor)
    readings.close()
    read = sensor.reads
    readings.latest("b", lambda: 1, "camera")
    assert sensor.reads == read


def test_a_watched_sensor_is_polled_separately_from_those_of_the_program(sensor):
    readings = PolledReadings(WallClock(), period=3600)
    readings.watch("a", sensor)
    assert readings.newest("a") is None
    readings.poll(WATCHED)
    assert (readings.newest("a"), sensor.reads) == (1, 1)
    # The program's first query reads it at once; after that only the program reads it.
    assert readings.latest("a", sensor) == 2
    readings.poll(WATCHED)
    assert (readings.newest("a"), sensor.reads) == (2, 2)
    readings.close()


def test_the_error_of_a_watched_sensor_is_kept_for_observers():
    def fail():
        raise OSError("gone")

    readings = PolledReadings(WallClock(), period=3600)
    readings.watch("a", fail)
    readings.poll(WATCHED)
    assert readings.newest("a") is None
    assert isinstance(readings.error("a"), OSError)
    assert readings.age() is None
    readings.close()


def test_observers_that_begin_together_share_one_thread(monkeypatch):
    begin = threading.Thread.start
    started = []

    def start(thread):
        started.append(thread.name)
        # Long enough for the other observers to see that it does not run yet.
        threading.Event().wait(0.01)
        begin(thread)

    readings = PolledReadings(WallClock(), period=0.001)
    together = threading.Barrier(4)

    def observe():
        together.wait()
        readings.watch("a", lambda: 1)

    monkeypatch.setattr(threading.Thread, "start", start)
    observers = [threading.Thread(target=observe) for _ in range(4)]
    for observer in observers:
        observer.start()
    for observer in observers:
        observer.join()
    readings.close()
    assert started.count(WATCHED) == 1
