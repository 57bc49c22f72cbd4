"""The first messages to a page: what it can choose from, and the names of tags."""

from learnblock.errors import LearnBlockError, phrase_of
from learnblock.i18n import Phrase
from learnblock.installation import version
from learnblock.perception import tag_names
from learnblock.server.catalog.examples import example_choices
from learnblock.server.catalog.robots import robot_choices
from learnblock.server.catalog.worlds import world_choices
from learnblock.server.messages import Tags, Welcome


def welcome(
    folder: str,
    read_only: Phrase | None = None,
    *,
    warns: bool = False,
    teaches: bool = False,
    address: str | None = None,
) -> Welcome:
    """Create the first message to a page.

    Args:
        folder: the projects folder.
        read_only: why nothing may be written; None if it may.
        warns: whether the page warns about missing limits for programs.
        teaches: whether the page may have what only the teacher has.
        address: the address by which other devices reach the server; None if they can't.
    """
    return Welcome(
        version=version(),
        robots=robot_choices(),
        worlds=world_choices(),
        examples=tuple(example_choices().values()),
        folder=folder,
        read_only=read_only,
        warns=warns,
        teaches=teaches,
        address=address,
    )


def tag_dictionary() -> Tags:
    """The tag names, or the reason why the user's file can't be read."""
    try:
        return Tags(dict(tag_names.tag_names()))
    except (LearnBlockError, OSError) as error:
        return Tags({}, phrase_of(error))
