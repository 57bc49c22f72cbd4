"""What is said of settings of this machine: of robots, and of perception."""

from typing import Annotated, Any, Literal

from msgspec import Meta, Struct, field

from learnblock.server.messages.base import Message, ShortText

# The page speaks.


class ReadSettings(Message, frozen=True):
    """Ask for what is set of a real robot, or of perception: `SettingsTable`.

    Args:
        robot: its name; empty for perception.
    """

    robot: ShortText = ""


class ChangeSettings(Message, frozen=True):
    """Change settings, all of them or none; `SettingsTable` says what is wrong.

    Args:
        robot: its name; empty for perception.
        values: by name; None puts a default back.
        agreed: the user has read why feelings are not looked for on real cameras.
    """

    robot: ShortText
    values: Annotated[dict[ShortText, Any], Meta(max_length=100)]
    agreed: bool = False


# The server speaks.


class Setting(Struct, frozen=True, omit_defaults=True):
    """One setting.

    Args:
        name: of the setting.
        sort: a ``list`` is of texts.
        value: as it is now.
        default: as it is where nobody has chosen.
        allowed: what it may be, in words.
        description: what it is, in words; empty where the name says it.
        least: of a number.
        most: of a number.
        choices: what it may be, where that is one of a few; of a number, the word for none.
        secret: not to be read over anybody's shoulder.
    """

    name: str
    sort: Literal["text", "number", "whole", "choice", "boolean", "list"]
    value: Any
    default: Any
    allowed: str
    description: str = ""
    least: float | None = None
    most: float | None = None
    choices: tuple[str, ...] = ()
    secret: bool = False


class SettingsTable(Message, frozen=True):
    """What is set of a real robot, or of perception.

    Args:
        robot: its name; empty for perception.
        settings: in their order; none for a robot that has none.
        wrong: why nothing was changed: a sentence for each setting that cannot be so.
        problem: why the user's file cannot be read.
    """

    robot: str
    settings: tuple[Setting, ...] = ()
    wrong: dict[str, str] = field(default_factory=dict)
    problem: str = ""
