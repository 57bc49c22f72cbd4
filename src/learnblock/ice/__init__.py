"""Ice, the protocol of RoboComp's components, in pure Python: types, encoding, proxies, servants."""
