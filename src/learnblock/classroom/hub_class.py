"""A class under JupyterHub: the hub says who comes, and starts the pupils' servers.

The class is a service that the hub manages. Its relays reach a pupil's server through the hub's
proxy, with the token of the service, and exchange the same messages as on a teacher's laptop.
"""

import asyncio
import hashlib
import hmac
import secrets
import time
from collections.abc import Mapping
from dataclasses import dataclass
from http import HTTPStatus
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import quote, urlencode, urlsplit

import httpx
from starlette.requests import Request

from learnblock.classroom.roster import Roster
from learnblock.classroom.servers import ServerAddress
from learnblock.errors import LearnBlockError

#: Seconds in which a server starts when a whole class comes at once, and between two looks at it.
_STARTING, _LOOK = 120.0, 0.5
#: Seconds for which a server that runs is taken to run: a page asks for many files at once.
_READY = 5.0
#: Seconds for which a token opens a pupil's server.
_TOKEN = 12 * 3600


class _Token(NamedTuple):
    token: str
    until: float


@dataclass(frozen=True)
class HubService:
    """What the hub tells a service that it manages.

    Args:
        api: the address of the hub's API.
        token: of the service.
        client: the name of the service at the hub's login.
        prefix: the path of the service.
        login: the path of the hub's login.
        listen: where the service listens, as a host and a port.
        proxy: the address at which the hub's proxy passes requests on to users' servers.
        pupils: the hub's group of the pupils.
        teachers: the hub's group of the teachers.
    """

    api: str
    token: str
    client: str
    prefix: str
    login: str
    listen: tuple[str, int]
    proxy: str
    pupils: str
    teachers: str

    @classmethod
    def of(
        cls, environment: Mapping[str, str], proxy: str, pupils: str, teachers: str
    ) -> "HubService":
        """Read what the hub has put into the environment of the service.

        Args:
            environment: of this process.
            proxy: the address at which the hub's proxy passes requests on to users' servers.
            pupils: the hub's group of the pupils.
            teachers: the hub's group of the teachers.

        Raises:
            LearnBlockError: the hub has not started this process.
        """
        try:
            url = urlsplit(environment["JUPYTERHUB_SERVICE_URL"])
            return cls(
                api=environment["JUPYTERHUB_API_URL"],
                token=environment["JUPYTERHUB_API_TOKEN"],
                client=environment["JUPYTERHUB_CLIENT_ID"],
                prefix=environment["JUPYTERHUB_SERVICE_PREFIX"],
                login=f"{environment['JUPYTERHUB_BASE_URL']}hub/api/oauth2/authorize",
                listen=(url.hostname or "127.0.0.1", url.port or 0),
                proxy=proxy.rstrip("/"),
                pupils=pupils,
                teachers=teachers,
            )
        except KeyError as error:
            raise LearnBlockError("class-no-hub", variable=str(error)) from error

    @property
    def authorization(self) -> dict[str, str]:
        """The header with which the service is known."""
        return {"Authorization": f"token {self.token}"}

    @property
    def address(self) -> str:
        """The address by which pupils and teachers reach the service."""
        return f"{self.proxy}{self.prefix.rstrip('/')}"

    @property
    def callback(self) -> str:
        """The path to which the hub sends who has logged in."""
        return f"{self.prefix}oauth_callback"


@dataclass(frozen=True)
class HubUser:
    """Who has logged in.

    Args:
        name: at the hub.
        is_teacher: whether the user is a teacher of the class.
    """

    name: str
    is_teacher: bool

    @property
    def id(self) -> str:
        """The id of the pupil in the class."""
        return hashlib.sha256(self.name.encode()).hexdigest()[:10]


