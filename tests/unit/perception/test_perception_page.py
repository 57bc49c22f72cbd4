import io
import re
from contextlib import redirect_stdout

from learnblock.client.skills import find
from learnblock.perception import DETECTORS
from places import ROOT

CAMERAS = (ROOT / "docs" / "cameras.md").read_text(encoding="utf-8")
PAGE = CAMERAS.partition("## Detectors\n")[2].partition("## Settings\n")[0]


def test_the_page_s_code_runs():
    (code,) = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    shown = io.StringIO()
    with redirect_stdout(shown):
        exec(code, {})  # noqa: S102 - our own page
    assert re.fullmatch(r"joy True \d+\n", shown.getvalue())


def test_the_page_names_every_detector_with_skills():
    rows = re.findall(r"^\| `(\w+)` \| .* \| (.*) \|$", PAGE, re.MULTILINE)
    assert [name for name, _ in rows] == list(DETECTORS)
    named = {skill for _, skills in rows for skill in re.findall(r"`(\w+)`", skills)}
    assert named <= find().keys()
