"""Our detectors as components, for whoever asks."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, ClassVar

from learnblock.components.labels import label_of
from learnblock.components.pictures import Order, unpacked
from learnblock.errors import LearnBlockError, UnknownNameError
from learnblock.ice.robocomp import Layout, interfaces
from learnblock.ice.robocomp.recognition import FoundEmotion, FoundTag, Picture
from learnblock.ice.server import Adapter, Servant
from learnblock.perception import FaceEmotion, detect
from learnblock.vision.settings import TABLE, WHY_EMOTIONS_ARE_OFF

#: The address at which nobody but this computer is heard.
LOOPBACK = "127.0.0.1"


class Component:
    """What answers in the place of one of RoboComp's components.

    Args:
        order: of the numbers of pictures; None finds it out for each.
    """

    #: Whose findings it tells.
    detector: ClassVar[str]
    #: Where such a component usually listens.
    port: ClassVar[int]

    def __init__(self, order: Order | None) -> None:
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
        found = map(_told, self._found(picture))
        return tuple(one for one in found if one is not None)


#: By the identities of their objects.
COMPONENTS: Mapping[str, type[Component]] = MappingProxyType(
    {"apriltag": Tags, "emotionrecognition": Emotions}
)


def serve(
    name: str,
    *,
    port: int | None = None,
    host: str = LOOPBACK,
    order: Order | None = None,
    drawn: bool = False,
) -> tuple[Adapter, int]:
    """Be a component, until the adapter is closed.

    Args:
        name: ``apriltag`` or ``emotionrecognition``.
        port: where it listens; 0 is a free one, and None the usual one.
        host: the address of this computer where it listens.
        order: of the numbers of pictures; None finds it out for each.
        drawn: whether it will be shown drawn and simulated faces alone.

    Returns:
        The adapter, and the port.

    Raises:
        UnknownNameError: there is no such component.
        LearnBlockError: it must not look at what it will be shown, or cannot listen there.
    """
    if name not in COMPONENTS:
        raise UnknownNameError("component", name, COMPONENTS)
    kind = COMPONENTS[name]
    if not TABLE.load().permits(kind.detector, drawn=drawn):
        raise LearnBlockError(_refusal(name))
    servant = Servant(interfaces(Layout.TOOL)[name], kind(order))
    adapter = Adapter(host)
    wanted = kind.port if port is None else port
    try:
        return adapter, adapter.serve({name: servant}, wanted)
    except (OSError, UnicodeError) as error:
        # Some texts cannot even be looked up.
        adapter.close()
        reason = getattr(error, "strerror", None) or error
        raise LearnBlockError(
            f"the component {name} cannot listen at {host}:{wanted}: {reason};"
            " choose another --port or --host"
        ) from error


def _told(found: FaceEmotion) -> FoundEmotion | None:
    """A face as the interface tells it; None where it has no word for what the face expresses."""
    label, face = label_of(found.emotion), found.face
    return FoundEmotion(face.x, face.y, face.width, face.height, label) if label else None


def _refusal(name: str) -> str:
    return (
        f"the component {name} is not started, since it does not know whose faces it will be"
        f" shown.\n\n{WHY_EMOTIONS_ARE_OFF}\n\nStart it with --only-drawn-faces if it is shown"
        " drawn and simulated faces alone, or switch emotions on:"
        " learnblock perception set emotions_on_cameras true"
    )
