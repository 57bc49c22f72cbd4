"""A new skill works, and its test passes."""

import runpy

from learnblock.new.files import write_new
from learnblock.new.skill import skill_files


def test_the_test_of_a_new_skill_passes_at_once(own_home, monkeypatch):
    write_new(skill_files("sway", own_home))
    tests = runpy.run_path(str(own_home / "tests" / "test_sway.py"))
    claims = [value for name, value in tests.items() if name.startswith("test_")]
    assert len(claims) == 2
    for claim in claims:
        claim()
