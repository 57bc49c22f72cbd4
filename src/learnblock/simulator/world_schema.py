"""What a world's file may hold, as a JSON Schema: the page's world editor makes its forms from it.

``python -m learnblock.simulator.world_schema > frontend/src/features/world-editor/schema.json``
"""

import json
import sys

import msgspec

from learnblock.simulator.world_description import WorldFile


def world_schema() -> str:
    """The schema of each table of a world's file by the table's name, as JSON text."""
    return json.dumps(msgspec.json.schema(WorldFile)["$defs"], indent=1) + "\n"


if __name__ == "__main__":
    sys.stdout.write(world_schema())
