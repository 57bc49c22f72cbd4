"""Files of projects with several robots."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as some

from learnblock.errors import ProjectError
from learnblock.project.files.project import Project, ProjectPart
from learnblock.project.files.project_file import decode, encode
from learnblock.running import MOST_ROBOTS

TEXTS = some.text(alphabet="abc \n:é🤖", max_size=40)
NAMES = some.from_regex(r"[a-z][a-z0-9 -]{0,20}[a-z]", fullmatch=True)
PARTS = some.builds(
    ProjectPart,
    name=NAMES,
    blocktext=TEXTS,
    python=some.none() | TEXTS,
    robot=some.sampled_from(["sim-ebo", "ev3"]),
    breakpoints=some.lists(some.text("ab", min_size=1, max_size=5), max_size=3).map(tuple),
)
TEAMS = some.lists(PARTS, min_size=2, max_size=MOST_ROBOTS, unique_by=lambda part: part.name)
COUNTS = some.lists(some.integers(1, 9), min_size=1, max_size=3)
PART = {"name": "two", "blocktext": ["main:", "    pass", "end"]}


def file_of(*others, **values):
    project = {"learnblock": 3, "first": "one", "blocktext": [], "others": others, **values}
    return json.dumps(project).encode()


def refusal(data):
    with pytest.raises(ProjectError) as caught:
        decode(data, "p")
    (diagnostic,) = caught.value.diagnostics
    return diagnostic


@given(TEAMS)
def test_a_file_has_all_robots_with_their_programs(parts):
    project = Project("p", world="sumo").with_parts(parts)
    assert decode(encode(project), "p") == project
    assert project.parts == tuple(parts)


@given(COUNTS)
def test_a_file_says_how_many_robots_run_each_program(counts):
    parts = [ProjectPart(f"part {index}", count=count) for index, count in enumerate(counts)]
    project = Project("p").with_parts(parts)
    read = decode(encode(project), "p")
    assert read.has_several == (sum(counts) > 1)
    assert [part.count for part in read.parts] == counts


def test_a_file_without_shared_programs_has_the_version_that_older_ones_read():
    two = Project("p").with_parts([ProjectPart("one"), ProjectPart("two")])
    assert json.loads(encode(two))["learnblock"] == 3
    shared = Project("p").with_parts([ProjectPart("one", count=2)])
    assert json.loads(encode(shared))["learnblock"] == 4


def test_a_project_with_one_robot_is_written_as_before():
    alone = Project("p").with_parts([ProjectPart("any name", "main:\nend")])
    assert encode(alone) == encode(Project("p", "main:\nend"))
    assert "first" not in json.loads(encode(alone))


def test_each_line_of_every_program_has_a_line_of_its_own_in_the_file():
    project = Project("p").with_parts([ProjectPart("one", "1\n2"), ProjectPart("two", "3\n4")])
    assert encode(project).decode().count('"3",\n') == 1


@pytest.mark.parametrize(
    ("data", "code"),
    [
        (file_of(PART, PART), "robot-name"),
        (file_of({**PART, "name": "one"}), "robot-name"),
        (file_of({**PART, "name": "../two"}), "robot-name"),
        (file_of({**PART, "name": ""}), "robot-name"),
        (file_of({**PART, "name": "x" * 41}), "wrong-value"),
        (file_of({**PART, "robot": "/etc/passwd"}), "no-name"),
        (file_of({**PART, "blocktext": "main:"}), "wrong-value"),
        (file_of({**PART, "more": 1}), "unknown-key"),
        (file_of({"name": "two"}), "missing-key"),
        (file_of(*({**PART, "name": f"r{i}"} for i in range(MOST_ROBOTS))), "wrong-value"),
        (file_of({**PART, "breakpoints": ["b"] * 100_000}), "wrong-value"),
        (file_of(PART, first=""), "robot-name"),
        (file_of(PART, others=3), "wrong-value"),
        (file_of({**PART, "count": 0}), "wrong-value"),
        (file_of(count="ten"), "wrong-value"),
        (file_of(count=MOST_ROBOTS + 1), "wrong-value"),
        (file_of({**PART, "count": MOST_ROBOTS}), "too-many"),
        (file_of(count=2, first=""), "robot-name"),
    ],
)
def test_an_invalid_robot_is_refused(data, code):
    assert refusal(data).code == code
