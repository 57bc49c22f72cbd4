"""The checks of `scripts/check`, as a part of the tests."""

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from places import ROOT

pytestmark = pytest.mark.slow

FRONTEND = ROOT / "frontend"
PAGE_CHECKS = ["types", "lint", "test"]
CHECKS = re.findall(r"^uv run (.+)$", (ROOT / "scripts" / "check").read_text(), re.MULTILINE)


@pytest.mark.parametrize("command", CHECKS)
def test_the_code_passes(command):
    tool, *arguments = command.split()
    # The tools of this environment, even if the shell would find others.
    path = Path(sys.executable).with_name(tool)
    done = subprocess.run([path, *arguments], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_there_are_checks_of_style_form_types_and_imports():
    assert ["ruff check .", "ruff format --check .", "mypy", "lint-imports"] == CHECKS


def test_the_page_is_checked_for_types_style_and_behaviour():
    scripts = json.loads((FRONTEND / "package.json").read_text("utf-8"))["scripts"]
    assert scripts["check"] == " && ".join(f"npm run {script}" for script in PAGE_CHECKS)


@pytest.mark.parametrize("script", PAGE_CHECKS)
def test_the_page_passes(script):
    npm = shutil.which("npm")
    if npm is None or not (FRONTEND / "node_modules").is_dir():
        pytest.skip("the page was built with another Node: npm ci --omit=peer in frontend")
    done = subprocess.run(
        [npm, "run", script], cwd=FRONTEND, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
