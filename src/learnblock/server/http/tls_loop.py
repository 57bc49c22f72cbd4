"""An event loop that does not wait long for TLS handshakes."""

import asyncio
from typing import Any

from learnblock.server.http.requests import PATIENCE


class TlsLoop(asyncio.SelectorEventLoop):
    """Gives a browser as long for its handshake as for a request; asyncio gives it a minute."""

    async def create_server(self, *args: Any, **options: Any) -> asyncio.Server:
        """As in asyncio."""
        if options.get("ssl"):
            options = {"ssl_handshake_timeout": PATIENCE, **options}
        return await super().create_server(*args, **options)
