"""A real JupyterHub with its proxy on this computer, and users who log in to it."""

import json
import os
import re
import secrets
import shutil
import signal
import subprocess
import sys
import time
from contextlib import contextmanager, suppress
from pathlib import Path

import httpx
import pytest
from websockets.sync.client import connect, unix_connect

from pages import Visitor
from places import ROOT
from ports import free_ports
from waiting import wait_for

#: The hub's proxy. `.ci/run` installs it there.
PROXY, PROXY_FOLDER = "configurable-http-proxy", ROOT / "build" / "hub-proxy"
#: Seconds in which a server starts on a busy machine, and between two looks at it.
STARTING, LOOK = 120.0, 0.2
#: The role of a service that may do what an administrator's page does.
ROLE = {"name": "tests", "services": ["tests"], "scopes": ["servers", "delete:servers"]}
#: What the tests add to the configuration in the docs.
CONFIG = """\
{shown}
settings = {settings}
c.JupyterHub.bind_url = settings["address"]
c.JupyterHub.hub_bind_url = settings["hub"]
c.ConfigurableHTTPProxy.api_url = settings["api"]
c.ConfigurableHTTPProxy.command = [settings["proxy"]]
c.SimpleLocalProcessSpawner.home_dir_template = settings["homes"] + "/{{username}}"
# Jupyter asks for this where the tests run as root.
c.Spawner.args = [*c.Spawner.args, "--allow-root"]
{shown_class}
(room,) = c.JupyterHub.services
room["url"] = settings["room"]
room["command"] = [settings["python"], "-m", *room["command"][:-1], settings["address"]]
room["environment"] = {{"LEARNBLOCK_HOME": settings["homes"] + "/class"}}
c.JupyterHub.services = [room, {{"name": "tests", "api_token": settings["token"]}}]
c.JupyterHub.load_roles = [*c.JupyterHub.load_roles, settings["role"]]
"""


def proxy_command():
    """Return the command of the hub's proxy; without it, skip the tests except in CI."""
    path = os.pathsep.join([os.environ.get("PATH", ""), f"{PROXY_FOLDER}/node_modules/.bin"])
    proxy = shutil.which(PROXY, path=path)
    if proxy is None and not os.environ.get("CI"):
        pytest.skip(f"npm install --no-save --prefix {PROXY_FOLDER.relative_to(ROOT)} {PROXY}")
    assert proxy, "CI has no proxy for JupyterHub"
    return proxy


