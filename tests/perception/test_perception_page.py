import io
import re
from contextlib import redirect_stdout
from pathlib import Path

from learnblock.perception import DETECTORS
from learnblock.skills import find

PAGE = (Path(__file__).parents[2] / "docs" / "perception.md").read_text(encoding="utf-8")


def test_the_page_s_code_runs():
    (code,) = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    shown = io.StringIO()
    with redirect_stdout(shown):
        exec(code, {})  # noqa: S102 - our own page
    assert re.fullmatch(r"joy True \d+\n", shown.getvalue())


def test_the_page_names_every_detector_with_skills_that_there_are():
    rows = re.findall(r"^\| `(\w+)` \| .* \| (.*) \|$", PAGE, re.MULTILINE)
    assert [name for name, _ in rows] == list(DETECTORS)
    named = {skill for _, skills in rows for skill in re.findall(r"`(\w+)`", skills)}
    assert named <= find().keys()
