"""Where ``from learnblock_home.robots.rover import Robot`` finds what it imports.

In the user's own folder. `learnblock run` needs none of this; ``python square.py`` does.
"""

from learnblock.home import home

__path__ = [str(home())]
