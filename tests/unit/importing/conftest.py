"""What the tests of imports share."""

from collections.abc import Callable

import pytest

from learnblock.blocks import builtin
from learnblock.importing import Imported, import_project


@pytest.fixture
def imported() -> Callable[[bytes], Imported]:
    return lambda data: import_project(data, "old.blockProject", builtin())
