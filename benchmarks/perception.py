"""Measure what camera recognition finds, by distance and angle and on photographs, and its time.

    uv run python benchmarks/perception.py [FACE-API.TGZ]

The posters' faces are of people 1000 to 1059: nothing was tuned on them. The photographs are those
of scikit-image, and those in the package of face-api if `npm pack` has fetched it.
"""

import sys
import tarfile
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import cv2
import numpy as np
import skimage.data
from camera import CameraModel, CameraPose, Image, milliseconds, plain, pose_at, typical_world

from learnblock.perception import DETECTORS, Face, detect
from learnblock.perception.detectors.emotions import emotions_of
from learnblock.perception.detectors.tags import detect_tags
from learnblock.simulator.camera import Surface, render
from learnblock.simulator.textures import EMOTIONS, face, tag

PEOPLE = range(1000, 1060)
LENSES = {"320 by 240, focal length 290": 290.0, "320 by 240, focal length 480": 480.0}
VIEWS = 420
TAG_VIEWS = 300
LENS_HEIGHT = 100.0


@dataclass
class Tally:
    """The number of shown objects that were found, and of those recognised correctly."""

    shown: int = 0
    found: int = 0
    right: int = 0

    def row(self, name: str) -> str:
        found = f"{self.found}/{self.shown} = {self.found / max(1, self.shown):4.0%}"
        right = f"{self.right}/{self.found} = {self.right / max(1, self.found):4.0%}"
        return f"  {name:<16} found {found:<18} recognised correctly {right}"


def board(texture: Image, size: float, angle: float) -> Surface:
    """A square picture of `size` mm at (0, 0), as high as the lens, turned by `angle` degrees."""
    x, y = 0.5 * size * np.sin(np.radians(angle)), 0.5 * size * np.cos(np.radians(angle))
    top, bottom = LENS_HEIGHT + 0.5 * size, LENS_HEIGHT - 0.5 * size
    return Surface(
        np.array([(-x, y, top), (x, -y, top), (x, -y, bottom), (-x, y, bottom)]), texture
    )


def room() -> list[Surface]:
    wall = [(500.0, 3000, 1500), (500, -3000, 1500), (500, -3000, 0), (500, 3000, 0)]
    ground = [(-4000.0, 3000, 0), (500, 3000, 0), (500, -3000, 0), (-4000, -3000, 0)]
    return [
        Surface(np.array(wall), plain(190, 170, 140)),
        Surface(np.array(ground), plain(225, 225, 215)),
    ]


def photograph(
    poster: Surface, distance: float, focal: float, chance: np.random.Generator
) -> Image:
    model, pose = CameraModel(320, 240, focal), CameraPose(-distance, 0, LENS_HEIGHT, 0, 0)
    return render([poster, *room()], model, pose, noise=(chance, 2.0))


