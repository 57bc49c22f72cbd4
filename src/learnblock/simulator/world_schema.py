"""The content of a world's file as a JSON Schema, from which the world editor makes its forms.

The build writes it into ``frontend/src/features/world-editor/schema.json``.
"""

import json

import msgspec

from learnblock.simulator.world_description import WorldFile


def world_schema() -> str:
    """The schema of each table of a world's file, by the table's name, as JSON text."""
    return json.dumps(msgspec.json.schema(WorldFile)["$defs"], indent=1) + "\n"
