"""Who may see and change what is the teacher's."""

from learnblock.errors import LearnBlockError
from learnblock.server.pages.page import Page


def require_teacher(page: Page) -> None:
    """Check that the user is at the server's computer: pupils are at others.

    Raises:
        LearnBlockError: the user is at another one.
    """
    if not page.is_local:
        raise LearnBlockError("server-lesson-only-here")
