"""Protection of the server from unauthorized requests.

The server runs programs on the user's computer, and any web page in the user's browser can send
requests to 127.0.0.1. Three checks keep them out: a random token that is only in the opened
address; the Host header, against names made to point to this computer (DNS rebinding); and
the Origin header, against pages from other servers.

A proxy that logs users in, as under JupyterHub, can send the token for them. Then it alone knows
the token, and the page needs none.
"""

import hmac
import ipaddress
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from http import HTTPStatus
from urllib.parse import urlsplit

from starlette.datastructures import MutableHeaders
from starlette.requests import ClientDisconnect, HTTPConnection
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from learnblock.i18n import Phrase

#: Names by which the computer refers to itself.
LOCAL_HOSTS = ("127.0.0.1", "localhost", "::1")
#: In the address of a websocket: a class asks for what its wall shows of the page.
SEAT = "seat"
SUBPROTOCOL = "learnblock"
COOKIE = "learnblock_token"
#: Nothing is fetched from other servers. Blockly and CodeMirror insert their styles as elements.
_CONTENT = (
    "default-src 'self'; script-src 'self'; style-src 'self' 'unsafe-inline';"
    " img-src 'self' blob: data:; media-src 'self' blob: data:; font-src 'self' data:;"
    " object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'self'"
)
#: What proxies add to requests.
_PASSED_ON = {"forwarded", "via", "x-forwarded-for", "x-real-ip"}
_HEADERS = {
    "content-security-policy": _CONTENT,
    "x-content-type-options": "nosniff",
    # The address contains the token until the page removes it.
    "referrer-policy": "no-referrer",
}


# Why: docs/decisions.md, "The server is for this computer"
@dataclass(frozen=True)
class Protection:
    """The conditions for requests to the server.

    Args:
        token: the secret in the opened address.
        hosts: allowed names of the server; ``*`` is any numeric address, which DNS rebinding can't
            fake.
        origins: hosts, with ports if any, of other pages that may use the server: the
            names that a proxy gives it.
        proxy_sends_token: whether a proxy sends the token, as a cookie, with the requests of users
            that it has logged in.
    """

    token: str
    hosts: frozenset[str] = frozenset(LOCAL_HOSTS)
    origins: frozenset[str] = frozenset()
    proxy_sends_token: bool = False

    @classmethod
    def of(
        cls,
        token: str,
        hosts: Iterable[str] = (),
        origins: Iterable[str] = (),
        *,
        proxy_sends_token: bool = False,
    ) -> "Protection":
        """Allow the computer's own names besides `hosts`."""
        names = frozenset(map(str.lower, (*LOCAL_HOSTS, *hosts)))
        return cls(token, names, frozenset(map(str.lower, origins)), proxy_sends_token)

    def admits(self, request: HTTPConnection) -> bool:
        """Whether a request is allowed at all."""
        host = request.headers.get("host", "").lower()
        # What comes from the proxy was sent to a name under which the user is logged in.
        is_for_us = self.trusts(request) if self.proxy_sends_token else self._is_host(host)
        return is_for_us and self._is_origin(request.headers.get("origin"), host)

    def knows(self, token: str | None) -> bool:
        """Whether this is the token."""
        # As bytes, because a token with non-ASCII letters is wrong but must not raise an error.
        return token is not None and hmac.compare_digest(token.encode(), self.token.encode())

    def trusts(self, request: HTTPConnection) -> bool:
        """Whether a request has the token, in its address or in a cookie."""
        cookies = (value for name, value in request.cookies.items() if name.startswith(COOKIE))
        return any(map(self.knows, (request.query_params.get("token"), *cookies)))

    def is_local(self, request: HTTPConnection) -> bool:
        """Whether a request comes from a user at this computer, as far as the server can tell.

        A proxy passes on the requests of other computers as its own, so behind one no request does.
        """
        is_passed_on = bool(
            self.proxy_sends_token or self.origins or _PASSED_ON & set(request.headers)
        )
        client = request.client
        return client is not None and not is_passed_on and is_loopback(client.host)

    def _is_host(self, host: str) -> bool:
        name = _name(host)
        return name in self.hosts - {"*"} or ("*" in self.hosts and _is_number(name))

    def _is_origin(self, origin: str | None, host: str) -> bool:
        """Whether the requesting page is allowed; programs other than browsers send none."""
        if origin is None:
            return True
        asking = origin.lower().partition("://")[2]
        return bool(asking) and (asking == host or asking in self.origins)


def is_loopback(host: str) -> bool:
    """Whether only this computer itself can connect to or from an address."""
    return host == "localhost" or (_is_number(host) and ipaddress.ip_address(host).is_loopback)


def offered_token(subprotocols: Iterable[str]) -> str | None:
    """The token in a websocket's subprotocols, which follow our name."""
    offered = list(subprotocols)
    return offered[1] if len(offered) == 2 and offered[0] == SUBPROTOCOL else None


class Guard:
    """Middleware that refuses unauthorized requests, and adds our headers to each response."""

    def __init__(self, app: ASGIApp, protection: Protection) -> None:
        self._app = app
        self._protection = protection

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] == "lifespan" or self._protection.admits(HTTPConnection(scope)):
            # A browser that disconnects in the middle of a request is not a fault.
            with suppress(ClientDisconnect):
                await self._app(scope, receive, _marking(send))
        elif scope["type"] == "websocket":
            # A handshake that is never accepted ends as 403.
            await send({"type": "websocket.close", "code": 1008})
        else:
            await _refusal()(scope, receive, _marking(send))


def _refusal() -> PlainTextResponse:
    return PlainTextResponse(f"{Phrase('server-wrong-address')}\n", HTTPStatus.FORBIDDEN)


def _marking(send: Send) -> Send:
    async def mark(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(scope=message)
            for name, value in _HEADERS.items():
                # A response may allow less.
                headers.setdefault(name, value)
        await send(message)

    return mark


def _name(host: str) -> str:
    """The name of a host without its port; "" for a malformed one."""
    try:
        return urlsplit(f"//{host}").hostname or ""
    except ValueError:
        return ""


def _is_number(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True
