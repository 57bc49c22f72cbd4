"""The oldest versions that an installation may have."""

import re
import tomllib

import pytest
from packaging.requirements import Requirement
from packaging.version import Version

from places import ROOT

#: By package: the first version without a known vulnerability, and its name.
FIXED = {
    "cbor2": ("5.8", "CVE-2025-64076"),
    "filelock": ("3.20.3", "CVE-2026-22701"),
    "h11": ("0.16", "CVE-2025-43859"),
    "jupyter-server": ("2.18", "PYSEC-2026-69"),
    "jupyter-server-proxy": ("4.2", "CVE-2024-35225"),
    "jupyterhub": ("5.4.5", "CVE-2026-40864"),
    "opencv-python-headless": ("4.12", "CVE-2025-53644"),
    "paramiko": ("3.4", "CVE-2023-48795"),
    "starlette": ("0.49.1", "CVE-2025-62727"),
    "uvicorn": ("0.11.7", "CVE-2020-7694"),
    "websockets": ("9.1", "CVE-2021-33880"),
}


def floors():
    """Return the lowest version of each package, in any extra."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    extras = project["optional-dependencies"]
    for text in (*project["dependencies"], *(one for named in extras.values() for one in named)):
        needed = Requirement(text)
        if needed.name != project["name"]:
            yield needed.name, needed


FLOORS = dict(floors())


def test_every_dependency_has_a_floor():
    without = [name for name, one in FLOORS.items() if not re.search(r">=|==", str(one.specifier))]
    assert without == ["standard-chunk"]


def admits_vulnerable(needed):
    """Whether a requirement admits a version before the fixed one."""
    (floor,) = (one.version for one in needed.specifier if one.operator == ">=")
    return Version(floor) < Version(FIXED[needed.name][0])


@pytest.mark.parametrize("name", sorted(FIXED))
def test_no_version_with_a_known_vulnerability_is_admitted(name):
    assert not admits_vulnerable(FLOORS[name])


def test_a_floor_below_the_fix_would_be_noticed():
    assert admits_vulnerable(Requirement("starlette>=0.46"))
