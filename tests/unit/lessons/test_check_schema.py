"""The form of the lesson editor is made from the checks."""

from learnblock.lessons.check_schema import check_schema
from places import ROOT


def test_the_editor_has_the_schema_of_the_checks():
    schema = ROOT / "frontend/src/features/lesson-editor/schema.json"
    assert schema.read_text("utf-8") == check_schema()
