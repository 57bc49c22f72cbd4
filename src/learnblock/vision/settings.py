"""What a user can choose about perception: the table ``[perception]`` of the settings."""

from typing import Annotated, Literal

from msgspec import Meta

from learnblock.settings import Patience, Settings, Table

#: Why emotions are not recognised on real cameras unless somebody says so.
WHY_EMOTIONS_ARE_OFF = """\
Recognition of emotions on real cameras, webcams and videos is off. In the European Union, Article
5(1)(f) of the AI Act (Regulation (EU) 2024/1689) forbids the use of systems that infer emotions of
people in education and at work, but for medical and safety reasons; elsewhere other laws and the
rules of your school may. Drawn and simulated faces are nobody's: on those it always works.

Only an adult who knows that nobody is made subject to it against the law should switch it on.
Pictures are never stored, nor sent anywhere but to a component that you configure yourself."""

# One to 65535 in digits.
_PORT = r"([1-9]\d{0,3}|[1-5]\d{4}|6[0-4]\d{3}|65[0-4]\d{2}|655[0-2]\d|6553[0-5])"

ComponentAddress = Annotated[
    str,
    Meta(
        pattern=rf"^([\w.-]{{1,253}}:{_PORT})?\Z",
        max_length=259,
        description="HOST:PORT of a component that looks in our place; empty for our own detector",
    ),
]
PictureLayout = Annotated[
    Literal["auto", "rows", "columns"],
    Meta(
        description="which number components read in a picture's `width`: RoboComp's read its rows;"
        " auto finds it out where a component shows it"
    ),
]
WebcamChoice = Annotated[
    Annotated[int, Meta(ge=0, le=63)] | Literal["none"],
    Meta(description="this computer's webcam as a camera more: 0 is the first one"),
]
Video = Annotated[
    str,
    Meta(max_length=4096, description="a file in the webcam's place; empty for none"),
]


class PerceptionSettings(Settings, frozen=True):
    """How what cameras see is recognised."""

    emotions_on_cameras: Annotated[
        bool,
        Meta(description="recognition of emotions on real cameras; the law may forbid it"),
    ] = False
    apriltag: ComponentAddress = ""
    emotionrecognition: ComponentAddress = ""
    layout: PictureLayout = "auto"
    patience: Patience = 2.0
    webcam: WebcamChoice = "none"
    video: Video = ""

    def permits(self, detector: str, *, drawn: bool) -> bool:
        """Whether a detector may look: the one gate, whoever looks and wherever from.

        Args:
            detector: its name, such as ``emotions``.
            drawn: whether only drawn or simulated faces can be seen.
        """
        return detector != "emotions" or drawn or self.emotions_on_cameras


TABLE = Table(("perception",), "perception", PerceptionSettings)