def shown_config():
    """Return the configurations that the docs show: of a hub, and of a class at it."""
    text = (ROOT / "docs" / "jupyterhub.md").read_text("utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    return blocks[0], next(block for block in blocks if "services" in block)


class Hub:
    """A hub of which anyone becomes a user by logging in.

    Args:
        folder: an empty one, for the hub's files and its users' home folders.
        proxy: the command of its proxy.
    """

    def __init__(self, folder, proxy):
        self._folder = folder
        self._token = secrets.token_urlsafe()
        ports = free_ports(4)
        self.address, hub, api, room = (f"http://127.0.0.1:{port}" for port in ports)
        settings = {
            "address": self.address,
            "hub": hub,
            "api": api,
            "proxy": proxy,
            "homes": str(folder / "homes"),
            "token": self._token,
            "role": ROLE,
            "room": room,
            "python": sys.executable,
        }
        (folder / "homes").mkdir(exist_ok=True)
        shown, shown_class = shown_config()
        config = CONFIG.format(shown=shown, shown_class=shown_class, settings=repr(settings))
        (folder / "jupyterhub_config.py").write_text(config)
        self._log = (folder / "log").open("w")
        self._users = []

    @property
    def log(self):
        """What the hub and the servers of its users have written."""
        return (self._folder / "log").read_text(errors="replace")

    @property
    def process(self):
        return self._process.pid

    def home(self, name):
        return self._folder / "homes" / name

    def start(self):
        scripts = str(Path(sys.executable).parent)
        # Each start of a server would compile all of Jupyter.
        env = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
        self._process = subprocess.Popen(
            [sys.executable, "-m", "jupyterhub"],
            cwd=self._folder,
            env={**env, "PATH": f"{scripts}{os.pathsep}{env.get('PATH', '')}"},
            stdout=self._log,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        wait_for(self._answers, "the hub", STARTING)

    def stop(self):
        """End the hub, its proxy and all servers."""
        for user in self._users:
            user.client.close()
        self._process.send_signal(signal.SIGTERM)
        try:
            self._process.wait(STARTING)
        finally:
            # All of them work in our folder; of most, nobody knows any more who has started them.
            for process in working_in(self._folder):
                with suppress(ProcessLookupError):
                    os.kill(process, signal.SIGKILL)
            self._process.wait()
            self._log.close()

    def login(self, name):
        """Log in as a browser does; return the user once LearnBlock's page has been sent."""
        user = self.visitor(name)
        user.page = user.login()
        return user

    def visitor(self, name):
        """Return a user who has not logged in."""
        self._users.append(User(self, name))
        return self._users[-1]

    def stop_server(self, name):
        """Stop a user's server as an administrator does."""
        address = f"{self.address}/hub/api/users/{name}/server"
        authorization = {"Authorization": f"token {self._token}"}
        httpx.delete(address, headers=authorization, timeout=STARTING).raise_for_status()

    def server(self, name):
        """Return the process of a user's LearnBlock; None without one."""
        home = f"HOME={self.home(name)}".encode()
        for process in descendants(self._process.pid):
            if "-m learnblock --no-browser" in command(process) and home in environment(process):
                return process
        return None

    def service(self, command_of):
        """Return the process of a service that the hub manages; None without one."""
        named = f"-m learnblock {command_of} "
        found = (one for one in descendants(self._process.pid) if named in command(one))
        return next(found, None)

    def jupyter_server(self, name):
        """Return the process of a user's Jupyter server."""
        return parent(self.server(name))

    def _answers(self):
        assert self._process.poll() is None, self.log
        try:
            return httpx.get(f"{self.address}/hub/health").is_success
        except httpx.TransportError:
            return False


class User:
    """A browser's requests, with its cookies.

    Args:
        hub: where it sends them.
        name: what it logs in with.
    """

    def __init__(self, hub, name):
        self._hub = hub
        self.name = name
        self.client = httpx.Client(base_url=hub.address, timeout=STARTING, follow_redirects=True)

    def login(self, goal=""):
        """Fill in the form, and follow to the goal: LearnBlock's page, once the server is ready."""
        form = self.client.get("/hub/login").text
        (token,) = re.findall(r'name="_xsrf"\s+value="([^"]+)"', form)
        fields = {"username": self.name, "password": "", "_xsrf": token}
        return self._wait(self.client.post(f"/hub/login?next={goal}", data=fields))

    def spawn(self):
        """Start the server again, as the button of the hub's page does."""
        return self._wait(self.client.get(f"/hub/spawn/{self.name}"))

    def ask_for(self, of):
        """Open the page of another user, and answer the hub's question whether to."""
        page = self.get("", of=of)
        fields = re.findall(r'name="(_xsrf|scopes)" value="([^"]*)"', page.text)
        form = {name: [value for key, value in fields if key == name] for name, _ in fields}
        return self.client.post(page.url, data=form)

    def get(self, path, of=None, **headers):
        """Return the response to a request to LearnBlock, which may be another user's."""
        return self.client.get(self._path(path, of), headers=headers)

    def post(self, path, body, of=None, **headers):
        return self.client.post(self._path(path, of), content=body, headers=headers)

    def visit(self, of=None, origin=None):
        """Connect LearnBlock's page with its server, which may be another user's."""
        return self.socket(self._path("ws", of), origin)

    @contextmanager
    def socket(self, path, origin=None):
        """Connect with the websocket at a path of the hub."""
        cookies = self.client.build_request("GET", path).headers.get("cookie")
        with connect(
            f"{self._hub.address.replace('http', 'ws', 1)}{path}",
            additional_headers={"Cookie": cookies} if cookies else {},
            # The page has no token.
            subprotocols=["learnblock"],
            origin=origin or self._hub.address,
            max_size=None,
            open_timeout=STARTING,
        ) as opened:
            yield Visitor(opened)

    def _path(self, path, of):
        return f"/user/{of or self.name}/learnblock/{path}"

    def _wait(self, answer):
        deadline = time.monotonic() + STARTING
        while "spawn-pending" in answer.url.path:
            assert time.monotonic() < deadline, self._hub.log
            time.sleep(LOOK)
            answer = self.client.get(answer.url)
        return answer


@contextmanager
def running(folder, proxy):
    """Run a hub."""
    hub = Hub(folder, proxy)
    try:
        hub.start()
        yield hub
    finally:
        hub.stop()


@contextmanager
def knock(process, token):
    """Connect with a user's LearnBlock, past the proxy and with a token or none."""
    path = unix_socket(process)
    headers = {"Cookie": f"learnblock_token={token}"} if token else {}
    with unix_connect(
        path, "ws://localhost/ws", subprotocols=["learnblock"], additional_headers=headers
    ) as opened:
        yield Visitor(opened)


def unix_socket(process):
    """Return the socket on which a user's LearnBlock listens."""
    words = command(process).split()
    return words[words.index("--unix-socket") + 1]


def token(process):
    """Return the token that a user's Jupyter server has given to LearnBlock."""
    (variable,) = [
        entry for entry in environment(process) if entry.startswith(b"LEARNBLOCK_TOKEN=")
    ]
    return variable.decode().partition("=")[2]


def servers_info(user):
    """Return what a launcher shows, by name."""
    answer = user.client.get(f"/user/{user.name}/server-proxy/servers-info")
    return {server["name"]: server for server in json.loads(answer.text)["server_processes"]}


# Processes.


def command(process):
    return _read(process, "cmdline").replace(b"\0", b" ").decode(errors="replace")


def environment(process):
    return _read(process, "environ").split(b"\0")


def parent(process):
    return int(_read(process, "stat").rpartition(b")")[2].split()[1])


def is_running(process):
    """Whether a process has not ended; one that only waits to be reaped has."""
    stat = _read(process, "stat")
    return bool(stat) and stat.rpartition(b")")[2].split()[0] != b"Z"


def descendants(process):
    """Return the processes that a process has started, and those that these have."""
    parents = {}
    for folder in Path("/proc").glob("[0-9]*"):
        stat = _read(folder.name, "stat")
        if stat:
            parents[int(folder.name)] = int(stat.rpartition(b")")[2].split()[1])
    own = {process}
    while more := {child for child, started in parents.items() if started in own} - own:
        own |= more
    return own - {process}


def working_in(folder):
    """Return the processes whose working folder is this one or in it."""
    processes = []
    for process in Path("/proc").glob("[0-9]*"):
        # It may have ended.
        with suppress(OSError):
            if process.joinpath("cwd").readlink().is_relative_to(folder):
                processes.append(int(process.name))
    return processes


def _read(process, name):
    try:
        return Path(f"/proc/{process}/{name}").read_bytes()
    except (FileNotFoundError, ProcessLookupError):
        return b""
