"""The checks of `scripts/check`, so that whoever runs the tests runs them too."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
CHECKS = re.findall(r"^uv run (.+)$", (ROOT / "scripts" / "check").read_text(), re.MULTILINE)


@pytest.mark.parametrize("command", CHECKS)
def test_the_code_passes(command):
    tool, *arguments = command.split()
    # The tools of this environment, wherever the shell would find others.
    path = Path(sys.executable).with_name(tool)
    done = subprocess.run([path, *arguments], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_there_are_checks_of_style_form_types_and_imports():
    assert ["ruff check .", "ruff format --check .", "mypy", "lint-imports"] == CHECKS


def test_the_types_of_the_page_are_right():
    frontend = ROOT / "frontend"
    npm = shutil.which("npm")
    if npm is None or not (frontend / "node_modules").is_dir():
        pytest.skip("the page was built with another Node: npm ci --omit=peer in frontend")
    done = subprocess.run(
        [npm, "run", "check"], cwd=frontend, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
