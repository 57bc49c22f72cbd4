"""How often a page may do something."""

import pytest

from learnblock.classroom.quota import Bucket, Buckets
from learnblock.server.messages.base import Pace


class Clock:
    time = 0.0

    def __call__(self):
        return self.time


def test_a_burst_is_free_and_the_rest_is_spread():
    bucket = Bucket(Pace(minute=60, burst=3), Clock())
    assert [bucket.take() for _ in range(5)] == pytest.approx([0, 0, 0, 1, 2])


def test_time_refills_it_but_not_beyond_the_burst():
    clock = Clock()
    bucket = Bucket(Pace(minute=60, burst=3), clock)
    for _ in range(3):
        bucket.take()
    clock.time = 1000.0
    assert [bucket.take() for _ in range(4)] == pytest.approx([0, 0, 0, 1])


def test_a_try_that_fails_costs_nothing():
    clock = Clock()
    bucket = Bucket(Pace(minute=60, burst=1), clock)
    assert bucket.try_take() == 0.0
    assert [bucket.try_take() for _ in range(10)] == pytest.approx([1.0] * 10)
    clock.time = 1.0
    assert bucket.try_take() == 0.0


def test_each_key_has_a_bucket_of_its_own():
    buckets = Buckets(Pace(minute=60, burst=1), Clock())
    assert buckets.try_take("10.0.0.1") == 0.0
    assert buckets.try_take("10.0.0.1") == pytest.approx(1.0)
    assert buckets.try_take("10.0.0.2") == 0.0


def test_memory_for_keys_is_bounded():
    buckets = Buckets(Pace(minute=60, burst=1), Clock())
    for number in range(3000):
        buckets.try_take(str(number))
    assert len(buckets._buckets) == 1000
