"""The event loop of drivers: its limits, its errors and its end, also against an asyncio server."""

import asyncio
import gc
import threading
from contextlib import asynccontextmanager, suppress

import pytest

from learnblock.errors import RobotConnectionError
from learnblock.robots.event_loop import LEAVING, EventLoop
from learnblock.testing import ManualClock
from waiting import wait_for


class LibraryError(Exception):
    """The own error of a library for robots."""


@pytest.fixture
def clock():
    return ManualClock()


@pytest.fixture
def loop(clock):
    with EventLoop("there", clock, (LibraryError,)) as loop:
        yield loop


@pytest.fixture
def counterpart():
    """A robot that answers each byte by the next one; 255 makes it hang up."""

    async def answer(reader, writer):
        while (byte := await reader.read(1)) and byte != b"\xff":
            writer.write(bytes([byte[0] + 1]))
        writer.close()

    ended = []

    async def serve(began):
        async with await asyncio.start_server(answer, "127.0.0.1", 0) as server:
            began(server.sockets[0].getsockname()[1])
            ended.append((asyncio.get_running_loop(), stop := asyncio.Event()))
            await stop.wait()

    ports = []
    thread = threading.Thread(target=lambda: asyncio.run(serve(ports.append)))
    thread.start()
    wait_for(lambda: ended, "the robot")
    yield ports[0]
    [(running, stop)] = ended
    running.call_soon_threadsafe(stop.set)
    thread.join()


async def forever(notes=None):
    try:
        await asyncio.Event().wait()
    finally:
        if notes is not None:
            notes.append("cancelled")


async def fail(error):
    raise error


def begun(call):
    """Begin a call in a thread of its own; return the thread and its results."""
    results = []

    def work():
        try:
            results.append(call())
        except RobotConnectionError as error:
            results.append(error.phrase.code)

    thread = threading.Thread(target=work)
    thread.start()
    return thread, results


def test_a_robot_at_the_other_end_of_a_stream_answers(counterpart):
    @asynccontextmanager
    async def streams():
        reader, writer = await asyncio.open_connection("127.0.0.1", counterpart)
        yield reader, writer
        writer.close()
        await writer.wait_closed()

    async def ask(number):
        writer.write(bytes([number]))
        return await reader.readexactly(1)

    with EventLoop("127.0.0.1") as loop:
        reader, writer = loop.enter(streams(), seconds=10)
        assert [loop.run(ask(number), seconds=10) for number in (1, 7)] == [b"\2", b"\b"]
        with pytest.raises(RobotConnectionError, match=r"127\.0\.0\.1 was lost"):
            loop.run(ask(255), seconds=10)


def test_notifications_reach_a_callback_until_it_is_closed(counterpart):
    noted, is_lost = [], asyncio.Event()

    class Notifications(asyncio.Protocol):
        def connection_made(self, transport):
            transport.write(b"\1\3")

        def data_received(self, data):
            noted.extend(data)

        def connection_lost(self, error):
            noted.append("lost")
            is_lost.set()

    @asynccontextmanager
    async def connection():
        running = asyncio.get_running_loop()
        transport, _ = await running.create_connection(Notifications, "127.0.0.1", counterpart)
        yield transport
        transport.close()
        await is_lost.wait()

    with EventLoop("127.0.0.1") as loop:
        loop.enter(connection(), seconds=10)
        wait_for(lambda: len(noted) == 2, "notifications")
    assert noted == [2, 4, "lost"]


def test_a_coroutine_that_takes_too_long_is_cancelled_at_its_limit(loop, clock):
    notes = []
    with pytest.raises(RobotConnectionError, match="there stopped answering"):
        clock.run(lambda: loop.run(forever(notes), seconds=2))
    assert clock.now() == 2
    wait_for(lambda: notes, "its end")
    assert notes == ["cancelled"]


def test_what_a_coroutine_waits_for_passes_by_the_drivers_clock(loop, clock):
    assert clock.run(lambda: loop.run(asyncio.sleep(1.5, "done"), seconds=2)) == "done"
    assert clock.now() == 1.5


def test_a_coroutine_in_the_background_repeats_at_exactly_its_moments(loop, clock):
    moments = []

    async def repeat():
        while True:
            await asyncio.sleep(0.2)
            moments.append(clock.now())

    loop.start(repeat())
    clock.run(lambda: loop.run(asyncio.sleep(0), seconds=1))
    clock.block_until(1)
    clock.advance(0.7)
    assert moments == [0.2, 0.4, 0.6]


