"""The messages of the benchmark of abuse are messages that the server takes."""

import json

import pytest

from learnblock.server.pages.page import decode
from worst_messages import worst_messages


@pytest.mark.parametrize("name_and_message", tuple(worst_messages()), ids=lambda one: one[0])
def test_each_is_within_the_limits(name_and_message):
    _, message = name_and_message
    decode(json.dumps(message))
