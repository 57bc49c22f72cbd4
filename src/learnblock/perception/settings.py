"""The settings of perception: the table ``[perception]`` in the settings file."""

from typing import Annotated, Literal

from msgspec import Meta

from learnblock.i18n import Phrase
from learnblock.storage.settings import Patience, Settings, SettingsSection

#: Why emotions are not recognised on real cameras unless an adult turns that on.
WHY_EMOTIONS_ARE_OFF = Phrase("perception-emotions-off")

# One to 65535 in digits.
_PORT = r"([1-9]\d{0,3}|[1-5]\d{4}|6[0-4]\d{3}|65[0-4]\d{2}|655[0-2]\d|6553[0-5])"

ComponentAddress = Annotated[
    str,
    Meta(
        pattern=rf"^([\w.-]{{1,253}}:{_PORT})?\Z",
        max_length=259,
        description="perception-setting-component",
    ),
]
PictureLayout = Annotated[
    Literal["auto", "rows", "columns"],
    Meta(description="perception-setting-layout"),
]
WebcamChoice = Annotated[
    Annotated[int, Meta(ge=0, le=63)] | Literal["none"],
    Meta(description="perception-setting-webcam"),
]
Video = Annotated[
    str,
    Meta(max_length=4096, description="perception-setting-video"),
]


class PerceptionSettings(Settings, frozen=True):
    """Camera recognition."""

    emotions_on_cameras: Annotated[
        bool,
        Meta(description="perception-setting-emotions"),
    ] = False
    apriltag: ComponentAddress = ""
    emotionrecognition: ComponentAddress = ""
    layout: PictureLayout = "auto"
    patience: Patience = 2.0
    webcam: WebcamChoice = "none"
    video: Video = ""

    def permits(self, detector: str, *, drawn: bool) -> bool:
        """Whether a detector may be used: the only function that decides this.

        Args:
            detector: its name, such as ``emotions``.
            drawn: whether only drawn or simulated faces can be seen.
        """
        return detector != "emotions" or drawn or self.emotions_on_cameras


TABLE = SettingsSection(("perception",), "perception", PerceptionSettings)
