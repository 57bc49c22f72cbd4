"""A drawing as a list of shapes, written as an SVG document or a PNG.

Positions are pixels from the upper left corner of the page, x to the right and y down.
"""

import base64
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal
from xml.sax.saxutils import escape

import cv2
import numpy as np
import resvg_py
from numpy.typing import NDArray

from learnblock.simulator.colours import RGB

Point = tuple[float, float]
Points = Sequence[Point]

FONTS = Path(__file__).parent / "fonts"
_FONT_FILES = [str(FONTS / "inter-regular.ttf"), str(FONTS / "inter-semibold.ttf")]
_FONT_FAMILY = "Inter, 'Helvetica Neue', Arial, sans-serif"
# XML 1.0, production 2, leaves out control characters and lone surrogates.
_NO_XML = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
# The characters in the fonts in this folder: Latin, Greek, Cyrillic and punctuation.
_NOT_IN_FONT = re.compile("[^\u0000-\u024f\u0370-\u045f\u2000-\u205f]")


@dataclass(frozen=True, slots=True)
class Paint:
    """The fill and outline of a closed shape; None for no fill or no outline."""

    fill: RGB | None = None
    stroke: RGB | None = None
    width: float = 1.0
    opacity: float = 1.0
    dash: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Polygon:
    """A closed outline with rounded corners of its stroke."""

    points: Points
    paint: Paint


@dataclass(frozen=True, slots=True)
class Polyline:
    """A stroke along points."""

    points: Points
    colour: RGB
    width: float
    opacity: float = 1.0
    dash: tuple[float, ...] = ()
    cap: Literal["round", "butt", "square"] = "round"


@dataclass(frozen=True, slots=True)
class Circle:
    """A disc or a ring."""

    center: Point
    radius: float
    paint: Paint


@dataclass(frozen=True, slots=True)
class SvgText:
    """One line of text.

    Args:
        place: the start, middle or end of its baseline, according to `anchor`.
        text: any characters, shown unchanged.
        size: the font size in pixels.
        halo: the colour of an edge that separates it from the background.
    """

    place: Point
    text: str
    size: float
    colour: RGB
    bold: bool = False
    anchor: Literal["start", "middle", "end"] = "start"
    halo: RGB | None = None


@dataclass(frozen=True, slots=True, eq=False)
class SvgImage:
    """A picture, RGB uint8 of shape (height, width, 3), stretched over a rectangle."""

    corner: Point
    size: tuple[float, float]
    pixels: NDArray[np.uint8]


@dataclass(frozen=True, slots=True)
class OnPage:
    """A shape of the page around the world, which is dark for readers with a dark theme."""

    shape: "Shape"


Shape = Polygon | Polyline | Circle | SvgText | SvgImage | OnPage


def document(
    shapes: Iterable[Shape], width: float, height: float, title: str, style: str = ""
) -> str:
    """The SVG document that shows `shapes`, later ones on top; it has no external references.

    Args:
        shapes: what it shows.
        width: in pixels.
        height: in pixels.
        title: for those who cannot see it.
        style: a style sheet, whose colours come before those of the shapes.
    """
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_number(width)}" '
        f'height="{_number(height)}" viewBox="0 0 {_number(width)} {_number(height)}" '
        f'role="img" font-family="{_FONT_FAMILY}">'
    )
    parts = [head, f"<title>{_escaped(title)}</title>", *([style] if style else [])]
    return "\n".join([*parts, *map(element, shapes), "</svg>\n"])


def in_day(shape: Shape) -> Shape:
    """The shape as it is for all readers."""
    return shape.shape if isinstance(shape, OnPage) else shape


def night_style(colours: Mapping[RGB, RGB]) -> str:
    """A style sheet for readers with a dark theme: what replaces the colours of shapes `OnPage`."""
    rules = [
        f'.page [{what}="{_hex(day)}"]{{{what}:{_hex(night)}}}'
        for day, night in colours.items()
        for what in ("fill", "stroke")
    ]
    return f"<style>@media (prefers-color-scheme: dark){{{''.join(rules)}}}</style>"


