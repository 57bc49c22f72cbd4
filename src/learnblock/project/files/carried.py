"""What a project's file carries of its author's own things, so that it runs elsewhere as it did.

```json
"carried": {
  "home": "5f0c...",
  "world": {"name": "room", "file": ["[[wall]]", ...], "picture": "iVBORw0..."},
  "tags": {"door": 12},
  "code": {"blocks": {"dance": {...}}, "libraries": {"moves": {"library.toml": [...], ...}}}
}
```

``home`` tells the folder in which the project was saved from others. Code in ``offered`` has not
been installed in it: only the user's explicit act does that.
"""

from typing import Annotated, Any

from msgspec import Meta, Struct, field

from learnblock.extensions.libraries import Name as LibraryName
from learnblock.perception.tag_names import LAST_TAG, LONGEST_NAME, MOST_NAMES

#: The limit of custom blocks, and of libraries.
MOST_CODE = 100

TagNames = Annotated[
    dict[
        Annotated[str, Meta(min_length=1, max_length=LONGEST_NAME)],
        Annotated[int, Meta(ge=0, le=LAST_TAG)],
    ],
    Meta(max_length=MOST_NAMES),
]
Name = Annotated[str, Meta(min_length=1, max_length=100)]
Lines = list[str]


class CarriedWorld(Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """A world: the lines of its file, and the PNG of its floor."""

    name: Name
    file: Lines
    picture: bytes | None = None


class Code(Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """Custom blocks and libraries by name: exported blocks, and the lines of each file."""

    blocks: Annotated[dict[Name, dict[str, Any]], Meta(max_length=MOST_CODE)] = {}
    libraries: Annotated[dict[LibraryName, dict[Name, Lines]], Meta(max_length=MOST_CODE)] = {}

    def __bool__(self) -> bool:
        return bool(self.blocks or self.libraries)


class Carried(Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """Everything that a project's file carries."""

    home: Annotated[str, Meta(max_length=100)] = ""
    world: CarriedWorld | None = None
    tags: TagNames = {}
    code: Code = field(default_factory=Code)
    offered: Code = field(default_factory=Code)

    def __bool__(self) -> bool:
        return bool(self.world or self.tags or self.code or self.offered)


NOTHING = Carried()
