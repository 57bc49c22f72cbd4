import base64
import re
from xml.etree import ElementTree

import cv2
import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from learnblock.simulator.picture.svg import (
    Circle,
    Paint,
    Polygon,
    Polyline,
    SvgImage,
    SvgText,
    document,
    element,
    png,
    rectangle,
    shortened,
)

INK = (45, 48, 56)
xml_characters = st.characters(exclude_categories=("Cc", "Cs"), exclude_characters="\ufffe\uffff")


def parsed(svg: str) -> ElementTree.Element:
    return ElementTree.fromstring(svg.encode())  # noqa: S314 - we wrote it ourselves


def decoded(data: bytes) -> np.ndarray:
    return cv2.cvtColor(cv2.imdecode(np.frombuffer(data, np.uint8), 1), cv2.COLOR_BGR2RGB)


def test_a_document_shows_its_shapes_in_order():
    shapes = [
        Polygon(rectangle(0, 0, 10, 5), Paint((255, 0, 0))),
        Polyline([(0, 0), (1.256, 2)], (0, 0, 255), 3.0, 0.5, dash=(4, 2)),
        Circle((5, 5), 2.5, Paint(stroke=(0, 0, 0))),
        SvgText((1, 2), "a < b", 16, INK, bold=True, anchor="middle"),
    ]
    expected = """\
<svg xmlns="http://www.w3.org/2000/svg" width="20" height="10" viewBox="0 0 20 10" role="img" \
font-family="Inter, 'Helvetica Neue', Arial, sans-serif">
<title>R&amp;D</title>
<polygon points="0,0 10,0 10,5 0,5" fill="#ff0000"/>
<polyline points="0,0 1.26,2" fill="none" stroke="#0000ff" stroke-width="3" \
stroke-linecap="round" stroke-linejoin="round" stroke-dasharray="4 2" opacity="0.5"/>
<circle cx="5" cy="5" r="2.5" fill="none" stroke="#000000" stroke-width="1" \
stroke-linejoin="round"/>
<text x="1" y="2" font-size="16" fill="#2d3038" text-anchor="middle" font-weight="600">\
a &lt; b</text>
</svg>
"""
    assert expected == document(shapes, 20, 10, "R&D")


@given(st.text(xml_characters))
def test_any_text_survives_a_round_trip(text: str):
    assert text == (parsed(element(SvgText((0, 0), text, 12, INK))).text or "")


@given(st.text(st.characters(exclude_categories=())))
def test_characters_that_xml_cannot_contain_are_replaced(text: str):
    svg = document([SvgText((0, 0), text, 12, INK)], 10, 10, text)
    assert "svg" in parsed(svg).tag


def test_a_picture_is_embedded_without_loss():
    pixels = np.arange(48, dtype=np.uint8).reshape(4, 4, 3)
    found = re.search(
        r'href="data:image/png;base64,([^"]+)"', element(SvgImage((0, 0), (9, 9), pixels))
    )
    assert found
    np.testing.assert_array_equal(pixels, decoded(base64.b64decode(found[1])))


def test_a_png_has_one_pixel_per_unit():
    page = Polygon(rectangle(0, 0, 30, 20), Paint((200, 100, 50)))
    image = decoded(png(document([page], 30, 20, "")))
    assert (20, 30, 3) == image.shape
    assert [200, 100, 50] == image[10, 15].tolist()


def test_a_png_shows_text_without_system_fonts():
    shapes = [
        Polygon(rectangle(0, 0, 60, 30), Paint((255, 255, 255))),
        SvgText((5, 22), "Größe Ж", 16, (0, 0, 0)),
    ]
    image = decoded(png(document(shapes, 60, 30, "")))
    assert image.min() < 60


def test_bold_text_is_drawn_heavier():
    def ink(bold: bool) -> float:
        page = Polygon(rectangle(0, 0, 100, 30), Paint((255, 255, 255)))
        text = SvgText((5, 22), "learning", 20, (0, 0, 0), bold=bold)
        return float((255 - decoded(png(document([page, text], 100, 30, "")))).sum())

    assert ink(bold=True) > 1.08 * ink(bold=False)


def test_a_long_text_is_cut_and_put_on_one_line():
    assert "stopped by th…" == shortened("stopped\nby   the time limit", 14)
    assert "completed" == shortened("completed", 14)
