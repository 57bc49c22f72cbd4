"""`learnblock picture` draws programs with the page's own code, in a browser without a window."""

from xml.etree import ElementTree

import cv2
import pytest
from click.testing import CliRunner

from browser.conftest import chromium
from learnblock.cli import main
from places import ROOT

WORDS = {
    "en": ("when Run is pressed", "for each item", "look happy"),
    "es": ("al pulsar Ejecutar", "para cada elemento", "poner cara alegre"),
}
QUIZ = ROOT / "examples" / "first" / "quiz.bt"


def draw(file, *options):
    chromium()
    result = CliRunner().invoke(main, ["picture", str(file), *map(str, options)])
    assert result.exit_code == 0, result.output


@pytest.mark.parametrize("language", WORDS)
def test_a_program_is_drawn_as_on_the_page(tmp_path, language):
    path = tmp_path / "quiz.svg"
    draw(QUIZ, "--to", path, "--language", language)
    picture = ElementTree.parse(path)  # noqa: S314 - we wrote it
    text = " ".join(picture.getroot().itertext()).replace("\xa0", " ")
    for word in (*WORDS[language], "What is the capital of", QUIZ.read_text()):
        assert word in text


def test_a_png_has_the_background_of_its_theme(tmp_path):
    path = tmp_path / "quiz.png"
    draw(QUIZ, "--to", path, "--theme", "contrast")
    corner = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)[0, 0]
    assert list(corner) == [0, 0, 0, 255]


def test_long_programs_are_drawn_whole(tmp_path):
    program = tmp_path / "long.bt"
    lines = "".join(f"    function.drive_distance({number})\n" for number in range(1000, 1400))
    program.write_text(f"main:\n{lines}end\n")
    draw(program, "--to", tmp_path / "long.svg")
    # The first is in the alternative text.
    assert (tmp_path / "long.svg").read_text().count(">1399<") == 1
    assert (tmp_path / "long.svg").read_text().count(">1200<") == 1
