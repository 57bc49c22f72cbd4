"""`learnblock dev`: the page with hot reload, for those who build it.

Vite serves the page from its sources and hands everything else to a server of ours, which starts
anew whenever a Python file changes.
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

PACKAGE = Path(__file__).parents[1]


def develop(port: int) -> None:
    """Serve the page on `port` until Ctrl-C.

    Raises:
        LearnBlockError: this is no checkout, or something that contributors need is missing.
    """
    frontend = _frontend()
    try:
        import watchfiles  # noqa: PLC0415 - contributors alone have it
    except ImportError as error:
        raise LearnBlockError(
            "`learnblock dev` needs watchfiles: pip install -e '.[dev]'"
        ) from error
    server, token = _free_port(), secrets.token_urlsafe()
    os.environ |= {
        "LEARNBLOCK_TOKEN": token,
        "LEARNBLOCK_SERVER": f"http://127.0.0.1:{server}",
    }
    command = [sys.executable, "-m", "learnblock", "--no-browser", "--port", str(server)]
    with _vite(frontend, port):
        print(f"\n  The page with hot reload: http://localhost:{port}/?token={token}\n")  # noqa: T201
        watchfiles.run_process(
            PACKAGE,
            target=shlex.join(command),
            target_type="command",
            watch_filter=watchfiles.PythonFilter(),
        )


def _frontend() -> Path:
    frontend = PACKAGE.parents[1] / "frontend"
    if not (frontend / "package.json").is_file():
        raise LearnBlockError(
            "`learnblock dev` works in a checkout of LearnBlock, where `frontend/` is; to use the"
            " page, start `learnblock`"
        )
    return frontend


def _free_port() -> int:
    with socket.create_server(("127.0.0.1", 0)) as listening:
        return int(listening.getsockname()[1])


@contextmanager
def _vite(frontend: Path, port: int) -> Iterator[None]:
    npm = shutil.which("npm")
    if npm is None:
        raise LearnBlockError("`learnblock dev` needs Node.js 20.19 or newer")
    if not (frontend / "node_modules").is_dir():
        subprocess.run([npm, "ci", "--omit=peer"], cwd=frontend, check=True)  # noqa: S603 - npm
    command = [npm, "run", "dev", "--", "--port", str(port), "--strictPort"]
    vite = subprocess.Popen(command, cwd=frontend)  # noqa: S603 - npm
    try:
        yield
    finally:
        vite.terminate()
        vite.wait()
