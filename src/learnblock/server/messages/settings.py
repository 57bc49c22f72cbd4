"""Messages about the settings of robots and of camera recognition."""

from typing import Annotated, Any, Literal

from msgspec import Meta, Struct, field

from learnblock.i18n import Phrase
from learnblock.server.messages.base import Computer, FromReader, ShortText, ToPage

# From the page.


class ReadSettings(Computer, FromReader, frozen=True):
    """Ask for the settings of a real robot or of camera recognition; the reply is `SettingsTable`.

    Args:
        robot: the name of the robot; empty for camera recognition.
    """

    robot: ShortText = ""


class ChangeSettings(Computer, frozen=True):
    """Change settings, all of them or none; the reply is `SettingsTable`.

    Args:
        robot: the name of the robot; empty for camera recognition.
        values: by name; None restores a default.
        agreed: whether the user has accepted the text about emotions on real cameras.
    """

    robot: ShortText
    values: Annotated[dict[ShortText, Any], Meta(max_length=100)]
    agreed: bool = False


# To the page.


class Setting(Struct, frozen=True, omit_defaults=True):
    """One setting.

    Args:
        name: the name of the setting.
        sort: the kind of value; a ``list`` is a list of strings.
        value: the current value.
        default: the value if the user has not chosen one.
        allowed: its possible values.
        description: its purpose; None if the name is enough.
        least: the minimum of a number.
        most: the maximum of a number.
        choices: the values to choose from, if there are only a few; for a number, the word that
            means none.
        secret: whether the page hides the value.
    """

    name: str
    sort: Literal["text", "number", "whole", "choice", "boolean", "list"]
    value: Any
    default: Any
    allowed: Phrase
    description: Phrase | None = None
    least: float | None = None
    most: float | None = None
    choices: tuple[str, ...] = ()
    secret: bool = False


class SettingsTable(ToPage, frozen=True):
    """The settings of a real robot or of camera recognition.

    Args:
        robot: the name of the robot; empty for camera recognition.
        settings: the settings in order; empty for a robot without settings.
        wrong: why nothing was changed, by the name of each invalid setting.
        problem: why the user's file can't be read.
    """

    robot: str
    settings: tuple[Setting, ...] = ()
    wrong: dict[str, Phrase] = field(default_factory=dict)
    problem: Phrase | None = None
