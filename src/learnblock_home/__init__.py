"""The user's folder as a package, for ``from learnblock_home.robots.rover import Robot``.

``python square.py`` needs it; `learnblock run` does not.
"""

from learnblock.storage.home import home

__path__ = [str(home())]
