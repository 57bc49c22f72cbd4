"""Changes are saved soon and once, or at once on demand."""

import asyncio

from learnblock.server.sessions.archive import Saver
from learnblock.server.sessions.periods import Periods


def saves(story, delay=0.0):
    """Counts how often a saver writes."""
    written = []

    async def write():
        written.append(True)
        return True

    async def play():
        saver = Saver(write, Periods(save=delay))
        await story(saver, written)

    asyncio.run(play())
    return len(written)


def test_changes_in_quick_succession_are_written_together():
    async def story(saver, written):
        saver.changed()
        saver.changed()
        while not written:
            await asyncio.sleep(0)
        await saver.flush()

    assert saves(story) == 1


def test_unsaved_changes_are_written_at_once_on_request():
    async def story(saver, _):
        saver.changed()
        await saver.flush()

    assert saves(story, delay=3600) == 1


def test_without_changes_nothing_is_written():
    async def story(saver, _):
        await saver.flush()

    assert saves(story) == 0


def test_a_change_during_a_save_is_saved_afterwards():
    written = []

    async def play():
        async def write():
            if not written:
                saver.changed()
            written.append(True)
            return True

        saver = Saver(write, Periods(save=0))
        saver.changed()
        while len(written) < 2:
            await asyncio.sleep(0)

    asyncio.run(play())
    assert len(written) == 2


def test_a_save_that_fails_is_repeated_until_it_succeeds():
    attempts = []

    async def play():
        async def write():
            attempts.append(True)
            return len(attempts) == 4

        saver = Saver(write, Periods(save=0, retry=0))
        saver.changed()
        while len(attempts) < 4:
            await asyncio.sleep(0)
        await saver.flush()

    asyncio.run(play())
    assert len(attempts) == 4


def test_what_could_not_be_saved_is_tried_once_more_at_the_end():
    attempts = []

    async def play():
        async def write():
            attempts.append(True)
            return len(attempts) > 1

        saver = Saver(write, Periods(save=0, retry=3600))
        saver.changed()
        while not attempts:
            await asyncio.sleep(0)
        await saver.flush()
        await saver.flush()

    asyncio.run(play())
    assert len(attempts) == 2
