"""Four pictures as a PIN."""

from learnblock.classroom.pins import LENGTH, PICTURES, Pin, new_pictures


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
