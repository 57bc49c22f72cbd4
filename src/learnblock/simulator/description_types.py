"""The types of the values in a world's file.

Places are mm, x east and y north of the middle of the floor; headings are degrees clockwise, 0 is
east.
"""

from typing import Annotated, Literal, get_args

from msgspec import Meta

Place = Annotated[float, Meta(ge=-5000, le=5000)]
XY = tuple[Place, Place]
Heading = Annotated[float, Meta(ge=-360, le=360)]
Side = Annotated[float, Meta(ge=5, le=2000)]
ObjectHeight = Annotated[float, Meta(ge=1, le=1000)]
Mass = Annotated[float, Meta(ge=0.01, le=50)]
Text = Annotated[str, Meta(max_length=200)]
Name = Annotated[str, Meta(min_length=1, max_length=40)]
Seconds = Annotated[float, Meta(ge=0.1, le=3600)]
TagNumber = Annotated[int, Meta(ge=0, le=586)]
Emotion = Literal["fear", "surprise", "anger", "sadness", "disgust", "joy", "neutral"]
EMOTIONS: tuple[str, ...] = get_args(Emotion)
#: What one does in a world, in the order of the page's gallery.
Group = Literal["games", "drive", "obstacles", "lines", "tags", "faces", "several", "empty"]
Difficulty = Literal["easy", "medium", "tricky"]

X = Meta(description="position to the east, mm")
Y = Meta(description="position to the north, mm")
HEADING = Meta(description="degrees clockwise; 0 is east")
