"""The page's types match the messages of the server."""

import re
from typing import Annotated

import msgspec
import pytest

from learnblock.server.typescript import limits, module, typescript, world_typescript


def test_the_page_has_the_types_of_worlds_and_robots():
    assert {"WorldFile", "RobotDescription"} <= set(
        re.findall(r"^export interface (\w+)", world_typescript(), re.MULTILINE)
    )


def test_two_types_of_one_name_are_refused():
    one, other = (msgspec.defstruct("Box", [(field, int)]) for field in ("length", "width"))
    with pytest.raises(TypeError, match="the same name"):
        module("", {}, {}, [one, other])


def test_a_field_with_a_default_may_be_absent():
    assert "  paused?: boolean;" in typescript()


def test_a_message_is_recognised_by_its_kind():
    assert '  kind: "EditText";' in typescript()


def test_the_page_has_no_types_of_what_only_the_server_of_a_class_receives():
    assert not re.findall(r"\b(AtSeat|Work)\b", typescript())


def test_a_message_sent_as_an_array_is_a_tuple():
    assert "export type Place = [block: string, blocktext: number," in typescript()


def test_the_page_knows_the_longest_text_file_and_list_that_a_message_may_have():
    most = [msgspec.Meta(max_length=number) for number in (7, 8, 9)]
    fields = [
        ("text", Annotated[str, most[0]]),
        ("file", Annotated[bytes, most[1]] | None),
        ("list", Annotated[tuple[int, ...], most[2]]),
        ("number", int),
    ]
    written = limits(msgspec.defstruct("Letter", fields))
    expected = {"Letter": {"text": 7, "file": 8, "list": 9}}
    found = written.removeprefix("\nexport const LIMITS = ").removesuffix(" as const;\n")
    assert msgspec.json.decode(found) == expected
