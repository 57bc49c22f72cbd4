"""The form of the lesson editor is made from the checks."""

from typing import get_args

import msgspec

from learnblock.lessons.check_schema import check_schema
from learnblock.lessons.checks import Check


def test_the_editor_has_the_schema_of_each_check():
    kinds = {kind.__name__ for kind in get_args(Check)}
    assert kinds <= set(msgspec.json.decode(check_schema()))
