"""Four pictures as a PIN."""

from learnblock.classroom import pins
from learnblock.classroom.pins import LENGTH, PICTURES, Pin, new_pictures

#: Scrypt's hash at the cost of RFC 7914's interactive logins, by hashlib.
HASHED = (
    "931d77bd0cc7928ff324fe3b05bc5adafc5ce011dfb7f8da7fb86b9f10c8d9d9"
    "aa0288406b41a014184a9e64de1dc3d2486e16f852708574a121ecd803410f74"
)


def test_a_new_pin_has_four_different_pictures():
    for _ in range(50):
        pictures = new_pictures()
        assert len(set(pictures)) == LENGTH
        assert set(pictures) <= set(PICTURES)


def test_a_pin_fits_its_pictures_in_their_order_only():
    pin = Pin.of(("cloud", "star", "tree", "sun"))
    assert pin.fits(("cloud", "star", "tree", "sun"))
    assert not pin.fits(("star", "cloud", "tree", "sun"))
    assert not pin.fits(("cloud", "star", "tree", "moon"))


def test_a_pin_does_not_contain_its_pictures():
    pin = Pin.of(("cloud", "star", "tree", "sun"))
    assert "cloud" not in repr(pin)
    assert pin.hashed != Pin.of(("cloud", "star", "tree", "sun")).hashed


def test_a_pin_of_an_earlier_class_still_fits_and_is_as_costly_to_guess(quick_pins, monkeypatch):
    monkeypatch.setattr(pins, "COST", quick_pins)
    assert Pin("00ff", HASHED).fits(("cloud", "star", "tree", "sun"))
