"""Our detectors as components that other programs can use."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, ClassVar

from learnblock.errors import LearnBlockError, UnknownNameError
from learnblock.ice.robocomp import Layout, interfaces
from learnblock.ice.robocomp.recognition import FoundEmotion, FoundTag, Picture
from learnblock.ice.server import Adapter, Servant
from learnblock.perception import FaceEmotion, detect
from learnblock.perception.robocomp.labels import label_of
from learnblock.perception.robocomp.pictures import PixelOrder, unpacked
from learnblock.perception.settings import TABLE, WHY_EMOTIONS_ARE_OFF

#: The address at which only programs on this computer can connect.
LOOPBACK = "127.0.0.1"


class Component:
    """A detector with the interface of one of RoboComp's components.

    Args:
        order: the meaning of a picture's numbers; None detects it for each picture.
    """

    #: The name of the detector.
    detector: ClassVar[str]
    #: The usual port of such a component.
    port: ClassVar[int]

    def __init__(self, order: PixelOrder | None) -> None:
        self._order = order

    def _found(self, picture: Picture) -> Any:
        return detect(self.detector, unpacked(picture, self._order))


class Tags(Component):
    """Apriltag."""

    detector = "tags"
    port = 25000

    def processimage(self, picture: Picture) -> tuple[FoundTag, ...]:
        return tuple(FoundTag(tag.id, *map(round, tag.center)) for tag in self._found(picture))


class Emotions(Component):
    """EmotionRecognition."""

    detector = "emotions"
    port = 10006

    def processimage(self, picture: Picture) -> tuple[FoundEmotion, ...]:
        emotions = map(_as_found, self._found(picture))
        return tuple(answer for answer in emotions if answer is not None)


#: By the identities of their objects.
COMPONENTS: Mapping[str, type[Component]] = MappingProxyType(
    {"apriltag": Tags, "emotionrecognition": Emotions}
)


def serve(
    name: str,
    *,
    port: int | None = None,
    host: str = LOOPBACK,
    order: PixelOrder | None = None,
    drawn: bool = False,
) -> tuple[Adapter, int]:
    """Serve a component until the adapter is closed.

    Args:
        name: ``apriltag`` or ``emotionrecognition``.
        port: the port to listen on: 0 for any free port, None for the usual one.
        host: the local address to listen on.
        order: the meaning of a picture's numbers; None detects it for each picture.
        drawn: whether it will see only drawn and simulated faces.

    Returns:
        The adapter, and the port.

    Raises:
        UnknownNameError: there is no such component.
        LearnBlockError: the settings forbid it, or it cannot listen there.
    """
    if name not in COMPONENTS:
        raise UnknownNameError("component", name, COMPONENTS)
    kind = COMPONENTS[name]
    if not TABLE.load().permits(kind.detector, drawn=drawn):
        why = WHY_EMOTIONS_ARE_OFF
        raise LearnBlockError("perception-component-not-allowed", component=name, why=why)
    servant = Servant(interfaces(Layout.TOOL)[name], kind(order))
    adapter = Adapter(host)
    wanted = kind.port if port is None else port
    try:
        return adapter, adapter.serve({name: servant}, wanted)
    except (OSError, UnicodeError) as error:
        # UnicodeError: some strings cannot even be looked up as host names.
        adapter.close()
        reason = getattr(error, "strerror", None) or error
        raise LearnBlockError(
            "perception-component-cannot-listen",
            component=name,
            address=f"{host}:{wanted}",
            reason=str(reason),
        ) from error


def _as_found(emotion: FaceEmotion) -> FoundEmotion | None:
    """A face in the interface's format; None if the interface has no word for its emotion."""
    label, face = label_of(emotion.emotion), emotion.face
    return FoundEmotion(face.x, face.y, face.width, face.height, label) if label else None
