"""All messages between the server and a page.

A page first sends `Open` or `New`; all other messages are about the project that it has opened.
Each message is a JSON object with a `kind`; only camera frames are binary (see `CameraFrame`).
The build writes the page's types from this module (`learnblock.server.typescript`).

A message is named once, in the module of its subject, and its base says who may send it.
"""

from functools import reduce
from operator import or_
from typing import Any

from learnblock.server.messages.base import *
from learnblock.server.messages.block_sets import *
from learnblock.server.messages.carrying import *
from learnblock.server.messages.class_lessons import *
from learnblock.server.messages.classes import *
from learnblock.server.messages.connecting import *
from learnblock.server.messages.containment import *
from learnblock.server.messages.custom_blocks import *
from learnblock.server.messages.guests import *
from learnblock.server.messages.kept import *
from learnblock.server.messages.lesson_editor import *
from learnblock.server.messages.lessons import *
from learnblock.server.messages.libraries import *
from learnblock.server.messages.looking import *
from learnblock.server.messages.program import *
from learnblock.server.messages.projects import *
from learnblock.server.messages.robots import *
from learnblock.server.messages.running import *
from learnblock.server.messages.seats import *
from learnblock.server.messages.settings import *
from learnblock.server.messages.sharing import *
from learnblock.server.messages.tabs import *
from learnblock.server.messages.tags import *
from learnblock.server.messages.worlds import *

#: Every message of a direction, as one type.
FROM_PAGE: Any = reduce(
    or_, [kind for role in FromPage.__subclasses__() for kind in role.__subclasses__()]
)
TO_PAGE: Any = reduce(or_, ToPage.__subclasses__())
