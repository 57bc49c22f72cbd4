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

What is spoken is Ice's protocol 1.0 over TCP with the encodings 1.0 and 1.1, as in ZeroC's manual,
chapter "The Ice Protocol", without what RoboComp has no use for: classes, proxies as values,
optional values, facets, batches, compression and TLS.
"""

from learnblock.ice.interface import Interface, Operation
from learnblock.ice.proxy import Proxy
from learnblock.ice.server import Adapter, Servant

__all__ = ["Adapter", "Interface", "Operation", "Proxy", "Servant"]