@pytest.mark.parametrize(
    ("error", "message"),
    [
        (LibraryError("no link"), r"there was lost \(no link\)"),
        (ConnectionResetError(), r"there was lost \(ConnectionResetError\)"),
        (EOFError("the end"), r"there was lost \(the end\)"),
        (TimeoutError(), "there stopped answering"),
    ],
)
def test_the_first_failure_ends_the_link(loop, error, message):
    with pytest.raises(RobotConnectionError, match=message):
        loop.run(fail(error), seconds=9)
    with pytest.raises(RobotConnectionError, match=message):
        loop.check()
    with pytest.raises(RobotConnectionError, match=message):
        loop.run(fail(LibraryError("another")), seconds=9)


def test_a_failure_cancels_what_other_threads_wait_for(loop):
    thread, results = begun(lambda: loop.run(forever(), seconds=9))
    with pytest.raises(RobotConnectionError):
        loop.run(fail(LibraryError("no link")), seconds=9)
    thread.join()
    assert results == ["robot-link-broke"]


@pytest.mark.parametrize("error", [ValueError("a bug"), RobotConnectionError("ev3-garbled")])
def test_any_other_error_is_raised_as_it_is_and_the_link_stays(loop, error):
    with pytest.raises(type(error)) as raised:
        loop.run(fail(error), seconds=9)
    assert raised.value is error
    loop.check()


@pytest.mark.parametrize("error", [ValueError("a bug"), LibraryError("no link")])
def test_an_error_in_the_background_is_raised_by_the_next_check(loop, error):
    loop.start(fail(error))
    with pytest.raises((ValueError, RobotConnectionError), match=str(error)):
        wait_for(loop.check, "its error")


def test_an_error_of_a_callback_is_raised_by_the_next_check(loop):
    async def notify():
        asyncio.get_running_loop().call_soon({}.pop, "distance")

    loop.run(notify(), seconds=9)
    with pytest.raises(KeyError, match="distance"):
        wait_for(loop.check, "its error")


def test_closing_cancels_what_runs_and_refuses_what_comes(loop):
    notes = []
    loop.start(forever(notes))
    thread, results = begun(lambda: loop.run(forever(notes), seconds=9))
    loop.run(asyncio.sleep(0), seconds=9)
    loop.close()
    thread.join()
    assert results == ["robot-link-closed"]
    with pytest.raises(RobotConnectionError, match="there is closed"):
        loop.run(forever(notes), seconds=9)
    assert set(notes) <= {"cancelled"}


@pytest.mark.parametrize("is_lost", [False, True])
def test_closing_leaves_what_was_entered_even_if_the_link_is_lost(loop, is_lost):
    notes = []

    @asynccontextmanager
    async def connection():
        notes.append("connected")
        yield "robot"
        notes.append("disconnected")

    assert loop.enter(connection(), seconds=9) == "robot"
    if is_lost:
        with pytest.raises(RobotConnectionError):
            loop.run(fail(LibraryError("no link")), seconds=9)
    loop.close()
    loop.close()
    assert notes == ["connected", "disconnected"]


def test_a_coroutine_that_resists_holds_up_closing_for_a_second(loop, clock):
    begun = threading.Event()

    async def resist():
        begun.set()
        while True:
            with suppress(asyncio.CancelledError):
                await forever()

    loop.start(resist())
    assert begun.wait(10)
    gc.collect()
    began = clock.now()
    clock.run(loop.close)
    assert clock.now() - began == LEAVING


def test_its_thread_ends_with_it(loop):
    loop.close()
    assert "event loop" not in [thread.name for thread in threading.enumerate()]


def test_a_callback_may_close_it(loop):
    async def close():
        loop.close()

    loop.start(close())
    wait_for(lambda: not loop._thread.is_alive(), "its end")


def test_a_callback_that_waits_is_refused(loop):
    async def wait():
        loop.run(forever(), seconds=1)

    with pytest.raises(RuntimeError, match="A callback can't wait"):
        loop.run(wait(), seconds=9)


def test_a_callback_that_blocks_the_loop_does_not_hold_up_the_program_forever():
    released = threading.Event()

    async def block():
        released.wait()

    with EventLoop("there") as loop:
        with pytest.raises(RobotConnectionError, match="stopped answering"):
            loop.run(block(), seconds=0.01)
        released.set()


def test_a_coroutine_is_cancelled_if_its_thread_is_interrupted():
    class InterruptedClock(ManualClock):
        def wait(self, event, seconds):
            if threading.current_thread() is threading.main_thread() and not interrupted:
                interrupted.append(True)
                raise KeyboardInterrupt
            return super().wait(event, seconds)

    notes, interrupted = [], []
    with EventLoop("there", InterruptedClock()) as loop:
        with pytest.raises(KeyboardInterrupt):
            loop.run(forever(notes), seconds=9)
        wait_for(lambda: notes, "its end")
    assert notes == ["cancelled"]
