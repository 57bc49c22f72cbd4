from collections.abc import Iterator

import pytest

from learnblock.testing import FakeRobot


@pytest.fixture
def robot() -> Iterator[FakeRobot]:
    with FakeRobot() as robot:
        yield robot
