"""The page of a grading is accessible, in light and dark, and fits on a phone."""

import pytest

from gradings import GOOD, SHORT, handed_in, plan
from learnblock.lessons.grading.grading import Grading
from learnblock.lessons.grading.journal import opened_journal
from learnblock.lessons.grading.output import write_results
from learnblock.lessons.grading.values import CheckResult, HintResult, Result, packed

MISSED = Result(
    checks=(
        CheckResult("failed", 1.0, {"en": "Too short."}),
        CheckResult("met"),
        CheckResult("open"),
    ),
    ended="finished",
    path=((0, 0), (100, 50)),
    hints=(HintResult("rule", ({"en": "Look at the time."},), {"en": "The time fits."}),),
)
#: The rules and elements that axe finds fault with.
FAULTS = "async () => (await axe.run()).violations.map(one => [one.id, one.nodes[0].html])"


@pytest.fixture
def results(tmp_path):
    """The address of a page with two programs that are alike and miss the same checks."""
    with opened_journal(tmp_path) as journal:
        wanted = plan(handed_in(ana=GOOD, bo=GOOD, cy=SHORT))
        for one in wanted.handed_in:
            for key, _ in wanted.pieces(one):
                journal.add(key, packed(MISSED))
        write_results(Grading(wanted, journal), tmp_path, "en", lesson="drive")
    return (tmp_path / "results.html").as_uri()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_page_has_no_violation_and_fits_on_a_phone(browser, axe, results, scheme):
    # The page's own policy would refuse axe.
    page = browser.new_page(
        viewport={"width": 390, "height": 844}, color_scheme=scheme, bypass_csp=True
    )
    page.goto(results)
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    page.evaluate(axe)
    assert page.evaluate(FAULTS) == []
    page.close()
