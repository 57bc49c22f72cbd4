"""What a SPIKE hub sends and receives: Pybricks' events and commands, and the agent's lines."""

import contextlib
import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.errors import RobotConnectionError
from learnblock.robots.spike import lines, profile
from learnblock.robots.spike.lines import HubState


@given(st.binary(max_size=3000), st.integers(20, 512))
def test_a_hub_has_the_whole_program_after_the_commands_that_upload_it(program, largest):
    memory, sizes = bytearray(3000), []
    for command in profile.uploading(program, largest):
        assert len(command) <= largest
        kind, number = struct.unpack_from("<BI", command)
        if kind == profile.HubCommand.WRITE_PROGRAM_SIZE:
            sizes.append(number)
        else:
            memory[number : number + len(command) - 5] = command[5:]
    assert (sizes, memory[: len(program)]) == ([0, len(program)], program)


@given(st.binary(max_size=600), st.integers(20, 512))
def test_what_is_typed_arrives_in_pieces_that_fit(text, largest):
    commands = list(profile.typing(text, largest))
    assert all(len(command) <= largest for command in commands)
    assert b"".join(command[1:] for command in commands) == text


def test_a_report_is_read_in_the_units_of_devices():
    assert lines.state("s 120 -118 -45 2000 87 1 8123") == HubState(
        120, -118, -4.5, 2000, 87, 1, 8.123
    )
    assert lines.state("s 0 0 0 - - - 8000") == HubState(0, 0, 0, None, None, None, 8.0)


def test_a_motor_that_does_not_answer_is_named():
    with pytest.raises(RobotConnectionError, match="left motor"):
        lines.state("s - 0 0 - - - 8000")


def test_a_text_for_the_matrix_is_one_line_of_ascii():
    assert lines.show("¿Dónde\nestás?") == b"t Donde estas?\n"
    assert len(lines.show("x" * 1000)) == lines.LONGEST_TEXT + 3


@given(
    st.one_of(
        st.text(),
        st.from_regex(r"(s|error|learnblock 1) [-0-9a-z= .]{0,80}", fullmatch=True),
        st.integers().map(lambda number: f"s {number} 0 0 0 0 0 {number}"),
    )
)
def test_every_line_of_a_hub_is_read_or_rejected(line):
    for read in (lines.state, lines.ports, lines.error):
        with contextlib.suppress(ValueError, RobotConnectionError):
            read(line)


@given(st.binary(max_size=40))
def test_every_value_of_a_hub_is_read_or_rejected(data):
    for read in (
        profile.status,
        profile.Capabilities.parsed,
        lambda data: profile.version(data.decode("latin-1")),
    ):
        with contextlib.suppress(ValueError):
            read(data)
