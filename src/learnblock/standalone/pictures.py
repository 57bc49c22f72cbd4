"""Pictures of programs as blocks, drawn as the page draws them."""

from typing import Literal

from learnblock import language
from learnblock.blocks.known import all_configurations
from learnblock.blocks.palette import palette
from learnblock.language.tree.nodes import Program
from learnblock.standalone.browser import file_from
from learnblock.standalone.page import filled

PictureType = Literal["svg", "png"]
Theme = Literal["light", "dark", "contrast"]


def picture(program: Program, file_type: PictureType, words: str, theme: Theme) -> bytes:
    """Draw a program as blocks.

    Args:
        program: the program.
        file_type: of the picture.
        words: the language of the blocks, such as ``es``.
        theme: the colours of the page.

    Raises:
        LearnBlockError: no browser is installed that can draw it.
    """
    configurations = all_configurations()
    content = {
        "kind": "picture",
        "type": file_type,
        "language": words,
        "theme": theme,
        "palette": palette(configurations, words),
        "workspace": language.to_workspace(program, configurations).workspace,
        "text": language.format(program),
    }
    return file_from(filled(content))
