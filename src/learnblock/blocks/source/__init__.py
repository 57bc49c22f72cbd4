"""Blocks from Python source: what a function's signature and type hints say about its block."""
