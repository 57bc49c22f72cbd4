"""Recode a JPEG file with one pair of Huffman tables for all its components.

Encoders use one pair for brightness and another for colours. Cozmo uses the first pair for all, so
that its receiver can use the same header for all pictures.
"""

import struct
from collections.abc import Iterator, Mapping
from functools import cache

DHT, SOS, END = 0xC4, 0xDA, b"\xff\xd9"

#: Symbols by their codes, strings of 0 and 1.
Table = Mapping[str, int]


def scan(file: bytes) -> bytes:
    """The coded pixels of a file, without the zeros that escape bytes of 255."""
    return _parts(file)[1].removesuffix(END).replace(b"\xff\0", b"\xff")


def with_one_pair_of_tables(file: bytes, width: int, height: int) -> bytes:
    """The pixels of a coloured file, recoded with one pair of tables.

    Args:
        file: a JPEG file with 4:2:2 subsampling and the standard tables.
        width: the width in pixels, a multiple of 16.
        height: the height in pixels, a multiple of 8.
    """
    tables = _tables(_parts(file)[0])
    coded = scan(file)
    bits = f"{int.from_bytes(coded, 'big'):0{8 * len(coded)}b}"
    units = width // 16 * height // 8
    recoded = "".join(_recoded(bits, tables, units))
    recoded += "1" * (-len(recoded) % 8)
    return int(recoded, 2).to_bytes(len(recoded) // 8, "big")


def _recoded(bits: str, tables: Mapping[int, Table], units: int) -> Iterator[str]:
    """All blocks coded by the luminance tables: each code with the bits that follow it."""
    codes = {kind: {symbol: code for code, symbol in tables[kind].items()} for kind in (0x00, 0x10)}
    at = 0
    for table in (0, 0, 1, 1) * units:
        index = 0
        while index < 64:
            # The first of the 64 numbers of a block has its own table.
            kind = 0x10 if index else 0x00
            symbol, at = _symbol(bits, at, tables[kind | table])
            size = symbol & 0x0F
            yield codes[kind][symbol] + bits[at : at + size]
            at += size
            ends = kind and symbol == 0
            index = 64 if ends else index + 1 + (symbol >> 4 if kind else 0)


def _symbol(bits: str, at: int, table: Table) -> tuple[int, int]:
    """The next symbol, and the position after its code."""
    end = at + 1
    while (code := bits[at:end]) not in table:
        end += 1
        if end - at > 16:
            raise ValueError("the bits of the picture match no code of its tables")
    return table[code], end


def _parts(file: bytes) -> tuple[bytes, bytes]:
    """The header and the coded pixels of a file."""
    at = 2
    while file[at + 1] != SOS:
        at += 2 + _length(file, at)
    start = at + 2 + _length(file, at)
    return file[:at], file[start:]


def _length(file: bytes, at: int) -> int:
    length: int = struct.unpack_from(">H", file, at + 2)[0]
    return length


@cache
def _tables(header: bytes) -> Mapping[int, Table]:
    """The tables by number: 0 and 1 for a block's first number, 16 and 17 for the others."""
    tables: dict[int, Table] = {}
    at = 2
    while at < len(header):
        if header[at + 1] == DHT:
            tables.update(_segment(header[at + 4 : at + 2 + _length(header, at)]))
        at += 2 + _length(header, at)
    return tables


def _segment(content: bytes) -> Iterator[tuple[int, Table]]:
    while content:
        counts = content[1:17]
        symbols = content[17 : 17 + sum(counts)]
        yield content[0], dict(zip(_codes(counts), symbols, strict=True))
        content = content[17 + sum(counts) :]


def _codes(counts: bytes) -> Iterator[str]:
    """The codes of a table, from the number of codes of each length."""
    code = 0
    for length, count in enumerate(counts, start=1):
        for _ in range(count):
            yield f"{code:0{length}b}"
            code += 1
        code <<= 1
