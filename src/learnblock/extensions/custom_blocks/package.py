"""A custom block as one file to share, ``NAME.block.json``.

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

The source is a list of its lines, and the configuration is that of ``blocks/NAME.json``.
"""

import json
from dataclasses import dataclass
from typing import Annotated, Any, NoReturn

import msgspec
from msgspec import Meta, Struct, field

from learnblock.blocks import load_configurations
from learnblock.blocks.schema.writing import written
from learnblock.errors import CustomBlockError, Diagnostic
from learnblock.extensions.custom_blocks.custom_block import checked_name
from learnblock.i18n import Phrase

ENDING = ".block.json"
VERSION = 1
#: The limit in characters.
LARGEST = 2_000_000


@dataclass(frozen=True, slots=True)
class Package:
    """The content of such a file.

    Args:
        name: the name of the block.
        source: the Python source.
        configuration: the configuration as JSON; empty for the defaults.
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
    """The block as the text of the file.

    Raises:
        BlockConfigurationError: the configuration is invalid.
    """
    # A configuration written by hand may lack its outer braces, like those in the paper.
    configurations = (
        load_configurations(package.configuration) if package.configuration.strip() else ()
    )
    values = {
        "learnblock_block": VERSION,
        "name": package.name,
        "source": package.source.split("\n"),
        "configuration": json.loads(written(configurations)),
    }
    return json.dumps(values, indent=2, ensure_ascii=False) + "\n"


def unpack(text: str) -> Package:
    """The block in a file.

    Raises:
        CustomBlockError: the file is damaged, or not an exported block.
    """
    if len(text) > LARGEST:
        _refuse("too-large", Phrase("custom-file-too-large", limit=LARGEST))
    try:
        file = _decode(text.encode("utf-8", "replace"))
    except (msgspec.MsgspecError, RecursionError) as error:
        _refuse("no-block", Phrase("custom-not-exported", reason=str(error)))
    if file.learnblock_block != VERSION:
        version = str(file.learnblock_block)
        _refuse(
            "unknown-version",
            Phrase("custom-file-version", version=version, known=str(VERSION)),
        )
    configuration = json.dumps(file.configuration, indent=2, ensure_ascii=False) + "\n"
    return Package(
        checked_name(file.name),
        "\n".join(file.source),
        configuration if file.configuration else "",
    )


def _refuse(code: str, message: Phrase) -> NoReturn:
    raise CustomBlockError(f"*{ENDING}", [Diagnostic(code, message)])
