"""A block of one's own as one file, ``NAME.block.json``, to be given to others.

```json
{
  "learnblock_block": 1,
  "name": "dance",
  "source": [
    "def waltz(robot): ..."
  ],
  "configuration": [{"type": "motor", "category": "Dance", "name": "waltz", ...}]
}
```

The source is a list of its lines, and the configuration is as it stands in ``blocks/NAME.json``.
"""

import json
from dataclasses import dataclass
from typing import Annotated, Any, NoReturn

import msgspec
from msgspec import Meta, Struct, field

from learnblock.blocks import load_configurations
from learnblock.blocks.written import written
from learnblock.errors import Diagnostic, OwnBlockError
from learnblock.own_blocks.own_block import checked_name

ENDING = ".block.json"
VERSION = 1
#: Characters.
LARGEST = 2_000_000


@dataclass(frozen=True, slots=True)
class Package:
    """What is in such a file.

    Args:
        name: of the block.
        source: its Python.
        configuration: what is chosen for it, as JSON; empty for nothing.
    """

    name: str
    source: str
    configuration: str = ""


class _File(Struct, forbid_unknown_fields=True):
    learnblock_block: int
    name: Annotated[str, Meta(min_length=1, max_length=100)]
    source: list[str]
    configuration: list[dict[str, Any]] = field(default_factory=list)


_decode = msgspec.json.Decoder(_File).decode


def pack(package: Package) -> str:
    """The text of the file.

    Raises:
        BlockConfigurationError: the configuration is wrong.
    """
    # A configuration by hand may lack its outer braces, as the paper's do.
    chosen = load_configurations(package.configuration) if package.configuration.strip() else ()
    values = {
        "learnblock_block": VERSION,
        "name": package.name,
        "source": package.source.split("\n"),
        "configuration": json.loads(written(chosen)),
    }
    return json.dumps(values, indent=2, ensure_ascii=False) + "\n"


def unpack(text: str) -> Package:
    """What is in a file.

    Raises:
        OwnBlockError: it is no such file, or a wrong one.
    """
    if len(text) > LARGEST:
        _refuse("too-large", f"the file has {len(text):,} characters; at most {LARGEST:,} are read")
    try:
        file = _decode(text.encode("utf-8", "replace"))
    except (msgspec.MsgspecError, RecursionError) as error:
        _refuse("no-block", f"this is no block that LearnBlock has exported: {error}")
    if file.learnblock_block != VERSION:
        _refuse(
            "unknown-version",
            f"`learnblock_block` is {file.learnblock_block}, and this LearnBlock reads {VERSION}: a"
            " newer one may read it",
        )
    configuration = json.dumps(file.configuration, indent=2, ensure_ascii=False) + "\n"
    return Package(
        checked_name(file.name),
        "\n".join(file.source),
        configuration if file.configuration else "",
    )


def _refuse(code: str, message: str) -> NoReturn:
    raise OwnBlockError(f"*{ENDING}", [Diagnostic(code, message)])
