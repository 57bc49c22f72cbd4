"""The page's types of a class's conversation."""

import re

from learnblock.classroom.typescript import typescript


def test_the_page_has_the_types_of_the_messages_in_both_directions():
    unions = re.findall(r"^export type (\w+) =$", typescript(), re.MULTILINE)
    assert unions == ["FromPupil", "ToPupil", "FromTeacher", "ToTeacher"]
