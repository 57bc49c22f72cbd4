"""Links that hold a project, and the hash of the run that it was shared with.

    http://127.0.0.1:8421/#share=1.PROJECT.FINGERPRINT

After the version come the project as JSON, deflated, and the hash of the trace; both in base64url.
The fragment of an address is never sent to a server, so the link itself is all there is. It is
read like any project from elsewhere: by `project_file.decode`, within limits.
"""

import binascii
import json
import re
import zlib
from base64 import urlsafe_b64decode, urlsafe_b64encode
from dataclasses import dataclass, replace
from typing import Annotated, Any, NoReturn

import msgspec
from msgspec import Meta, Raw, Struct

from learnblock import language
from learnblock.blocks.block_sets import EVERYTHING
from learnblock.errors import LearnBlockError, ProgramError
from learnblock.project.document.views import LONGEST_TEXT
from learnblock.project.files.packing import packed
from learnblock.project.files.project import LONGEST_NAME, Project, ProjectPart, checked_name
from learnblock.project.files.project_file import decode, encode
from learnblock.runtime.ending import How

#: The name of the link in the fragment of an address.
KEY = "share"
VERSION = 1
#: The maximum number of characters of a link without its address: messengers cut longer ones.
LONGEST_LINK = 8_000
#: The maximum number of characters of a text with a link in it.
LONGEST_INPUT = 2 * LONGEST_LINK
#: The maximum number of bytes that a link may become: programs become about four times larger.
LARGEST_INFLATED = 256 * 1024
MOST_VARIANTS = 9999

_LINK = re.compile(rf"(?:^|[#&?]{KEY}=)(\d{{1,4}})\.([\w-]+)(?:\.([\w-]+))?", re.ASCII)
#: Deflate without the head of a format, as browsers and `zlib` write it.
_RAW_DEFLATE = -15
_HASH_BYTES = 32


class LinkError(LearnBlockError, ValueError):
    """A link can't be read, or a project doesn't fit into one."""


class ProvedRun(Struct, frozen=True, array_like=True):
    """The run with which a project was shared.

    Args:
        seconds: how long it took, in the robot's time.
        ended: how it ended.
        version: the version of LearnBlock.
        trace_sha256: the hash of its trace.
    """

    seconds: Annotated[float, Meta(ge=0, le=1e9)]
    ended: How
    version: Annotated[str, Meta(max_length=40)]
    trace_sha256: Annotated[str, Meta(pattern="^[0-9a-f]{64}$")] = "0" * 64


class _Content(Struct, forbid_unknown_fields=True):
    """What a link holds besides the hash."""

    name: Annotated[str, Meta(min_length=1, max_length=LONGEST_NAME)]
    project: Raw
    variant: Annotated[int, Meta(ge=0, le=MOST_VARIANTS)] = 0
    run: ProvedRun | None = None


@dataclass(frozen=True)
class SharedProject:
    """A project as a link holds it.

    Args:
        project: the project, without the places of its blocks.
        variant: the number of the world's variant.
        run: the run with which it was shared; None if it had none that can be repeated.
    """

    project: Project
    variant: int = 0
    run: ProvedRun | None = None


_read_content = msgspec.json.Decoder(_Content).decode


def is_link(text: str) -> bool:
    """Whether a text is a link, perhaps a damaged one, rather than the path of a file."""
    return f"{KEY}=" in text or re.match(rf"{VERSION}\.[\w-]{{20}}", text, re.ASCII) is not None


def link_of(shared: SharedProject) -> str:
    """The link of a project, without an address.

    Raises:
        LinkError: the project is too large for a link.
        ProjectError: it can't be written as a file.
    """
    content: dict[str, Any] = {"name": shared.project.name}
    if shared.variant:
        content["variant"] = shared.variant
    if shared.run:
        content["run"] = [shared.run.seconds, shared.run.ended, shared.run.version]
    content["project"] = _values(shared.project)
    data = msgspec.json.encode(content)
    packer = zlib.compressobj(9, wbits=_RAW_DEFLATE)
    parts = [str(VERSION), _letters(packer.compress(data) + packer.flush())]
    if shared.run:
        parts.append(_letters(bytes.fromhex(shared.run.trace_sha256)))
    link = ".".join(parts)
    if len(link) > LONGEST_LINK or len(data) > LARGEST_INFLATED:
        raise LinkError("share-too-large", size=len(link), limit=LONGEST_LINK)
    return link


