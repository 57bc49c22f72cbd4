"""The examples on the pages of EBO and RCIS run, and their tables are those of the code."""

import re

import pytest

from learnblock.emulators.ebo_camera import find_broker
from learnblock.robots import find, settings
from places import ROOT

PAGES = ROOT / "docs" / "robots"


@pytest.mark.parametrize("name", ["ebo", "rcis"])
def test_the_python_of_the_page_runs(name, capsys):
    if name == "ebo" and find_broker() is None:
        pytest.skip("needs a broker of MQTT: apt-get install mosquitto")
    (code,) = re.findall(r"```python\n(.*?)```", page(name), re.DOTALL)
    exec(code, {})  # noqa: S102 - that is the point
    assert capsys.readouterr().out.strip()


@pytest.mark.parametrize("name", ["ebo", "rcis"])
def test_the_page_names_every_setting_with_its_default(name):
    shown = dict(re.findall(r"^\| `(\w+)` \| (?:`(.+?)`)? ?\|", page(name), re.MULTILINE))
    known = {
        one.name: plain(one.default)
        for one in settings.describe(name, find(name).load().settings_type)
    }
    assert shown == known


@pytest.mark.parametrize("name", ["ebo", "rcis"])
def test_the_page_names_every_device(name):
    shown = re.findall(r"^\| `(\w+:\w+)` \|", page(name), re.MULTILINE)
    assert set(shown) == find(name).load().device_names()


def page(name):
    return (PAGES / f"{name}.md").read_text(encoding="utf-8")


def plain(value):
    """A setting's value as the page writes it."""
    return str(list(value)) if isinstance(value, tuple) else str(value)
