"""The page installs what a robot needs, with the installer of this installation."""

import asyncio
import os
import sys
import zipfile
from pathlib import Path

import pytest

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.server.messages import AddOn
from learnblock.server.runs.installer import Installer
from waiting import SECONDS

ADD_ON = AddOn("uv pip install add_on", ours=True)


@pytest.fixture
def wheel(tmp_path):
    """A package for the installer."""
    path = tmp_path / "add_on-1.0-py3-none-any.whl"
    with zipfile.ZipFile(path, "w") as packed:
        packed.writestr("add_on_of_a_test.py", "")
        packed.writestr(
            "add_on-1.0.dist-info/METADATA", "Metadata-Version: 2.1\nName: add-on\nVersion: 1.0\n"
        )
        packed.writestr(
            "add_on-1.0.dist-info/WHEEL",
            "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
        )
        packed.writestr("add_on-1.0.dist-info/RECORD", "")
    return path


class Shown:
    """What the page shows while an installer works."""

    def __init__(self, *command):
        self.installer = Installer(self.changed, self.refresh, lambda _: command)
        self.shown = []
        self.refreshed = 0

    def changed(self):
        self.shown.append(self.installer.shown("cozmo", ADD_ON))

    async def refresh(self):
        self.refreshed += 1

    async def until_done(self):
        async with asyncio.timeout(SECONDS):
            while not self.shown or self.shown[-1].installing:
                await asyncio.sleep(0.01)
        return self.shown[-1].problem


def uv(*words):
    return ("uv", "pip", "install", "--python", sys.executable, "--no-cache", *map(str, words))


def install(*command):
    async def installed():
        page = Shown(*command)
        page.installer.begin("cozmo")
        return await page.until_done(), page

    return asyncio.run(installed())


def test_an_installed_module_is_found_without_a_restart(wheel, tmp_path, monkeypatch):
    folder = tmp_path / "packages"
    folder.mkdir()
    monkeypatch.syspath_prepend(folder)
    with pytest.raises(ModuleNotFoundError):
        __import__("add_on_of_a_test")

    _, page = install(*uv("--no-index", "--target", folder, wheel))

    assert page.refreshed == 1
    assert __import__("add_on_of_a_test")


def test_the_page_shows_what_the_installer_says(wheel, tmp_path):
    _, page = install(*uv("--no-index", "--target", tmp_path / "packages", wheel))

    assert page.shown[0].installing
    assert any("add-on" in shown.progress for shown in page.shown)


def test_a_computer_without_network_is_told_that_it_is_offline(monkeypatch):
    monkeypatch.setenv("UV_HTTP_RETRIES", "0")
    problem, _ = install(*uv("--index-url", "http://127.0.0.1:9/simple", "no-such-package"))

    assert problem == Phrase("connect-install-offline")


@pytest.mark.exhaustive
def test_without_network_pips_own_words_are_understood_too(monkeypatch):
    monkeypatch.setenv("PIP_CONFIG_FILE", os.devnull)
    for name in ("PIP_FIND_LINKS", "PIP_EXTRA_INDEX_URL", "PIP_NO_INDEX"):
        monkeypatch.delenv(name, raising=False)
    python = Path(sys.base_prefix, "bin", f"python{sys.version_info.major}")
    nowhere = ("--index-url", "http://127.0.0.1:9/simple", "--retries", "1")
    problem, _ = install(str(python), "-m", "pip", "install", *nowhere, "no-such-package")

    assert problem == Phrase("connect-install-offline")


def test_what_the_installer_refuses_is_said_in_its_words(tmp_path):
    problem, _ = install(*uv("--no-index", "--target", tmp_path, tmp_path / "missing.whl"))

    assert problem.code == "connect-install-failed"
    assert "missing.whl" in problem.values["reason"]


def test_a_computer_without_the_installer_is_told_its_name():
    problem, _ = install("no-such-installer")

    assert problem == Phrase("connect-no-installer", name="no-such-installer")


def test_installing_can_be_stopped_and_one_robot_waits_for_another():
    async def stopped():
        page = Shown(sys.executable, "-c", "from threading import Event; Event().wait()")
        page.installer.begin("cozmo")
        with pytest.raises(LearnBlockError) as another:
            page.installer.begin("thymio")
        await page.installer.stop()
        return another.value.phrase, page.shown[-1]

    another, shown = asyncio.run(stopped())

    assert another == Phrase("connect-installs-another", robot="cozmo")
    assert (shown.installing, shown.problem) == (False, None)
