"""The tag names that are sent to pages."""

from learnblock.errors import LearnBlockError
from learnblock.perception import tag_names
from learnblock.server.messages import Tags
from learnblock.server.messages.problems import phrase_of


def tag_dictionary() -> Tags:
    """The tag names, or the reason why the user's file can't be read."""
    try:
        return Tags(dict(tag_names.tag_names()))
    except (LearnBlockError, OSError) as error:
        return Tags({}, phrase_of(error))
