"""The command that installs an add-on, in each kind of installation."""

import re
import shlex
from importlib import metadata
from pathlib import Path

import pytest

from learnblock.installation import DISTRIBUTION, Installation, requirements
from places import ROOT

DOCS = sorted((ROOT / "docs").rglob("*.md"))
CLONE = Path("/home/zoe/my clone")
PYTHON = "/opt/venv/bin/python"


@pytest.mark.parametrize(
    ("installation", "words"),
    [
        (
            Installation(PYTHON, CLONE, uses_uv=True),
            ["uv", "sync", "--project", str(CLONE), "--inexact", "--no-dev", "--extra", "ebo"],
        ),
        (Installation(PYTHON, CLONE), [PYTHON, "-m", "pip", "install", "-e", f"{CLONE}[ebo]"]),
        (
            Installation(PYTHON, CLONE, has_pip=False),
            ["uv", "pip", "install", "--python", PYTHON, "-e", f"{CLONE}[ebo]"],
        ),
        (Installation(PYTHON), [PYTHON, "-m", "pip", "install", "paho-mqtt>=2.0"]),
        (
            Installation(PYTHON, has_pip=False),
            ["uv", "pip", "install", "--python", PYTHON, "paho-mqtt>=2.0"],
        ),
        (
            Installation(PYTHON, is_pipx=True),
            ["pipx", "inject", "learnblock-studio", "paho-mqtt>=2.0"],
        ),
    ],
    ids=["clone, uv", "clone, pip", "clone, uv pip", "wheel, pip", "wheel, uv tool", "wheel, pipx"],
)
def test_the_command_fits_the_installation(installation, words):
    assert shlex.split(installation.add_on("ebo")) == words


def test_within_the_clone_its_folder_is_not_named(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)

    assert "--project" not in Installation(PYTHON, Path.cwd(), uses_uv=True).add_on("ebo")


def test_every_extra_has_its_packages():
    known = metadata.metadata(DISTRIBUTION).get_all("Provides-Extra") or []

    assert [extra for extra in known if not requirements(extra)] == []


def test_the_condition_of_a_package_is_kept():
    assert requirements("cozmo") == (
        "pycozmo>=0.8",
        "standard-chunk; python_version >= '3.13'",
    )


@pytest.mark.parametrize("page", [ROOT / "README.md", *DOCS], ids=lambda page: page.name)
def test_no_page_installs_by_a_name_that_no_index_knows(page):
    assert not re.search(r"install\b.*['\" ]learnblock-studio", page.read_text("utf-8"))


def test_the_readme_names_every_add_on_of_users():
    text = (ROOT / "README.md").read_text("utf-8").partition("### Add-ons")[2]
    known = set(metadata.metadata(DISTRIBUTION).get_all("Provides-Extra") or [])

    assert [extra for extra in known - {"dev", "test"} if f"`{extra}`" not in text] == []


def test_this_installation_is_recognised():
    current = Installation.current()

    assert current.checkout is None or (current.checkout / "pyproject.toml").is_file()
