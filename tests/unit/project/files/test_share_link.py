"""A link holds a project and the hash of its run; a hostile one is refused within limits."""

import json
import random
import zlib
from base64 import urlsafe_b64encode
from contextlib import suppress

import pytest

from fuzz import mutated
from learnblock.errors import LearnBlockError
from learnblock.extensions import worlds
from learnblock.extensions.worlds import PackedWorld
from learnblock.project.files import share_link
from learnblock.project.files.exchange import project_of
from learnblock.project.files.project import Project, ProjectPart
from learnblock.project.files.share_link import (
    LARGEST_INFLATED,
    LONGEST_LINK,
    LinkError,
    ProvedRun,
    SharedProject,
    link_of,
    linked_name,
    read_link,
)
from learnblock.runtime.ending import How
from shared_worlds import ROOM

BLOCKTEXT = "# Ein Quadrat: größer.\nmain:\n    function.move_straight(40)\nend"
PYTHON = (
    "from learnblock.robots.simulated.ebo import Robot\n\nrobot = Robot()\nrobot.move_straight()\n"
)
RUN = ProvedRun(16.4, How.FINISHED, "0.2.0", "7f3a91c2" * 8)
SQUARE = SharedProject(Project("Square 2", BLOCKTEXT, robot="sim-ev3", world="line"), 4, RUN)
TEAM = Project(
    "sumo", BLOCKTEXT, world="ring", first="a", others=(ProjectPart("b", BLOCKTEXT, count=3),)
)
ADDRESS = "http://127.0.0.1:8421/#share="


@pytest.fixture(autouse=True)
def at_home(tmp_path, monkeypatch):
    """A folder without anything of the user's."""
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))


def linked(content, version=1):
    """A link with any content."""
    data = content if isinstance(content, bytes) else json.dumps(content).encode()
    packer = zlib.compressobj(9, wbits=-15)
    packed = packer.compress(data) + packer.flush()
    return f"{ADDRESS}{version}.{urlsafe_b64encode(packed).rstrip(b'=').decode()}"


@pytest.mark.parametrize(
    "shared",
    [SQUARE, SharedProject(TEAM), SharedProject(project_of("hand.py", PYTHON))],
    ids=["one robot", "several robots", "Python by hand"],
)
def test_a_link_holds_programs_robots_world_variant_and_run(shared):
    assert read_link(ADDRESS + link_of(shared)) == shared


@pytest.mark.parametrize(
    "text", ["{link}", "{address}{link}", "  {address}\n{link}\n", "See ({address}{link})!"]
)
def test_it_is_read_with_any_address_or_none_and_with_line_breaks(text):
    link = link_of(SQUARE)
    assert read_link(text.format(address=ADDRESS, link=link)) == SQUARE
    assert share_link.bare(text.format(address=ADDRESS, link=link)) == link


def test_the_python_of_its_author_is_all_that_a_link_holds_of_a_program():
    by_hand = project_of("hand.py", PYTHON * 1)
    texts = Project("hand", by_hand.blocktext, robot=by_hand.robot)
    assert len(link_of(SharedProject(by_hand))) < len(link_of(SharedProject(texts))) + len(PYTHON)


def test_places_of_blocks_and_breakpoints_stay_at_home():
    shown = Project("a", BLOCKTEXT, world="line", breakpoints=("x",), shown="first-steps")
    assert read_link(link_of(SharedProject(shown))).project == Project("a", BLOCKTEXT, world="line")


def test_an_own_world_comes_along_if_it_fits():
    worlds.install(PackedWorld("room", ROOM))
    shared = read_link(link_of(SharedProject(Project("a", BLOCKTEXT, world="room"))))
    carried = shared.project.carried
    assert carried.world is not None
    assert "\n".join(carried.world.file) == ROOM
    assert carried.home == ""


def test_a_project_too_large_for_a_link_is_refused():
    chance = random.Random(5)  # noqa: S311
    words = " ".join(str(chance.getrandbits(64)) for _ in range(1000))
    with pytest.raises(LinkError, match="Share the file instead"):
        link_of(SharedProject(Project("a", f"# {words}\n{BLOCKTEXT}")))


PROJECT = {"learnblock": 1, "blocktext": ["main:", "    pass", "end"]}


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "isn't a LearnBlock link"),
        ("https://example.org/#project=a", "isn't a LearnBlock link"),
        (ADDRESS + "1.", "isn't a LearnBlock link"),
        (ADDRESS + "1." + "x" * 3 * LONGEST_LINK, "too long"),
        (linked({"name": "a", "project": PROJECT}, 2), "newer LearnBlock"),
        (linked(b"\xff\xfe"), "damaged"),
        (linked(b"[" * 100_000), "damaged"),
        (linked({"name": "a"}), "damaged"),
        (linked({"name": "a", "project": PROJECT, "more": 1}), "damaged"),
        (linked({"name": "a", "project": PROJECT, "variant": -1}), "damaged"),
        (linked({"name": "a", "project": PROJECT, "run": [1, "finished", "1"]}), "damaged"),
        (linked({"name": "a", "project": PROJECT, "run": [1, "vanished", "1"]}), "damaged"),
        (linked({"name": "../a", "project": PROJECT}), "can't be called"),
        (linked({"name": "CON", "project": PROJECT}), "Windows reserves"),
        (linked({"name": "a", "project": {**PROJECT, "world": "../x"}}), "can only name a world"),
        (linked({"name": "a", "project": {**PROJECT, "python": ["x" * 250_001]}}), "too long"),
        (linked(b" " * (LARGEST_INFLATED + 1)), "too long"),
        (linked(b" " * 1_000_000_0), "too long"),
    ],
)
def test_what_is_no_link_of_ours_is_refused(text, reason):
    with pytest.raises(LearnBlockError, match=reason):
        read_link(text)


def test_a_link_that_was_cut_off_is_refused_wherever_it_was_cut():
    link = link_of(SQUARE)
    for end in range(2, len(link)):
        with pytest.raises(LearnBlockError):
            read_link(link[:end])


def test_deep_json_inside_is_refused():
    deep = (
        b'{"name":"a","project":{"learnblock":1,"blocktext":[],"workspace":'
        + b'{"stacks":[[' * 20_000
    )
    with pytest.raises(LearnBlockError):
        read_link(linked(deep))


def test_the_name_is_read_without_the_project():
    assert linked_name(ADDRESS + link_of(SQUARE)) == "Square 2"
    unreadable = linked({"name": "Square", "project": "none"})
    assert linked_name(unreadable) == "Square"
    with pytest.raises(LearnBlockError):
        read_link(unreadable)
    with pytest.raises(LearnBlockError):
        linked_name(linked({"name": "a/b", "project": {}}))


def test_changed_links_and_changed_contents_raise_only_our_errors():
    chance = random.Random(11)  # noqa: S311
    link = link_of(SQUARE)
    packed = share_link._bytes(link.split(".")[1])
    content = share_link._inflated(packed).decode()
    corpus = (link, content, *map(str, range(3)))
    for _ in range(400):
        for text in (
            ADDRESS + mutated(link, corpus, chance),
            linked(mutated(content, corpus, chance).encode("utf-8", "replace")),
        ):
            for read in (linked_name, read_link):
                with suppress(LearnBlockError):
                    read(text)
