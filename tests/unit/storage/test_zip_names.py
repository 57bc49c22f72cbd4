"""The names in a zip are those that its author saw."""

import io
import unicodedata
import zipfile

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.storage import zip_names

NAMES = st.text(
    st.characters(codec="utf-8", exclude_characters="\0/\\", exclude_categories=["Cs"]),
    min_size=1,
    max_size=30,
)


def names(raw, *, flag):
    """The names that are read from a zip with a name of these bytes."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        archive.writestr("x" * len(raw), "")
    written = bytearray(data.getvalue().replace(b"x" * len(raw), raw))
    if flag:
        written[7] |= 8
        written[written.index(b"PK\1\2") + 9] |= 8
    with zipfile.ZipFile(io.BytesIO(bytes(written))) as archive:
        return [entry.filename for entry in zip_names.entries(archive)]


@given(NAMES.filter(lambda name: "x" not in name))
def test_a_name_in_utf_8_is_right_with_and_without_the_flag(name):
    expected = [unicodedata.normalize("NFC", name)]
    assert names(name.encode(), flag=True) == names(name.encode(), flag=False) == expected


@pytest.mark.parametrize("name", ["José", "Ü", "plain.bt", "½"])
def test_a_name_of_the_first_pcs_stays(name):
    assert names(name.encode("cp437"), flag=False) == [name]
