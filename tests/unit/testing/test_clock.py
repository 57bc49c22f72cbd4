from learnblock.testing import VirtualClock


def test_sleeping_for_an_hour_takes_no_time():
    clock = VirtualClock()
    clock.sleep(3600)

    assert 3600 == clock.time()


def test_the_instant_changes_exactly_when_time_does():
    clock = VirtualClock()
    instants = [clock.instant]
    for seconds in (0, -1, 0.5):
        clock.sleep(seconds)
        instants.append(clock.instant)

    assert [0, 0, 0, 1] == instants
    assert 0.5 == clock.time()


def test_access_to_a_device_takes_no_time():
    clock = VirtualClock()
    clock.charge()

    assert 0 == clock.time()
