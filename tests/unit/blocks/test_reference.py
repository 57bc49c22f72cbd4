from learnblock.blocks import builtin
from learnblock.blocks.reference import reference
from places import ROOT

PAGE = ROOT / "docs" / "skills.md"


def test_the_page_of_skills_is_up_to_date():
    # `scripts/docs` writes it.
    assert PAGE.read_text("utf-8") == reference()


def test_every_skill_has_its_entry():
    page = reference()

    assert [] == [name for name in builtin() if f"### `{name}(" not in page]


def test_the_table_at_the_beginning_leads_to_each_skill():
    contents = reference().partition("\n## ")[0]

    assert [] == [name for name in builtin() if f"[{name}](#{name.lower()}" not in contents]


def test_an_entry_shows_parameters_needs_and_labels():
    assert (
        "### `turn_right(rotSpeed=23)`\n\nTurn to the right on the spot until the next command.\n\n"
        "- `rotSpeed`: degrees/s; positive turns to the right.\n\nA statement; needs `Base`."
        " On the block: EN *keep turning right at (turning speed)°/s*,"
        " ES *girar sin parar a la derecha a (velocidad de giro)°/s*.\n"
    ) in reference()


def test_an_entry_names_the_errors_that_a_skill_raises():
    assert "- raises `StillTurningError`: the turn takes far too long" in reference()
