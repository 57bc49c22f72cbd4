"""The handlers of a subject, by the kind of message that each handles."""

import inspect
from collections.abc import Awaitable, Callable
from typing import TypeVar

from learnblock.server import messages

Handler = Callable[..., Awaitable[None]]
H = TypeVar("H", bound=Handler)


class Handlers(dict[type[messages.FromPage], Handler]):
    """Handlers by kind of message.

    Example:
        HANDLERS = Handlers()

        @HANDLERS.add
        async def _stop(page: Page, message: messages.Stop) -> None: ...
    """

    def add(self, handler: H) -> H:
        """Add a function that handles the kind of its second parameter."""
        _, message = inspect.signature(handler).parameters.values()
        self[message.annotation] = handler
        return handler
