"""`scripts/check` checks code and page, and CI runs it beside the tests."""

import json
import re

from places import ROOT

CHECK = (ROOT / "scripts" / "check").read_text(encoding="utf-8")


def test_there_are_checks_of_style_form_types_and_imports():
    checks = re.findall(r"^uv run (.+)$", CHECK, re.MULTILINE)
    assert checks == ["ruff check .", "ruff format --check .", "mypy", "lint-imports"]


def test_the_page_is_checked_for_types_style_and_behaviour():
    package = (ROOT / "frontend" / "package.json").read_text(encoding="utf-8")
    scripts = json.loads(package)["scripts"]
    assert scripts["check"] == "npm run types && npm run lint && npm run test"
    assert "npm --prefix frontend run check" in CHECK.splitlines()


def test_ci_checks_the_code():
    assert "scripts/check" in (ROOT / ".ci" / "run").read_text(encoding="utf-8")
