"""The client's side of a component."""

import re
from typing import Any, Self

from learnblock.closing import Closing
from learnblock.errors import IceEncodingError, IceRefusedError
from learnblock.ice.encoding import Writer
from learnblock.ice.endpoint import Endpoint
from learnblock.ice.interface import Interface, Mode, Operation, read_all, write_all
from learnblock.ice.messages import open_reply, request_opening

_TEXT = re.compile(r"(?P<identity>\S+?)\s*:\s*tcp(?=\s)(?P<options>(?:\s+-\w\s+\S+)*)\s*")


class Proxy(Closing):
    """Calls the operations of a component's object.

        base = Proxy.parse("differentialrobot:tcp -h 192.168.16.1 -p 10004", interface)
        base.call("setSpeedBase", 100.0, 0.5)

    Args:
        interface: the object's interface.
        identity: the object's name.
        endpoint: the component's address.
    """

    def __init__(self, interface: Interface, identity: str, endpoint: Endpoint) -> None:
        self.interface = interface
        self.identity = identity
        self.endpoint = endpoint
        self._prepared: dict[str, tuple[Operation, bytes]] = {}

    @classmethod
    def parse(cls, text: str, interface: Interface, timeout: float = 5.0) -> Self:
        """The proxy that Ice writes as ``identity:tcp -h HOST -p PORT``.

        Args:
            text: the text of the proxy.
            interface: the object's interface.
            timeout: limit of a call in seconds.

        Raises:
            IceEncodingError: the text is not such a proxy.
        """
        match = _TEXT.fullmatch(text)
        options = dict(re.findall(r"-(\w)\s+(\S+)", match["options"])) if match else {}
        port = options.get("p", "")
        if match is None or not port.isdecimal() or not 0 < int(port) < 65536:
            raise IceEncodingError("ice-bad-proxy", text=text)
        endpoint = Endpoint(options.get("h", "localhost"), int(port), timeout)
        return cls(interface, match["identity"], endpoint)

    def __repr__(self) -> str:
        return f"<Proxy {self.identity}:tcp -h {self.endpoint.host} -p {self.endpoint.port}>"

    def call(self, name: str, *values: Any) -> Any:
        """Call an operation.

        Args:
            name: the operation's name.
            values: its parameters.

        Returns:
            None, the single result, or a tuple of the out parameters and the return value.

        Raises:
            IceRefusedError: the component refuses the call.
            IceLinkError: the component cannot be reached, does not answer, or sends invalid data.
            IceEncodingError: the parameters or the results have the wrong types.
        """
        operation, opening = self._prepared.get(name) or self._prepare(name)
        writer = Writer()
        write_all(writer, operation.takes, values)
        again = operation.mode is not Mode.NORMAL
        reply = self.endpoint.call(opening, writer.encapsulated(), again=again)
        results = read_all(open_reply(reply), operation.gives)
        return results if len(results) > 1 else next(iter(results), None)

    def ping(self) -> None:
        """Check that the object exists.

        Raises:
            IceError: it does not exist.
        """
        self.call("ice_ping")

    def is_a(self, type_id: str) -> bool:
        """Whether the object offers an interface."""
        return bool(self.call("ice_isA", type_id))

    def ids(self) -> tuple[str, ...]:
        """The names of all interfaces that the object offers."""
        return tuple(self.call("ice_ids"))

    def check(self) -> None:
        """Check that the object offers the proxy's interface.

        Raises:
            IceRefusedError: it has another interface.
            IceLinkError: the component cannot be reached.
        """
        type_id = self.interface.type_id
        if not self.is_a(type_id):
            raise IceRefusedError("ice-wrong-interface", "wrong interface", interface=type_id)

    def close(self) -> None:
        """Close the connection; calling it twice is harmless."""
        self.endpoint.close()

    def _prepare(self, name: str) -> tuple[Operation, bytes]:
        try:
            operation = self.interface.operation(name)
        except KeyError:
            raise IceRefusedError(
                "ice-no-operation",
                "OperationNotExistException",
                interface=self.interface.type_id,
                operation=name,
            ) from None
        opening = request_opening(self.identity, name, operation.mode)
        self._prepared[name] = operation, opening
        return self._prepared[name]
