"""Tests that depend on real time or another program run again when they fail, at most twice.

The summary lists each of them as flaky, with its first error, whether or not it passed in the end.
``scripts/test --strict`` runs none again.
"""

import pytest

AGAIN = 2
#: What is never flaky: a test that hung was given all the time it may have.
HUNG = "from pytest-timeout"


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items):
    for item in items:
        if item.get_closest_marker("realtime") and not item.get_closest_marker("certain"):
            item.add_marker(pytest.mark.flaky(reruns=AGAIN, rerun_except=HUNG))


def pytest_terminal_summary(terminalreporter):
    reruns = terminalreporter.stats.get("rerun", [])
    first = {report.nodeid: report for report in reversed(reruns)}
    if not first:
        return
    terminalreporter.section("flaky: failed, and ran again", red=True)
    for name, report in sorted(first.items()):
        times = sum(rerun.nodeid == name for rerun in reruns)
        terminalreporter.line(f"FLAKY {name} (again: {times}) - {_error_of(report)}")


def _error_of(report):
    crash = getattr(report.longrepr, "reprcrash", None)
    message = crash.message if crash else str(report.longrepr)
    return message.strip().partition("\n")[0]
