import re
from typing import get_args

import pytest

from learnblock.simulator.colours import ColourName
from learnblock.simulator.picture.themes import look_of, shown
from learnblock.simulator.world_description import Theme
from places import ROOT

SCENERY = ROOT / "frontend" / "src" / "views" / "world" / "scenery"
DARK = ("space", "night")


def of_page(source: str, key: str) -> list[str]:
    """The colours of a key of an object of the page's source."""
    found = re.search(rf"\b{key}: (\[.*?\]|\".*?\")", source)
    return re.findall(r"#[0-9a-f]{6}", found[1]) if found else []


def theme_of_page(theme: str, key: str) -> list[str]:
    """The colours of a key of a theme, or of the theme that it begins with."""
    source = (SCENERY / "palette.ts").read_text()
    [themes] = re.findall(r"^const THEMES\b.*?^\};", source, re.MULTILINE | re.DOTALL)
    [own] = re.findall(rf"^  {theme}: (\{{.*?^  \}}|[A-Z]+),", themes, re.MULTILINE | re.DOTALL)
    [base] = re.findall(r"EVENING|PLAYGROUND", own) or ["PLAYGROUND"]
    [inherited] = re.findall(
        rf"^const {base}: Palette = (\{{.*?^\}});", source, re.MULTILINE | re.DOTALL
    )
    return of_page(own, key) or of_page(inherited, key)


def hexadecimal(colours: tuple[tuple[int, int, int], ...]) -> list[str]:
    return ["#{:02x}{:02x}{:02x}".format(*colour) for colour in colours]


@pytest.mark.parametrize("theme", [one for one in get_args(Theme) if one not in DARK])
def test_a_theme_has_the_colours_of_the_page(theme: Theme) -> None:
    look = look_of(theme)

    assert hexadecimal(look.squares) == theme_of_page(theme, "mat")
    assert hexadecimal((look.rim,)) == theme_of_page(theme, "rim")
    assert hexadecimal(look.walls) == theme_of_page(theme, "walls")


@pytest.mark.parametrize("theme", DARK)
def test_a_dark_theme_has_the_rim_of_the_page_and_a_floor_that_shows_paths(theme: Theme) -> None:
    look = look_of(theme)

    assert hexadecimal((look.rim,)) == theme_of_page(theme, "rim")
    assert all(sum(square) > 400 for square in look.squares)


@pytest.mark.parametrize("name", get_args(ColourName))
def test_a_named_colour_has_the_shade_of_the_page(name: ColourName) -> None:
    source = (SCENERY / "colours.ts").read_text().partition("FRIENDLY")[2]

    assert hexadecimal((shown(name),)) == of_page(source, name)


def test_a_wall_without_a_colour_of_its_own_is_left_to_the_theme() -> None:
    look = look_of("garden")

    assert look.wall((205, 200, 185), 5) == look.walls[1]
    assert look.wall((1, 2, 3), 5) == (1, 2, 3)
