"""At the end of a run: where its seconds went, by folder, and the longest tests."""

from collections import Counter

import pytest

LONGEST = 10


def pytest_terminal_summary(terminalreporter):
    tests, folders = Counter(), Counter()
    for reports in terminalreporter.stats.values():
        for report in reports:
            # A test's own report has the seconds of its subtests too.
            if hasattr(report, "duration") and not isinstance(report, pytest.SubtestReport):
                tests[report.nodeid] += report.duration
                folders[_folder(report.nodeid)] += report.duration
    if not tests:
        return
    terminalreporter.section("seconds")
    terminalreporter.line(f"{sum(tests.values()):8.1f}  all, set-up and clean-up too")
    for folder, seconds in folders.most_common():
        terminalreporter.line(f"{seconds:8.1f}  {folder}")
    terminalreporter.section(f"the {LONGEST} longest tests")
    for name, seconds in tests.most_common(LONGEST):
        terminalreporter.line(f"{seconds:8.1f}  {name}")


def _folder(name):
    """Return the first two folders of a test, such as ``unit/server``."""
    path = name.partition("::")[0].removeprefix("tests/").split("/")[:-1]
    return "/".join(path[:2]) or "tests"
