"""How this LearnBlock is installed, and the command that adds what it lacks."""

import json
import os
import re
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib import metadata, util
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

from learnblock.shell import command_line

DISTRIBUTION = "learnblock-studio"
#: A requirement of an extra: its packages, any other condition, and the extra.
_REQUIREMENT = re.compile(
    r"(?P<packages>[^;]+?)\s*;\s*(?:\(?(?P<condition>.+?)\)?\s+and\s+)?"
    r"extra\s*==\s*['\"](?P<extra>[^'\"]+)['\"]"
)


@cache
def version() -> str:
    """The version of LearnBlock, looked up once: reading it takes as long as a short run."""
    return metadata.version(DISTRIBUTION)


@dataclass(frozen=True, slots=True)
class Installation:
    """Where LearnBlock is installed, and what installs packages there.

    Args:
        python: the path of its interpreter.
        checkout: the folder of its source code, if it runs from there.
        uses_uv: whether its environment is the one that uv keeps for that folder.
        is_pipx: whether pipx manages its environment.
        has_pip: whether its environment has pip.
        is_shared: whether others use it too, so that the page must not change it.
    """

    python: str
    checkout: Path | None = None
    uses_uv: bool = False
    is_pipx: bool = False
    has_pip: bool = True
    is_shared: bool = False

    @classmethod
    def current(cls) -> "Installation":
        """The one that is running."""
        environment, checkout = Path(sys.prefix), _checkout()
        return cls(
            sys.executable or "python",
            checkout,
            uses_uv=checkout is not None and _is_of_uv(environment, checkout),
            is_pipx=(environment / "pipx_metadata.json").is_file(),
            has_pip=util.find_spec("pip") is not None,
            # A hub's servers have one environment; one that the system keeps is for all its users.
            is_shared="JUPYTERHUB_USER" in os.environ or not os.access(environment, os.W_OK),
        )

    def add_on(self, extra: str) -> str:
        """The command that installs one of our extras, as one types it."""
        return command_line(*self.adding(extra))

    def adding(self, extra: str) -> tuple[str, ...]:
        """The words of the command that installs one of our extras, such as ``cozmo``."""
        if self.checkout is None:
            # Its packages, because a wheel that came as a file is not found by its name.
            return self._install(*requirements(extra))
        if not self.uses_uv:
            return self._install("-e", f"{self.checkout}[{extra}]")
        return self._sync("--extra", extra)

    def may_add(self, extra: str) -> bool:
        """Whether the page may install an extra: one of ours, into packages that only we use.

        A user's own robot names the modules that it needs, but not the packages with them.
        """
        return bool(requirements(extra)) and not self.is_shared

    def rebuilt(self) -> str:
        """The command that builds what a checkout needs, such as the weights of a detector."""
        if self.checkout and self.uses_uv:
            return command_line(*self._sync("--reinstall-package", DISTRIBUTION))
        return command_line(*self._install("-e", str(self.checkout or ".")))

    def _sync(self, *options: str) -> tuple[str, ...]:
        place = () if self.checkout == Path.cwd() else ("--project", str(self.checkout))
        return ("uv", "sync", *place, "--inexact", "--no-dev", *options)

    def _install(self, *packages: str) -> tuple[str, ...]:
        if self.is_pipx:
            return ("pipx", "inject", DISTRIBUTION, *packages)
        if self.has_pip:
            return (self.python, "-m", "pip", "install", *packages)
        return ("uv", "pip", "install", "--python", self.python, *packages)


def add_on(extra: str) -> str:
    """The command that installs one of our extras in this installation."""
    return Installation.current().add_on(extra)


def requirements(extra: str) -> tuple[str, ...]:
    """The packages of an extra, as installers take them."""
    matches = (
        _REQUIREMENT.match(requirement) for requirement in metadata.requires(DISTRIBUTION) or ()
    )
    return tuple(
        f"{requirement['packages']}; {requirement['condition']}"
        if requirement["condition"]
        else requirement["packages"]
        for requirement in matches
        if requirement and requirement["extra"] == extra
    )


def _checkout() -> Path | None:
    """The folder of an editable installation."""
    from urllib.request import url2pathname  # noqa: PLC0415 - it loads slowly

    origin = metadata.distribution(DISTRIBUTION).read_text("direct_url.json")
    described: Mapping[str, Any] = json.loads(origin) if origin else {}
    if not described.get("dir_info", {}).get("editable"):
        return None
    return Path(url2pathname(unquote(urlsplit(described["url"]).path)))


def _is_of_uv(environment: Path, checkout: Path) -> bool:
    """Whether an environment is the one that uv makes for the project in a folder."""
    project = checkout / os.environ.get("UV_PROJECT_ENVIRONMENT", ".venv")
    configuration = environment / "pyvenv.cfg"
    return (
        environment.resolve() == project.resolve()
        and configuration.is_file()
        and any(line.startswith("uv ") for line in configuration.read_text("utf-8").splitlines())
    )
