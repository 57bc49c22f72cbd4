"""The messages of the benchmark of abuse are messages that the server takes."""

import json

import pytest

from learnblock.server.pages.page import decode
from worst_messages import worst_messages


@pytest.mark.exhaustive
def test_each_is_within_the_limits(subtests):
    for name, message in worst_messages():
        with subtests.test(name):
            decode(json.dumps(message))
