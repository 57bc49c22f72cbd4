"""Blocks that are one block in two directions."""

from dataclasses import replace

from learnblock.blocks.pairs import pairs
from learnblock.blocks.palette import palette
from learnblock.blocks.schema.loading import builtin

TURNS = builtin()["turn_left"], builtin()["turn_right"]


def test_curving_and_turning_to_both_sides_are_pairs():
    found = {pair.first: dict(pair.names) for pair in pairs(builtin().values()).values()}
    assert found == {
        "move_left": {"negative": "move_left", "positive": "move_right"},
        "turn_left": {"negative": "turn_left", "positive": "turn_right"},
    }


def test_blocks_with_different_words_are_no_pair():
    left, right = TURNS
    other = replace(right, languages={**right.languages, "EN": "spin {rotSpeed}"})
    assert pairs([left, other]) == {}


def test_two_blocks_with_the_same_direction_are_no_pair():
    left, right = TURNS
    same = replace(right, parameters=left.parameters)
    assert pairs([left, same]) == {}


def test_the_direction_of_a_pair_has_the_types_of_both_blocks():
    found = {one["type"]: one for one in palette(builtin(), "en")["definitions"]}
    (direction,) = (
        one for one in found["lb_skill_turn_right"]["args0"] if one["type"] == "lb_direction"
    )
    types = {"negative": "lb_skill_turn_left", "positive": "lb_skill_turn_right"}
    assert direction["types"] == types


def test_the_second_block_of_a_pair_names_the_first():
    tabs = palette(builtin(), "en")["toolbox"]["contents"]
    items = {one["block"]: one for tab in tabs for one in tab.get("contents", ())}
    assert items["function.turn_right"]["like"] == "function.turn_left"
    assert "like" not in items["function.turn_left"]
