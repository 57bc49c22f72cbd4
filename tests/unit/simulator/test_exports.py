import subprocess
import sys

import pytest

from learnblock import simulator


def test_every_exported_name_exists() -> None:
    assert all(getattr(simulator, name) for name in simulator.__all__)


def test_a_missing_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="has no attribute 'Wrld'"):
        _ = simulator.Wrld


def test_a_robot_description_is_read_without_physics_or_pictures() -> None:
    program = (
        "import sys\n"
        "from learnblock.simulator import load_robot\n"
        "load_robot('ebo')\n"
        "print({'cv2', 'numpy', 'pymunk'} & set(sys.modules))\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, check=True)

    assert done.stdout.split() == [b"set()"]
