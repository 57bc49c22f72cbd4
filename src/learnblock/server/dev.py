"""The command `learnblock dev`: the page with hot reload, for contributors.

Vite serves the page from its sources and passes all other requests to our server, which restarts
whenever a Python file changes.
"""

import os
import secrets
import shlex
import shutil
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.installation import add_on

PACKAGE = Path(__file__).parents[1]


def develop(port: int) -> None:
    """Serve the page on `port` until Ctrl-C.

    Raises:
        LearnBlockError: there are no sources, or a tool of contributors is missing.
    """
    frontend = _frontend()
    try:
        import watchfiles  # noqa: PLC0415 - only contributors have it
    except ImportError as error:
        raise LearnBlockError("server-dev-no-watchfiles", command=add_on("dev")) from error
    server, token = _free_port(), secrets.token_urlsafe()
    os.environ |= {
        "LEARNBLOCK_TOKEN": token,
        "LEARNBLOCK_SERVER": f"http://127.0.0.1:{server}",
    }
    command = [sys.executable, "-m", "learnblock", "--no-browser", "--port", str(server)]
    with _vite(frontend, port):
        address = f"http://localhost:{port}/?token={token}"
        print(f"\n  {Phrase('server-dev-started', address=address)}\n")  # noqa: T201
        watchfiles.run_process(
            PACKAGE,
            target=shlex.join(command),
            target_type="command",
            watch_filter=watchfiles.PythonFilter(),
        )


def _frontend() -> Path:
    frontend = PACKAGE.parents[1] / "frontend"
    if not (frontend / "package.json").is_file():
        raise LearnBlockError("server-dev-no-checkout")
    return frontend


def _free_port() -> int:
    with socket.create_server(("127.0.0.1", 0)) as listening:
        return int(listening.getsockname()[1])


@contextmanager
def _vite(frontend: Path, port: int) -> Iterator[None]:
    npm = shutil.which("npm")
    if npm is None:
        raise LearnBlockError("server-dev-no-node", version="20.19")
    if not (frontend / "node_modules").is_dir():
        subprocess.run([npm, "ci", "--omit=peer"], cwd=frontend, check=True)  # noqa: S603 - npm
    command = [npm, "run", "dev", "--", "--port", str(port), "--strictPort"]
    vite = subprocess.Popen(command, cwd=frontend)  # noqa: S603 - npm
    try:
        yield
    finally:
        vite.terminate()
        vite.wait()
