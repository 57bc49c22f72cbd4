"""Changes are saved soon and once, or at once on demand."""

import asyncio

from learnblock.server.sessions.saver import Saver


def saves(story, delay=0.0):
    """Counts how often a saver writes."""
    written = []

    async def write():
        written.append(True)

    async def play():
        saver = Saver(write, delay)
        await story(saver, written)

    asyncio.run(play())
    return len(written)


def test_changes_of_a_moment_are_written_together():
    async def story(saver, written):
        saver.changed()
        saver.changed()
        while not written:
            await asyncio.sleep(0)
        await saver.flush()

    assert saves(story) == 1


def test_what_is_not_written_yet_is_written_at_once_when_asked():
    async def story(saver, _):
        saver.changed()
        await saver.flush()

    assert saves(story, delay=3600) == 1


def test_what_has_not_changed_is_not_written():
    async def story(saver, _):
        await saver.flush()

    assert saves(story) == 0


def test_a_change_while_it_is_written_is_written_again():
    written = []

    async def play():
        async def write():
            if not written:
                saver.changed()
            written.append(True)

        saver = Saver(write, 0)
        saver.changed()
        while len(written) < 2:
            await asyncio.sleep(0)

    asyncio.run(play())
    assert len(written) == 2