def png(svg: str) -> bytes:
    """An SVG document, one pixel per unit, as a PNG with our own fonts.

    System fonts are used only for characters that ours do not have: they would look different
    everywhere, and are slow to find.
    """
    return resvg_py.svg_to_bytes(
        svg_string=svg,
        skip_system_fonts=_NOT_IN_FONT.search(svg) is None,
        font_files=_FONT_FILES,
        sans_serif_family="Inter",
    )


def rectangle(left: float, top: float, width: float, height: float) -> list[Point]:
    """The corners."""
    right, bottom = left + width, top + height
    return [(left, top), (right, top), (right, bottom), (left, bottom)]


def text_width(text: str, size: float) -> float:
    """The approximate width of a text: the font's letters take 0.56 of its size on average."""
    return size * sum(0.56 if ord(character) < 0x1100 else 1.0 for character in text)


def shortened(text: str, length: int) -> str:
    """The text on one line, cut to `length` characters."""
    line = " ".join(text.split())
    return line if len(line) <= length else line[: length - 1].rstrip() + "…"


def element(shape: Shape) -> str:
    """One shape as SVG."""
    match shape:
        case Polygon(points, paint):
            return f'<polygon points="{_places(points)}"{_paint(paint)}/>'
        case Polyline():
            return f'<polyline points="{_places(shape.points)}" fill="none"{_stroke(shape)}/>'
        case Circle((x, y), radius, paint):
            place = f'cx="{_number(x)}" cy="{_number(y)}" r="{_number(radius)}"'
            return f"<circle {place}{_paint(paint)}/>"
        case SvgText():
            return _text(shape)
        case SvgImage():
            return _image(shape)
        case OnPage(inner):
            return f'<g class="page">{element(inner)}</g>'


def _paint(paint: Paint) -> str:
    fill = "none" if paint.fill is None else _hex(paint.fill)
    parts = [f' fill="{fill}"']
    if paint.stroke is not None:
        parts.append(
            f' stroke="{_hex(paint.stroke)}" stroke-width="{_number(paint.width)}"'
            ' stroke-linejoin="round"'
        )
    return "".join(parts) + _dash(paint.dash) + _opacity(paint.opacity)


def _stroke(line: Polyline) -> str:
    join = "round" if line.cap == "round" else "miter"
    return (
        f' stroke="{_hex(line.colour)}" stroke-width="{_number(line.width)}"'
        f' stroke-linecap="{line.cap}" stroke-linejoin="{join}"'
        f"{_dash(line.dash)}{_opacity(line.opacity)}"
    )


def _text(text: SvgText) -> str:
    x, y = text.place
    parts = [f'<text x="{_number(x)}" y="{_number(y)}" font-size="{_number(text.size)}"']
    parts.append(f' fill="{_hex(text.colour)}" text-anchor="{text.anchor}"')
    if text.bold:
        parts.append(' font-weight="600"')
    if text.halo is not None:
        parts.append(
            f' stroke="{_hex(text.halo)}" stroke-width="{_number(text.size * 0.28)}"'
            ' stroke-linejoin="round" paint-order="stroke"'
        )
    return "".join(parts) + f">{_escaped(text.text)}</text>"


def _image(image: SvgImage) -> str:
    (x, y), (width, height) = image.corner, image.size
    _, encoded = cv2.imencode(".png", cv2.cvtColor(image.pixels, cv2.COLOR_RGB2BGR))
    data = base64.b64encode(encoded.tobytes()).decode()
    return (
        f'<image x="{_number(x)}" y="{_number(y)}" width="{_number(width)}"'
        f' height="{_number(height)}" preserveAspectRatio="none"'
        f' href="data:image/png;base64,{data}"/>'
    )


def _places(points: Points) -> str:
    return " ".join(f"{_number(x)},{_number(y)}" for x, y in points)


def _number(value: float) -> str:
    return f"{round(value, 2) + 0.0:.2f}".rstrip("0").rstrip(".")


def _hex(colour: RGB) -> str:
    return "#{:02x}{:02x}{:02x}".format(*colour)


def _dash(dash: tuple[float, ...]) -> str:
    return f' stroke-dasharray="{" ".join(map(_number, dash))}"' if dash else ""


def _opacity(opacity: float) -> str:
    return "" if opacity == 1.0 else f' opacity="{_number(opacity)}"'


def _escaped(text: str) -> str:
    return escape(_NO_XML.sub("\ufffd", text))
