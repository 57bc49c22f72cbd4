"""Messages about worlds: their appearance, and editing them."""

from typing import Annotated, ClassVar, Literal

from msgspec import Meta, Struct

from learnblock.i18n import Phrase
from learnblock.monitor import monitor
from learnblock.monitor.gallery import Difficulty, Group
from learnblock.monitor.monitor import WorldValues
from learnblock.server.messages.base import LONGEST_CONTENT, Look, Name, Own, ToPage

#: The limit of a file in bytes; as a message it is a third longer.
LARGEST_WORLD = LONGEST_CONTENT * 3 // 4

# From the page.


class ReadWorld(Look, frozen=True):
    """Ask for a world to edit or to draw; the reply is `WorldToEdit`."""

    answer: ClassVar = "WorldToEdit"

    name: Name


class CheckWorld(Look, frozen=True):
    """Check a world and preview its lines; the reply is `WorldChecked`."""

    world: WorldValues


class MakeWorld(Look, frozen=True):
    """Ask for a world from a template; the reply is `WorldMade`.

    Args:
        template: what kind of world.
        size: how large.
        seed: selects the world; the same number makes the same world.
    """

    template: Literal["field", "track", "maze"]
    size: Annotated[int, Meta(ge=3, le=8)]
    seed: Annotated[int, Meta(ge=0, le=999_999)]


class SaveWorld(Own, frozen=True):
    """Save a world in the user's folder and choose it; `WorldChecked` if it has mistakes.

    Args:
        name: the name of the world and its file.
        world: the values of the world.
        replace: whether to replace the user's world with that name; otherwise `Failed`.
    """

    answer: ClassVar = "WorldChecked"

    name: Name
    world: WorldValues
    replace: bool = False


class ImportWorld(Own, frozen=True):
    """Save the world in a file under its name or a free one, and choose it.

    Args:
        filename: ends in .toml or .zip.
        content: its bytes in base64.
    """

    filename: Name
    content: Annotated[bytes, Meta(max_length=LARGEST_WORLD)]


class ExportWorld(Look, frozen=True):
    """Ask for a world as a file: `WorldExported`."""

    name: Name


class RenameWorld(Own, frozen=True):
    """Give one of the user's worlds another title: `Worlds`."""

    name: Name
    title: Name


class DeleteWorld(Own, frozen=True):
    """Move one of the user's worlds into the trash: `Worlds` and `WorldDeleted`."""

    name: Name


class RestoreWorld(Own, frozen=True):
    """Restore a world from the trash, and choose it: `Worlds`."""

    name: Name


# To the page.


class WorldChoice(Struct, frozen=True, omit_defaults=True):
    """A world to choose; the user's `own` worlds can be edited in place.

    Args:
        name: its name.
        title: its title.
        own: whether it is the user's.
        robots: how many robots its goals are for.
        group: what one does there.
        difficulty: None if its file doesn't say.
        needs: the senses and devices that a robot needs to reach its goals.
        changed: when the user's file was last changed, in seconds since 1970.
    """

    name: str
    title: str
    own: bool
    robots: int = 1
    group: Group = "drive"
    difficulty: Difficulty | None = None
    needs: tuple[str, ...] = ()
    changed: float = 0.0


class Worlds(ToPage, frozen=True):
    """All worlds, after one of them has changed."""

    worlds: tuple[WorldChoice, ...]


class WorldExported(ToPage, frozen=True):
    """A world as a file: its TOML, or a zip with its floor picture too."""

    filename: str
    content: bytes


class WorldDeleted(ToPage, frozen=True):
    """A world was moved to the trash; `RestoreWorld` restores it."""

    name: str
    title: str


class Scene(ToPage, monitor.Scene, frozen=True):
    """The unchanging parts of a world, for drawing it; `Telemetry` has the changing parts."""


class WorldToEdit(ToPage, frozen=True):
    """A world as in its file (`WorldFile`), and the corner points of its lines in mm.

    Args:
        save_as: its name if it belongs to the user, else a free one, so that no world is replaced.
        request: the number of the request to draw it; 0 opens it in the editor.
    """

    name: str
    world: WorldValues
    lines: tuple[tuple[tuple[float, float], ...], ...]
    save_as: str
    request: int = 0


class UnreachableGoal(Struct, frozen=True):
    """A goal that our robot can't reach.

    Args:
        sort: the kind of goal, as in a world's file.
        index: its place among the goals of this kind.
        reason: what is in the way, in words.
    """

    sort: str
    index: int
    reason: Phrase


class WorldChecked(ToPage, frozen=True):
    """The mistakes in a world; if there are none, `lines` as in `Scene`.

    Args:
        unreachable: the goals that our robot can't reach; the world can still be saved.
        request: the number of the request to save it.
    """

    problems: tuple[Phrase, ...]
    lines: tuple[tuple[tuple[float, float], ...], ...] = ()
    unreachable: tuple[UnreachableGoal, ...] = ()
    request: int = 0


class WorldMade(ToPage, frozen=True):
    """A world from a template, as in its file (`WorldFile`)."""

    world: WorldValues
