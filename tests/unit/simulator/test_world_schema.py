import msgspec

from learnblock.simulator.world_schema import world_schema


def test_the_schema_has_the_bounds_of_a_box() -> None:
    length = msgspec.json.decode(world_schema())["Box"]["properties"]["length"]
    assert (length["minimum"], length["maximum"], length["default"]) == (5, 2000, 100.0)