def span(value: float, step: int, unit: str) -> str:
    low = int(abs(value) // step) * step
    return f"{low} to {low + step} {unit}"


def faces(focal: float) -> Iterator[tuple[str, float, float, str | None]]:
    """Return each poster's emotion, distance, angle, and recognised emotion if found."""
    chance = np.random.default_rng(int(focal))
    # A nearer poster does not fit into the frame.
    nearest = max(250, 200 * focal / 230)
    for view in range(VIEWS):
        emotion = EMOTIONS[view % len(EMOTIONS)]
        person = PEOPLE[view // len(EMOTIONS) % len(PEOPLE)]
        distance, angle = chance.uniform(nearest, 1000), chance.uniform(-40, 40)
        poster = board(face(emotion, 400, person), 200, angle)
        told = detect("emotions", photograph(poster, distance, focal, chance))
        yield emotion, distance, angle, told[0].emotion if len(told) == 1 else None


def report_faces(lens: str, focal: float) -> None:
    print(f"\nfaces and emotions, {lens}: {VIEWS} posters of 200 mm")
    tallies: dict[str, Tally] = {}
    told: Counter[tuple[str, str]] = Counter()
    for emotion, distance, angle, answer in faces(focal):
        near = distance <= 700 and abs(angle) <= 20
        names = ["to 0.7 m and 20°"] if near else []
        names += [span(distance, 150, "mm")] if abs(angle) <= 20 else []
        names += [span(angle, 10, "°")] if distance <= 700 else []
        for name in names:
            tally = tallies.setdefault(name, Tally())
            tally.shown += 1
            tally.found += answer is not None
            tally.right += answer == emotion
        if answer is not None and near:
            told[emotion, answer] += 1
    for name in sorted(tallies, key=_order):
        print(tallies[name].row(name))
    for emotion in EMOTIONS:
        answers = {answer: count for (shown, answer), count in told.items() if shown == emotion}
        print(
            f"  {emotion:<10} was told as", *(f"{name} {count}" for name, count in answers.items())
        )


def _order(name: str) -> tuple[int, int]:
    first = name.split(maxsplit=1)[0]
    return (0, 0) if first == "to" else (1 + name.endswith("°"), int(first))


def report_tags() -> None:
    print(
        f"\ntags, 320 by 240, focal length 480: {TAG_VIEWS} views of 80 mm, 0.15 to 2.2 m, 0 to 70°"
    )
    chance = np.random.default_rng(2026)
    tallies: dict[str, Tally] = {}
    wrong = 0
    for _ in range(TAG_VIEWS):
        number = int(chance.integers(587))
        distance, angle = chance.uniform(150, 2200), chance.uniform(0, 70)
        seen = photograph(board(tag(number, 200), 100, angle), distance, 480, chance)
        numbers = [one.id for one in detect_tags(seen)]
        wrong += len(set(numbers) - {number})
        for name in ("all", span(distance, 500, "mm"), span(angle, 20, "°")):
            tally = tallies.setdefault(name, Tally())
            tally.shown += 1
            tally.found += bool(numbers)
            tally.right += numbers == [number]
    for name in sorted(tallies, key=lambda name: (-1, 0) if name == "all" else _order(name)):
        print(tallies[name].row(name))
    print(f"  numbers that were not there: {wrong}")


def report_photographs(archive: Path | None) -> None:
    print("\nphotographs")
    for name, picture in [("astronaut", skimage.data.astronaut()), *of_package(archive)]:
        told = [f"{one.emotion} {one.confidence:.2f}" for one in detect("emotions", picture)]
        print(f"  {name}: {len(told)} faces:", ", ".join(told))
    small = np.load(Path(skimage.data.__file__).with_name("lfw_subset.npy"))
    count = [sum(has_face(one) for one in half) for half in (small[:100], small[100:])]
    print(f"  faces of 25 by 25 pixels, four times as large: found {count[0]}/100;")
    print(f"  as many pictures of no face: taken for one {count[1]}/100")


def of_package(archive: Path | None) -> Iterator[tuple[str, Image]]:
    """Return the six photographs of the package, 960 pixels wide."""
    if archive is None:
        return
    with tarfile.open(archive) as files:
        for number in range(1, 7):
            file = files.extractfile(f"package/demo/sample{number}.jpg")
            content = b"" if file is None else file.read()
            image = cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_COLOR_RGB)
            size = (960, round(960 * image.shape[0] / image.shape[1]))
            yield f"sample{number}", cv2.resize(image, size, interpolation=cv2.INTER_AREA)


def has_face(grey: np.ndarray) -> bool:
    large = cv2.resize((255 * grey).astype(np.uint8), (100, 100), interpolation=cv2.INTER_CUBIC)
    framed = cv2.copyMakeBorder(large, 30, 30, 30, 30, cv2.BORDER_REPLICATE)
    return bool(detect("faces", cv2.cvtColor(framed, cv2.COLOR_GRAY2RGB)))


def report_times(model: CameraModel) -> None:
    print(f"\nmilliseconds a frame, {model.width} by {model.height}")
    frames = [render(typical_world(), model, pose_at(number)) for number in range(100)]
    for name in DETECTORS:
        print(f"  {name:<10} {milliseconds(partial(look, name, frames)):6.2f}")
    seen = [(one, detect("faces", one)) for one in frames]
    shown = [pair for pair in seen if pair[1]]
    print(f"  emotions of a face that was found {milliseconds(partial(feel, shown)):6.2f}")


def look(name: str, frames: Sequence[Image], number: int) -> object:
    return detect(name, frames[number])


def feel(shown: Sequence[tuple[Image, tuple[Face, ...]]], number: int) -> object:
    frame, found = shown[number % len(shown)]
    return emotions_of(frame, found[:1])


if __name__ == "__main__":
    for lens, focal in LENSES.items():
        report_faces(lens, focal)
    report_tags()
    report_photographs(Path(sys.argv[1]) if len(sys.argv) > 1 else None)
    report_times(CameraModel(320, 240, 290))
    report_times(CameraModel(640, 480, 580))
