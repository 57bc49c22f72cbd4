"""Show pictures to a component with the real Ice runtime; run by the system's Python.

    /usr/bin/python3 viewers.py '{"slices": "all.ice", "port": 25000, "identity": "apriltag",
        "encoding": "1.1",
        "pictures": [{"file": "a.rgb", "width": 240, "height": 320, "depth": 3}]}'

It prints what the component found in each of them, as a line of JSON.
"""

import json
import sys
from pathlib import Path

import Ice

PLAN = json.loads(sys.argv[1])
Ice.loadSlice(PLAN["slices"])

import RoboCompApriltag  # noqa: E402 - made by what was loaded
import RoboCompEmotionRecognition  # noqa: E402

KINDS = {
    "apriltag": (RoboCompApriltag.ApriltagPrx, RoboCompApriltag.TImage),
    "emotionrecognition": (
        RoboCompEmotionRecognition.EmotionRecognitionPrx,
        RoboCompEmotionRecognition.TImage,
    ),
}


def found(proxy, picture):
    """Return what is found in a picture, or the reason why detection is refused."""
    try:
        return [vars(detection) for detection in proxy.processimage(picture)]
    except Ice.UnknownException as error:
        return error.unknown


with Ice.initialize() as ice:
    proxy_kind, image_kind = KINDS[PLAN["identity"]]
    text = f"{PLAN['identity']} -e {PLAN['encoding']}:tcp -h 127.0.0.1 -p {PLAN['port']}"
    proxy = proxy_kind.checkedCast(ice.stringToProxy(text))
    pictures = [
        image_kind(one["width"], one["height"], one["depth"], Path(one["file"]).read_bytes())
        for one in PLAN["pictures"]
    ]
    print(json.dumps([found(proxy, picture) for picture in pictures]))
