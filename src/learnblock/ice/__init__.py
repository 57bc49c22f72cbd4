"""Ice, the protocol of RoboComp's components, in pure Python: types, encoding, proxies, servants.

    >>> from learnblock.ice import Adapter, Proxy, Servant
    >>> from learnblock.ice.robocomp import Layout, interfaces
    >>> base = interfaces(Layout.TOOL)["differentialrobot"]
    >>> class Wheels:
    ...     def setSpeedBase(self, adv, rot):
    ...         print(f"{adv} mm/s, {rot} rad/s")
    >>> with Adapter() as adapter:
    ...     port = adapter.serve({"differentialrobot": Servant(base, Wheels())})
    ...     with Proxy.parse(f"differentialrobot:tcp -h 127.0.0.1 -p {port}", base) as proxy:
    ...         proxy.call("setSpeedBase", 100.0, 0.5)
    100.0 mm/s, 0.5 rad/s

It implements Ice's protocol 1.0 over TCP with the encodings 1.0 and 1.1, as in ZeroC's manual,
chapter "The Ice Protocol", without the parts that RoboComp does not use: classes, proxies as
values, optional values, facets, batches, compression and TLS.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from learnblock.ice.interface import Interface, Operation
    from learnblock.ice.proxy import Proxy
    from learnblock.ice.server import Adapter, Servant

# Imported on first use: a client does not need the server's asyncio.
_HOME = {
    "Adapter": "server",
    "Interface": "interface",
    "Operation": "interface",
    "Proxy": "proxy",
    "Servant": "server",
}


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOME[name]}"), name)


__all__ = ["Adapter", "Interface", "Operation", "Proxy", "Servant"]
