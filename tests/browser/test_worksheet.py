"""`learnblock lesson worksheet` prints a lesson, in a browser without a window."""

import re

from click.testing import CliRunner

from browser.conftest import chromium
from learnblock.cli import main


def test_a_worksheet_is_printed_with_the_solutions_on_pages_of_their_own(tmp_path):
    chromium()
    path = tmp_path / "square.pdf"
    command = ["lesson", "worksheet", "1-03-square", "--to", str(path), "--language", "es"]
    result = CliRunner().invoke(main, command)
    assert result.exit_code == 0, result.output
    pdf = path.read_bytes()
    assert pdf.startswith(b"%PDF")
    # Four with the steps, two with the solutions.
    assert len(re.findall(rb"/Type /Page\b", pdf)) == 6
