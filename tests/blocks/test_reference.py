from pathlib import Path

from learnblock.blocks import builtin
from learnblock.blocks.reference import reference

PAGE = Path(__file__).parents[2] / "docs" / "skills.md"


def test_the_page_of_skills_is_up_to_date():
    # `python -m learnblock.blocks.reference docs/skills.md` writes it anew.
    assert PAGE.read_text("utf-8") == reference()


def test_every_skill_has_its_entry():
    page = reference()

    assert [] == [name for name in builtin() if f"### `{name}(" not in page]


def test_an_entry_tells_parameters_needs_and_labels():
    assert (
        "### `turn_right(rotSpeed=23)`\n\nTurn to the right on the spot until told otherwise.\n\n"
        "- `rotSpeed`: degrees/s; above zero it turns to the right.\n\nA statement; needs `Base`."
        " On the block: EN *turn right*, ES *girar a la derecha*.\n"
    ) in reference()


def test_what_a_skill_raises_is_told_by_its_name():
    assert "- raises `StillTurningError`: it takes far too long" in reference()
