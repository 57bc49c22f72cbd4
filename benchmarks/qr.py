"""How many photographs of links' QR codes are read, by the length and the camera's distance.

    python benchmarks/qr.py

Each code is drawn by the page's own library, with the options of the page, and then rendered as a
camera of 1,920 x 1,080 pixels sees it on a screen: turned by up to 40 degrees about both axes,
blurred and noisy. OpenCV reads it. Needs Node and the page's packages.
"""

import json
import math
import random
import shutil
import string
import subprocess
from itertools import product
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

FRONTEND = Path(__file__).parents[1] / "frontend"
#: As the dialog of a link draws it.
DRAW = """
import { encode } from "uqr";
const draw = (text) => encode(text, { ecc: "L", border: 4 }).data.map((row) => row.map(Number));
console.log(JSON.stringify(JSON.parse(process.argv[1]).map(draw)));
"""
#: Modules around a code.
BORDER = 4
ADDRESS = "http://192.168.1.20:8000/#open="
#: Characters of links: the median and the longest of the examples, of the solutions, and the most.
LENGTHS = (426, 734, 1005, 1200)
#: Degrees about the two axes.
ANGLES = (-40, -20, 0, 20, 40)
TILTS = tuple(product(ANGLES, ANGLES))
#: Pixels of the code's side in a photograph: the camera is near, farther, and far.
SIDES = (800, 600, 400)
#: Pixels of a module before it is rendered.
MODULE = 10
PHOTOGRAPH = (1920, 1080)
#: From the camera to the code, in pixels of the photograph, as its focal length.
DISTANCE = 1600.0
BLUR = 0.8
NOISE = 5.0

Image = NDArray[np.uint8]


def links(chance: random.Random) -> list[str]:
    """Addresses of these lengths, with characters as those of a compressed project."""
    letters = string.ascii_letters + string.digits + "-_"
    return [ADDRESS + "".join(chance.choices(letters, k=n - len(ADDRESS))) for n in LENGTHS]


def codes(texts: list[str]) -> list[Image]:
    """The codes, black on white."""
    node = shutil.which("node")
    if node is None:
        raise SystemExit("no Node on this machine, which draws the codes")
    command = [node, "--input-type=module", "--eval", DRAW, json.dumps(texts)]
    drawn = subprocess.run(command, cwd=FRONTEND, check=True, capture_output=True).stdout
    return [enlarged(rows) for rows in json.loads(drawn)]


def enlarged(rows: list[list[int]]) -> Image:
    modules = (1 - np.array(rows, np.uint8)) * np.uint8(255)
    return np.kron(modules, np.ones((MODULE, MODULE), np.uint8))


def photograph(
    code: Image, side: int, up: float, aside: float, noise: np.random.Generator
) -> Image:
    """The code as a camera sees it that is turned so many degrees from straight."""
    drawn = len(code)
    corners = np.array([[0, 0], [drawn, 0], [drawn, drawn], [0, drawn]], np.float32)
    flat = np.c_[(corners / drawn - 0.5) * side, np.zeros(4)]
    x, y, z = (flat @ turned(math.radians(up), math.radians(aside)).T).T
    seen = np.c_[x, y] / (z + DISTANCE)[:, None] * DISTANCE + np.array(PHOTOGRAPH) / 2
    matrix = cv2.getPerspectiveTransform(corners, seen.astype(np.float32))
    image = cv2.warpPerspective(code, matrix, PHOTOGRAPH, flags=cv2.INTER_AREA, borderValue=200)
    image = cv2.GaussianBlur(image, (0, 0), BLUR)
    return np.clip(image * 0.8 + 20 + noise.normal(0, NOISE, image.shape), 0, 255).astype(np.uint8)


def turned(up: float, aside: float) -> NDArray[np.float64]:
    """The matrix that turns about the horizontal and then the vertical axis."""
    about_x = [[1, 0, 0], [0, math.cos(up), -math.sin(up)], [0, math.sin(up), math.cos(up)]]
    about_y = [
        [math.cos(aside), 0, math.sin(aside)],
        [0, 1, 0],
        [-math.sin(aside), 0, math.cos(aside)],
    ]
    return np.array(about_y) @ np.array(about_x)


def readable(code: Image, text: str, side: int) -> int:
    """How many photographs of a code are read."""
    reader = cv2.QRCodeDetectorAruco()
    noise = np.random.default_rng(1)
    photographs = (photograph(code, side, *tilt, noise) for tilt in TILTS)
    return sum(reader.detectAndDecode(image)[0] == text for image in photographs)


def main() -> None:
    texts = links(random.Random(1))  # noqa: S311 - the same links each time
    print(f"of {len(TILTS)} photographs; the side of the code in pixels:")
    print("characters  modules", *(f"{side:5}" for side in SIDES))
    for text, code in zip(texts, codes(texts), strict=True):
        counts = [readable(code, text, side) for side in SIDES]
        modules = len(code) // MODULE - 2 * BORDER
        print(f"{len(text):10} {modules:8}", *(f"{count:5}" for count in counts), flush=True)


if __name__ == "__main__":
    main()
