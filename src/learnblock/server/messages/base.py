"""What all messages are made of."""

from typing import Annotated, Literal

from msgspec import Meta, Struct

#: Longer texts are no program that a person wrote.
LONGEST_TEXT = 1_000_000
#: Sets of blocks that a project takes along.
MOST_CARRIED = 8

Notation = Literal["blocktext", "python"]
View = Literal["blocks", "blocktext", "python"]
StateName = Literal["idle", "starting", "running", "paused", "held", "input", "ended"]
Text = Annotated[str, Meta(max_length=LONGEST_TEXT)]
Name = Annotated[str, Meta(min_length=1, max_length=100)]
#: A name, or nothing.
ShortText = Annotated[str, Meta(max_length=100)]
#: Of a block.
Id = Annotated[str, Meta(min_length=1, max_length=100)]
Coordinate = Annotated[float, Meta(ge=-5000, le=5000)]


class Message(Struct, tag_field="kind", omit_defaults=True, frozen=True):
    """A message of the conversation."""