class HubLogin:
    """The hub's login.

    Args:
        service: what the hub has told.
    """

    #: The cookie that says that this browser has begun to log in here.
    cookie = "learnblock_class_login"

    def __init__(self, service: HubService) -> None:
        self.service = service

    def begin(self) -> tuple[str, str]:
        """The address of the login, and what the browser remembers meanwhile."""
        state = secrets.token_urlsafe(24)
        query = {
            "client_id": self.service.client,
            "redirect_uri": self.service.callback,
            "response_type": "code",
            "state": state,
        }
        return f"{self.service.login}?{urlencode(query)}", state

    async def user(self, request: Request) -> HubUser | None:
        """Who has logged in; None for those who are not in the class.

        Raises:
            LearnBlockError: this browser has not begun to log in.
            httpx.HTTPError: the hub does not answer, or refuses.
        """
        state = request.query_params.get("state", "")
        known = request.cookies.get(self.cookie, "")
        if not known or not hmac.compare_digest(state.encode(), known.encode()):
            raise LearnBlockError("class-login-again")
        model = await self._model(request.query_params.get("code", ""))
        groups = set(model.get("groups", ()))
        if not groups & {self.service.pupils, self.service.teachers}:
            return None
        return HubUser(model["name"], self.service.teachers in groups)

    async def _model(self, code: str) -> dict[str, Any]:
        service = self.service
        form = {
            "client_id": service.client,
            "client_secret": service.token,
            "grant_type": "authorization_code",
            "code": code,
            "redirect_uri": service.callback,
        }
        async with httpx.AsyncClient(trust_env=False) as client:
            answer = await client.post(f"{service.api}/oauth2/token", data=form)
            token = answer.raise_for_status().json()["access_token"]
            headers = {"Authorization": f"token {token}"}
            answer = await client.get(f"{service.api}/user", headers=headers)
            model: dict[str, Any] = answer.raise_for_status().json()
        return model


# Why: docs/decisions.md, "At a hub, a class is a relay, too"
class HubServers:
    """The pupils' servers, which the hub starts and ends.

    Args:
        service: what the hub has told.
        roster: the class, whose pupils have the names of the hub's users.
    """

    #: A server that the hub ends saves everything first, whether the class is open or not.
    are_saved = True

    def __init__(self, service: HubService, roster: Roster) -> None:
        self._service = service
        self._roster = roster
        self._tokens: dict[str, _Token] = {}
        #: Until when a server is taken to run, by the hub's name of its user.
        self._ready: dict[str, float] = {}
        self._client = httpx.AsyncClient(
            base_url=service.api, headers=service.authorization, trust_env=False, timeout=_STARTING
        )

    async def open(self) -> None:
        """Do nothing: the hub runs."""

    def refuse(self) -> None:
        """Do nothing: the hub's servers go on without the class."""

    async def close(self) -> None:
        """Close the connections to the hub."""
        await self._client.aclose()

    def hurry(self) -> None:
        """Do nothing: the hub's servers go on without the class."""

    async def stop(self, pupil: str) -> None:
        """Do nothing: the hub ends servers."""

    async def place(self, pupil: str, folder: Path) -> ServerAddress:  # noqa: ARG002 - as `Servers`
        """The place of a pupil's server, which is started if it is not running.

        Raises:
            LearnBlockError: it does not start.
        """
        known = self._roster.find(pupil)
        if known is None:
            raise LearnBlockError("class-no-pupil")
        name = quote(known.name, safe="@")
        try:
            async with asyncio.timeout(_STARTING):
                if self._ready.get(name, 0.0) < time.monotonic():
                    await self._start(name)
                token = await self._token(name)
        except (TimeoutError, httpx.HTTPError) as error:
            raise LearnBlockError("class-server-silent") from error
        url = urlsplit(self._service.proxy)
        return ServerAddress(
            url.netloc,
            f"{url.path}/user/{name}/learnblock/",
            headers={"Authorization": f"token {token}"},
            is_encrypted=url.scheme == "https",
        )

    async def _token(self, name: str) -> str:
        """A token that opens this server only, for as long as a school day."""
        known = self._tokens.get(name)
        if known is None or known.until < time.monotonic():
            form = {
                "note": self._service.client,
                "expires_in": _TOKEN,
                "scopes": [f"access:servers!user={name}"],
            }
            answer = await self._client.post(f"/users/{name}/tokens", json=form)
            token = answer.raise_for_status().json()["token"]
            known = self._tokens[name] = _Token(token, time.monotonic() + _TOKEN / 2)
        return known.token

    async def _start(self, name: str) -> None:
        while True:
            answer = await self._client.get(f"/users/{name}")
            servers = answer.raise_for_status().json().get("servers", {})
            if "" in servers and servers[""]["ready"]:
                self._ready[name] = time.monotonic() + _READY
                return
            if "" not in servers:
                answer = await self._client.post(f"/users/{name}/server")
                if answer.status_code != HTTPStatus.BAD_REQUEST:
                    answer.raise_for_status()
            await asyncio.sleep(_LOOK)
