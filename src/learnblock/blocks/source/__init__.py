"""Blocks from Python source: a function's signature and type hints define its block."""
