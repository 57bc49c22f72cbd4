"""Where Python programs import names from, for messages about names that are not imported."""

import sys
import typing
from importlib import import_module

from learnblock.i18n import Phrase

_DEVICES, _FIELDS = "learnblock.devices", "learnblock.fields"


def missing_import(name: str, *, before_dot: bool) -> Phrase | None:
    """The message about a name that only has to be imported; None if we don't know from where.

    Args:
        name: the name.
        before_dot: whether it is used as a module, as in ``time.sleep(1)``.
    """
    if before_dot and name in sys.stdlib_module_names:
        return Phrase("python-not-imported", module=name)
    module = _module_of(name)
    return None if module is None else Phrase("python-not-imported-from", name=name, module=module)


def _module_of(name: str) -> str | None:
    if name in typing.__all__:
        return typing.__name__
    value = vars(import_module(_DEVICES)).get(name)
    if isinstance(value, type) and value.__module__.startswith(f"{_DEVICES}."):
        return _DEVICES
    # Most of these are other names of built-in types.
    return _FIELDS if name[0].isupper() and name in vars(import_module(_FIELDS)) else None