def bare(text: str) -> str:
    """A link without its address.

    Raises:
        LinkError: it is no link.
    """
    link = _match(text)[0]
    return link.rpartition("=")[2]


def read_link(text: str) -> SharedProject:
    """Read the project of a link.

    Args:
        text: the link, with any address or none; line breaks of an e-mail don't matter.

    Raises:
        LinkError: it is no link, a damaged one, or one of a newer LearnBlock.
        ProjectError: what it holds is not a valid project.
    """
    match = _match(text)
    content = _content_of(match)
    run = content.run and msgspec.structs.replace(content.run, trace_sha256=_hash(match[3]))
    project = decode(bytes(content.project), checked_name(content.name))
    return SharedProject(_complete(project), content.variant, run)


def linked_name(text: str) -> str:
    """The name of the project of a link, which may hold a project that can't be read.

    Raises:
        LinkError: it is no link, a damaged one, or one of a newer LearnBlock.
        ProjectError: the name is not valid.
    """
    return checked_name(_content_of(_match(text)).name)


def _content_of(match: re.Match[str]) -> _Content:
    if match[1] != str(VERSION):
        raise LinkError("share-version", version=match[1])
    return _content(_inflated(_bytes(match[2])))


def _match(text: str) -> re.Match[str]:
    if len(text) > LONGEST_INPUT:
        raise LinkError("share-too-long", limit=LONGEST_LINK)
    match = _LINK.search("".join(text.split()))
    if match is None:
        raise LinkError("share-no-link")
    return match


def _content(data: bytes) -> _Content:
    try:
        return _read_content(data)
    except (msgspec.MsgspecError, RecursionError, UnicodeError):
        _refuse()


def _bytes(letters: str) -> bytes:
    try:
        return urlsafe_b64decode(letters + "=" * (-len(letters) % 4))
    except (binascii.Error, ValueError):
        _refuse()


def _letters(data: bytes) -> str:
    return urlsafe_b64encode(data).rstrip(b"=").decode()


def _hash(letters: str | None) -> str:
    data = _bytes(letters or "")
    if len(data) != _HASH_BYTES:
        _refuse()
    return data.hex()


def _inflated(data: bytes) -> bytes:
    """What was deflated, never more than the limit, whatever the data says."""
    unpacker = zlib.decompressobj(wbits=_RAW_DEFLATE)
    try:
        inflated = unpacker.decompress(data, LARGEST_INFLATED + 1)
    except zlib.error:
        _refuse()
    if len(inflated) > LARGEST_INFLATED:
        raise LinkError("share-too-long", limit=LONGEST_LINK)
    if not unpacker.eof or unpacker.unused_data:
        _refuse()
    return inflated


def _refuse() -> NoReturn:
    raise LinkError("share-damaged") from None


def _values(project: Project) -> dict[str, Any]:
    """The project's file without what its reader finds out again."""
    shared = replace(project, shown=EVERYTHING, block_sets=())
    shared = packed(shared.with_parts([_without_layout(part) for part in shared.parts]), "")
    values: dict[str, Any] = json.loads(encode(shared))
    for part in (values, *values.get("others", ())):
        if not part.get("breakpoints"):
            part.pop("breakpoints", None)
    return values


def _without_layout(part: ProjectPart) -> ProjectPart:
    short = replace(part, workspace=None, breakpoints=())
    return replace(short, blocktext="") if _follows(part) else short


def _follows(part: ProjectPart) -> bool:
    """Whether the Block-Text is what its author's Python says."""
    return part.python is not None and _blocktext(part.python) == part.blocktext


def _complete(project: Project) -> Project:
    """Add the Block-Text of programs in Python.

    Raises:
        LinkError: a program is longer than any that can be edited.
    """
    parts = []
    for part in project.parts:
        if max(len(part.blocktext), len(part.python or "")) > LONGEST_TEXT:
            raise LinkError("share-too-long", limit=LONGEST_LINK)
        written = part.python if not part.blocktext else None
        parts.append(part if written is None else replace(part, blocktext=_blocktext(written)))
    return project.with_parts(parts)


def _blocktext(python: str) -> str:
    try:
        return language.format(language.from_python(python))
    except (ProgramError, RecursionError):
        # The page shows the mistakes in the Python itself.
        return ""
