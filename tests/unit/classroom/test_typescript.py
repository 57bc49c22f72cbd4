"""The page's types of a class's conversation."""

from learnblock.classroom.typescript import typescript
from places import ROOT


def test_the_page_has_the_types_of_the_messages():
    written = ROOT / "frontend" / "src" / "protocol" / "classroom.ts"
    assert written.read_text("utf-8") == typescript()
