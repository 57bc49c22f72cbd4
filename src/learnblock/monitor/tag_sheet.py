"""Tags on paper: a page for printing tags at their true size from a browser."""

import base64
import html
from collections.abc import Sequence

from learnblock.i18n import ENGLISH, Phrase, translate
from learnblock.monitor.worlds import tag_picture

#: The side of the black square that robots measure, in mm, without the white margin of an eighth.
SIDE = 80.0
_MARGIN = 0.125

_PAGE = """\
<!doctype html>
<html lang="{language}">
<meta charset="utf-8">
<title>{title}</title>
<style>
body {{ margin: 0; font: 12pt sans-serif }}
figure {{ display: inline-block; margin: 4mm; break-inside: avoid; text-align: center }}
img {{ display: block; inline-size: {poster:g}mm; block-size: {poster:g}mm;
  outline: 0.2mm dashed #999; image-rendering: pixelated }}
</style>
{figures}
</html>
"""


def sheet(tags: Sequence[tuple[int, str]], side: float = SIDE, language: str = ENGLISH) -> str:
    """Make a page of HTML with AprilTags of the family 36h11, to be printed at 100 %.

    Args:
        tags: the number of each tag, and the caption below it.
        side: the side of the black square, in mm.
        language: the language of the title.

    Raises:
        TagNumberError: there is no tag with this number.
    """
    figures = "\n".join(_figure(number, name) for number, name in tags)
    title = translate(Phrase("world-tag-sheet"), language)
    poster = side * (1 + 2 * _MARGIN)
    return _PAGE.format(language=language, title=title, poster=poster, figures=figures)


def _figure(number: int, name: str) -> str:
    picture = base64.b64encode(tag_picture(number)).decode()
    caption = f"{number} {html.escape(name)}".strip()
    return (
        f'<figure><img alt="{number}" src="data:image/png;base64,{picture}">'
        f"<figcaption>{caption}</figcaption></figure>"
    )
