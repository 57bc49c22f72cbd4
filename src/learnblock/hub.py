"""LearnBlock beside Jupyter, as under JupyterHub: what jupyter-server-proxy asks of it.

The user's Jupyter server starts LearnBlock at the first request to ``/learnblock/``, and passes on
only the requests of those who may use the server. Nothing here imports Jupyter or our server,
because it is Jupyter that imports this file.
"""

import secrets
import socket
import sys
from pathlib import Path
from typing import Any

#: The names of `server.http.address` and `server.http.protection`.
TOKEN_VARIABLE, TOKEN_COOKIE = "LEARNBLOCK_TOKEN", "learnblock_token"
_ICON = Path(__file__).parent / "server" / "static" / "icon.svg"
#: Seconds in which LearnBlock answers, even if a whole class starts at once.
_PATIENCE = 60.0


# Why: docs/decisions.md, "Under JupyterHub, LearnBlock runs behind a Jupyter server"
def proxied_server() -> dict[str, Any]:
    """Describe LearnBlock, with a new token, as a server process of jupyter-server-proxy."""
    token = secrets.token_urlsafe(24)
    # Only the user can open a socket in the private folder that the proxy makes. Windows has none.
    by_socket = hasattr(socket, "AF_UNIX")
    place = ["--unix-socket", "{unix_socket}"] if by_socket else ["--port", "{port}"]
    options = ["--no-browser", "--take-over", "--proxy-sends-token"]
    return {
        "command": [sys.executable, "-m", "learnblock", *options, *place],
        "unix_socket": by_socket,
        "timeout": _PATIENCE,
        "environment": {TOKEN_VARIABLE: token},
        # In place of the browser's cookies, whose hub's are not LearnBlock's business.
        "request_headers_override": {"Cookie": f"{TOKEN_COOKIE}={token}"},
        "launcher_entry": {"title": "LearnBlock", "icon_path": str(_ICON), "category": "Other"},
    }
