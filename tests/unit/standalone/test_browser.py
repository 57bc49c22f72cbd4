"""What is said where no browser can draw, and what a browser is given."""

import base64
import os
import sys

import pytest

from learnblock.errors import LearnBlockError
from learnblock.standalone import browser

PAGE = "<!doctype html><p>Hello</p>"


@pytest.fixture
def programs(tmp_path, monkeypatch):
    """A PATH of its own, in which tests put browsers."""
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(browser, "_PLACES", {})
    return tmp_path


def install(folder, script):
    path = folder / "chromium"
    path.write_text(f"#!{sys.executable}\n{script}")
    path.chmod(0o755)


def test_without_a_browser_the_page_is_named_as_another_way(programs):
    with pytest.raises(LearnBlockError) as caught:
        browser.file_from(PAGE)
    assert caught.value.phrase.code == "picture-no-browser"


@pytest.mark.skipif(os.name == "nt", reason="scripts are no programs there")
@pytest.mark.parametrize("output", ["", "<body>", "<body data-done=''>no base64</body>"])
def test_a_browser_that_draws_nothing_is_named(programs, output):
    install(programs, f"print({output!r})")
    with pytest.raises(LearnBlockError) as caught:
        browser.file_from(PAGE)
    assert caught.value.phrase.values["browser"] == str(programs / "chromium")


@pytest.mark.skipif(os.name == "nt", reason="scripts are no programs there")
def test_the_file_is_what_the_page_leaves_in_its_body(programs):
    file = base64.b64encode(b"a picture").decode()
    install(programs, f"print('''<body class=\"a\" data-done=\"\">{file}</body>''')")
    assert browser.file_from(PAGE) == b"a picture"
