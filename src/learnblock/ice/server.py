"""The component's side: objects that answer calls."""

import asyncio
import threading
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from learnblock.closing import Closing
from learnblock.errors import IceEncodingError, IceRefusedError
from learnblock.ice.encoding import Writer
from learnblock.ice.interface import OBJECT, Interface, Mode, Operation, read_all, write_all
from learnblock.ice.messages import (
    HEADER,
    MessageKind,
    Request,
    Status,
    failure,
    message,
    not_there,
    read_header,
    read_request,
    refusal,
    reply,
)

_OF_EVERY_OBJECT = frozenset(operation.name for operation in OBJECT)


@dataclass(frozen=True, slots=True)
class Servant:
    """An object that answers calls.

    Args:
        interface: its interface.
        implementation: has a method for each supported operation, which takes the parameters and
            returns the results. It may raise an IceRefusedError whose ``kind`` is one of the
            operation's user exceptions.
    """

    interface: Interface
    implementation: object


class Adapter(Closing):
    """Listens for calls and lets servants answer them, one after the other in one thread.

    It is a context manager and listens until the end of its block.

    Args:
        host: the local address on which it listens.
    """

    def __init__(self, host: str = "127.0.0.1") -> None:
        self.host = host
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, name="ice", daemon=True)
        self._servers: list[asyncio.Server] = []
        self._clients: dict[asyncio.Task[None], asyncio.StreamWriter] = {}
        self._thread.start()

    def serve(self, servants: Mapping[str, Servant], port: int = 0) -> int:
        """Listen on another port.

        Args:
            servants: the servants by identity.
            port: 0 for any free port.

        Returns:
            The port.

        Raises:
            OSError: the port is not available.
        """
        opening = self._open(servants, port)
        return asyncio.run_coroutine_threadsafe(opening, self._loop).result()

    def close(self) -> None:
        """Disconnect all clients and stop listening; calling it twice is harmless."""
        if self._loop.is_closed():
            return
        asyncio.run_coroutine_threadsafe(self._close(), self._loop).result()
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    async def _open(self, servants: Mapping[str, Servant], port: int) -> int:
        async def join(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            await self._attend(servants, reader, writer)

        server = await asyncio.start_server(join, self.host, port)
        self._servers.append(server)
        listening: int = server.sockets[0].getsockname()[1]
        return listening

    async def _close(self) -> None:
        for server in self._servers:
            server.close()
        for writer in self._clients.values():
            writer.write(message(MessageKind.CLOSE))
            # Not `close`, which would wait for a client that does not read.
            writer.transport.abort()
        await asyncio.gather(*self._clients)

    async def _attend(
        self,
        servants: Mapping[str, Servant],
        reader: asyncio.StreamReader,
        writer: asyncio.StreamWriter,
    ) -> None:
        task = asyncio.current_task()
        assert task is not None  # noqa: S101 - a coroutine that runs has one
        self._clients[task] = writer
        try:
            writer.write(message(MessageKind.VALIDATE))
            await _answer_all(servants, reader, writer)
        except (OSError, asyncio.IncompleteReadError):
            # The client is gone or sent invalid data: there is nothing to answer.
            pass
        finally:
            writer.close()
            del self._clients[task]


async def _answer_all(
    servants: Mapping[str, Servant], reader: asyncio.StreamReader, writer: asyncio.StreamWriter
) -> None:
    while True:
        kind, size = read_header(await reader.readexactly(HEADER.size))
        body = await reader.readexactly(size)
        if kind is MessageKind.CLOSE:
            return
        if kind is not MessageKind.REQUEST:
            continue
        request = read_request(body)
        answer = _answer(servants, request)
        if request.number:
            writer.write(answer)
            await writer.drain()


def _answer(servants: Mapping[str, Servant], request: Request) -> bytes:
    """The answer to any request, including an invalid one."""
    servant = servants.get(request.identity)
    if servant is None:
        return not_there(request, Status.NO_OBJECT)
    if request.facet:
        return not_there(request, Status.NO_FACET)
    try:
        operation = servant.interface.operation(request.operation)
        method = _method(servant, operation)
    except (KeyError, AttributeError):
        return not_there(request, Status.NO_OPERATION)
    return _outcome(request, operation, method)


def _outcome(request: Request, operation: Operation, method: Any) -> bytes:
    try:
        return _performed(request, operation, method)
    except IceRefusedError as refused:
        return _refused(request, operation, refused)
    except IceEncodingError as error:
        return failure(request, Status.UNKNOWN_LOCAL, f"MarshalException: {error}")
    except Exception as error:  # noqa: BLE001 - a servant may raise any error
        return failure(request, Status.UNKNOWN, f"{type(error).__name__}: {error}")


def _performed(request: Request, operation: Operation, method: Any) -> bytes:
    if operation.name not in _OF_EVERY_OBJECT:
        _check_mode(request, operation)
    answer = method(*read_all(request.parameters, operation.takes))
    gives = Writer(request.parameters.version)
    if not operation.gives:
        answer = ()
    elif len(operation.gives) == 1:
        answer = (answer,)
    write_all(gives, operation.gives, answer)
    return reply(request, gives)


def _check_mode(request: Request, operation: Operation) -> None:
    of_old = operation.mode is Mode.IDEMPOTENT and request.mode == Mode.NONMUTATING
    if request.mode != operation.mode and not of_old:
        raise IceEncodingError("ice-bad-value", value=str(request.mode), type="operation mode")


def _refused(request: Request, operation: Operation, refused: IceRefusedError) -> bytes:
    for allowed in operation.refuses:
        if allowed.type_id == refused.kind:
            return refusal(request, allowed, str(refused))
    return failure(request, Status.UNKNOWN_USER, f"{refused.kind}: {refused}")


def _method(servant: Servant, operation: Operation) -> Any:
    if operation.name not in _OF_EVERY_OBJECT:
        return getattr(servant.implementation, operation.name)
    type_ids = servant.interface.type_ids
    return {
        "ice_ping": lambda: None,
        "ice_isA": lambda type_id: type_id in type_ids,
        "ice_id": lambda: servant.interface.type_id,
        "ice_ids": lambda: type_ids,
    }[operation.name]
