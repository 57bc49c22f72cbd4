"""Tries to join are counted by child and by address, however a name is spelled."""

import asyncio

import pytest

from clocks import Clock
from learnblock.classroom import messages as ours
from learnblock.classroom.entrance import Entrance
from learnblock.classroom.limits import WRONG_BY_ADDRESS
from learnblock.classroom.roster import Roster
from learnblock.errors import LearnBlockError

WRONG = ("apple", "apple", "apple", "apple")


@pytest.fixture
def clock():
    return Clock(100.0)


@pytest.fixture
def entrance(tmp_path, clock):
    return Entrance(Roster(tmp_path, "7b"), clock)


async def joined(entrance, name, pictures=None, address="10.0.0.1", *, is_first_name=False):
    """Join; return how it ended."""
    message = ours.Join(entrance.roster.word, name, pictures, is_first_name)
    try:
        await entrance.join(message, address)
    except LearnBlockError as error:
        return error.phrase.code
    return "joined"


def all_joined(entrance, tries):
    async def run():
        return [await joined(entrance, *one) for one in tries]

    return asyncio.run(run())


def test_spellings_of_a_name_share_its_tries(entrance):
    spellings = ("Leo", "Lèo", "Lëo", "Lēò", "LEO", " leo ", "Ｌeo", "Le\u200do")
    codes = all_joined(entrance, [(name, WRONG, f"10.0.0.{i}") for i, name in enumerate(spellings)])
    assert codes == ["class-wrong-pictures"] * 6 + ["class-wait"] * 2


def test_new_pupils_of_one_address_come_slowly(entrance, clock):
    codes = all_joined(entrance, [(f"{'abcdefgh'[i]}na",) for i in range(8)])
    assert codes == ["joined"] * 5 + ["class-join-wait"] * 3
    assert all_joined(entrance, [("Leo", None, "10.0.0.2")]) == ["joined"]
    clock.time += 10
    assert all_joined(entrance, [("Mia",), ("Noa",)]) == ["joined", "class-join-wait"]


def test_a_name_that_is_refused_takes_nothing_from_the_others(entrance):
    refused = [("Ana\u202e",)] * 8
    assert all_joined(entrance, [*refused, ("Ana",)])[-1] == "joined"


def test_one_address_with_many_tries_at_once_is_refused_some(entrance):
    async def run():
        many = (joined(entrance, f"{'abcdefghij'[i]}na", WRONG) for i in range(10))
        return await asyncio.gather(*many, joined(entrance, "Leo", None, "10.0.0.2"))

    *codes, other = asyncio.run(run())
    assert codes.count("class-join-wait") == 5
    assert other == "joined"


@pytest.mark.parametrize("name", ["Ana García", "José Luis", "Юля Иванова"])
def test_a_new_pupil_confirms_that_several_words_are_a_first_name(entrance, name):
    assert asyncio.run(joined(entrance, name)) == "class-only-first-name"
    assert entrance.roster.pupils == ()
    assert asyncio.run(joined(entrance, name, is_first_name=True)) == "joined"


@pytest.mark.parametrize("name", ["Ana", "Ana G.", "Leo 2", "Anne-Marie", "O’Neil"])
def test_a_letter_of_a_surname_needs_no_confirmation(entrance, name):
    assert asyncio.run(joined(entrance, name)) == "joined"


def test_a_pupil_who_has_been_here_is_not_asked(entrance):
    asyncio.run(joined(entrance, "José Luis", is_first_name=True))
    assert asyncio.run(joined(entrance, "José Luis", WRONG)) == "class-wrong-pictures"


def test_a_wrong_word_counts_wherever_it_is_tried(entrance):
    for _ in range(WRONG_BY_ADDRESS[0] + 1):
        with pytest.raises(LearnBlockError, match="That is not the join word"):
            entrance.require_word("banana 11", "10.0.0.1")
    assert asyncio.run(joined(entrance, "Ana")) == "class-wait"
