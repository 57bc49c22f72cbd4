"""Whatever a wall or a pupil's server sends about hand-ins is done, or refused in words."""

import asyncio
from contextlib import suppress
from types import SimpleNamespace
from typing import get_args

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.classroom import hand_in_messages as ours
from learnblock.classroom.hand_ins import HandInShelf
from learnblock.classroom.marking import Marking
from learnblock.classroom.messages import FromTeacher
from learnblock.classroom.roster import Roster
from learnblock.classroom.teaching import do
from learnblock.errors import LearnBlockError
from learnblock.server.messages import GivenProgram, GivenWork, WorkGiven

LESSON, STEP = "1-03-square", 4
KINDS = [
    kind
    for kind in get_args(ours.FromHandInPages)
    # These start and stop a process.
    if kind not in (ours.CheckHandIns, ours.EndChecking)
]
_from_teacher = msgspec.json.Decoder(FromTeacher)
_given = msgspec.json.Decoder(WorkGiven)
TEXTS = st.text(st.characters(codec="utf-8"), max_size=30)
LESSONS = st.sampled_from([LESSON, "1-01-first-drive", "no lesson", "CON", "../x", "é" * 80, ""])
VALUES = st.one_of(st.none(), st.integers(-1, 40), TEXTS, st.lists(TEXTS, max_size=3))


@pytest.fixture(scope="module")
def room(tmp_path_factory):
    """A class of which Ana has handed in."""
    folder = tmp_path_factory.mktemp("7b")
    roster, shelf = Roster(folder, "7b"), HandInShelf(folder)
    ana, _ = roster.add("Ana")
    shelf.add(ana.id, GivenWork(LESSON, STEP, GivenProgram("main:\nend\n")))

    def known(id):  # noqa: A002 - as in `Room`
        if id != ana.id:
            raise LearnBlockError("class-no-pupil")
        return ana

    async def gather(lesson, step):
        """Ask no server: the pupils' folders are here."""

    desk = SimpleNamespace(tell_hand_ins=lambda: None)
    return SimpleNamespace(
        roster=roster,
        hand_ins=shelf,
        marking=Marking(roster, shelf, lambda: None),
        known=known,
        desk=lambda _: desk,
        desks={},
        gather=gather,
        changed=lambda: None,
        ana=ana.id,
    )


@given(data=st.data())
def test_a_message_about_hand_ins_is_done_or_refused_in_words(room, data):
    fields = {
        "kind": data.draw(st.sampled_from([kind.__name__ for kind in KINDS])),
        "lesson": data.draw(LESSONS | VALUES),
        "step": data.draw(st.integers(1, 30) | VALUES),
        "pupil": data.draw(st.just(room.ana) | VALUES),
        "pupils": data.draw(st.just([room.ana]) | VALUES),
        "note": data.draw(TEXTS | VALUES),
        "mark": data.draw(TEXTS | VALUES),
        "line": data.draw(st.fixed_dictionaries({"number": VALUES, "text": TEXTS}) | VALUES),
    }
    with suppress(LearnBlockError, OSError, ValueError):
        asyncio.run(do(room, _from_teacher.decode(msgspec.json.encode(fields))))
    assert HandInShelf(room.roster.folder).read(room.ana, LESSON, STEP)


@given(work=st.dictionaries(st.sampled_from(["lesson", "step", "program", "tries"]), VALUES))
def test_what_a_pupils_server_gives_is_kept_inside_its_folder_or_refused(room, work):
    with suppress(LearnBlockError, OSError, ValueError):
        given_work = _given.decode(msgspec.json.encode({"kind": "WorkGiven", "work": work})).work
        room.hand_ins.add(room.ana, given_work)
    files = {file.parent for file in room.roster.folder.rglob("*.json")}
    assert files <= {room.roster.folder, room.hand_ins.folder_of(room.ana)}


@given(lesson=LESSONS | TEXTS, step=st.integers())
def test_a_hand_in_of_any_lesson_stays_in_its_folder_and_is_listed(room, lesson, step):
    work = {"lesson": lesson, "step": step, "program": {"text": "main:\nend\n"}}
    try:
        given_work = _given.decode(msgspec.json.encode({"kind": "WorkGiven", "work": work})).work
        room.hand_ins.add(room.ana, given_work)
    except (LearnBlockError, OSError, ValueError):
        return
    assert room.hand_ins.path_of(room.ana, lesson, step).parent == room.hand_ins.folder_of(room.ana)
    assert room.marking.steps(()).steps


def test_python_that_can_be_blocks_is_shown_as_blocks_and_other_as_it_is(room):
    for text, is_python, has_blocks in (
        ("main:\n    pass\nend\n", False, True),
        ("main: what", False, False),
        ("import learnblock\n", True, None),
        ("def (", True, False),
    ):
        room.hand_ins.add(room.ana, GivenWork(LESSON, STEP, GivenProgram(text, is_python)))
        shown = room.marking.shown(room.ana, LESSON, STEP)
        assert shown.program.text == text
        assert has_blocks is None or bool(shown.blocks) == has_blocks
