"""The names of a zip's entries as their authors wrote them."""

import unicodedata
import zipfile

#: Set for names in UTF-8; names without it should be in code page 437, that of the first PCs.
_UTF_8 = 0x800


def entries(archive: zipfile.ZipFile) -> list[zipfile.ZipInfo]:
    """The entries of a zip, with their names as text in NFC.

    The zips of macOS, among others, have names in UTF-8 and don't say so.
    """
    found = archive.infolist()
    for entry in found:
        entry.filename = unicodedata.normalize("NFC", _decoded(entry))
    return found


def _decoded(entry: zipfile.ZipInfo) -> str:
    if entry.flag_bits & _UTF_8:
        return entry.filename
    try:
        # Hardly any text in another encoding is valid UTF-8 by chance.
        return entry.filename.encode("cp437").decode("utf-8")
    except UnicodeError:
        return entry.filename
