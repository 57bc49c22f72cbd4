"""The modules of the build, which are beside the package and so on no path."""

import importlib.util
from types import ModuleType

from places import ROOT


def part_of_build(name: str) -> ModuleType:
    """Import one of them, such as ``hatch_weights``."""
    spec = importlib.util.spec_from_file_location(name, ROOT / f"{name}.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
