"""The checks of lessons as a JSON Schema, from which the lesson editor makes its forms.

The build writes it into ``frontend/src/features/lesson-editor/schema.json``.
"""

import json

import msgspec

from learnblock.lessons.checks import Check


def check_schema() -> str:
    """The schema of each kind of check and of event, by its name, as JSON text."""
    return json.dumps(msgspec.json.schema(Check)["$defs"], indent=1) + "\n"
