"""The weights for emotions are converted correctly, compared with another computation."""

import json

import cv2
import numpy as np
import pytest

from build_parts import part_of_build

CHANNELS = {"dense0": (3, 8), "dense1": (8, 12), "dense2": (12, 16), "dense3": (16, 20)}


@pytest.fixture(scope="module")
def maker():
    pytest.importorskip("onnx")
    return part_of_build("hatch_weights")


@pytest.fixture(scope="module")
def arrays():
    """Return weights of a net that is narrower than face-api's, and otherwise the same."""
    chance = np.random.default_rng(7)

    def some(*shape):
        return chance.normal(0, 0.3, shape).astype(np.float32)

    made = {"fc/weights": some(20, 7), "fc/bias": some(7)}
    for block, (before, after) in CHANNELS.items():
        for layer in range(4):
            into = before if layer == 0 else after
            name = f"{block}/conv{layer}"
            if (block, layer) == ("dense0", 0):
                made[f"{name}/filters"] = some(3, 3, into, after)
            else:
                made[f"{name}/depthwise_filter"] = some(3, 3, into, 1)
                made[f"{name}/pointwise_filter"] = some(1, 1, into, after)
            made[f"{name}/bias"] = some(after)
    return made


def padded(values, stride):
    """Pad a picture with zeros as TensorFlow's "same" does."""
    side = values.shape[0]
    total = max((-(-side // stride) - 1) * stride + 3 - side, 0)
    return np.pad(values, ((total // 2, total - total // 2),) * 2 + ((0, 0),))


def convolved(values, stride, step):
    """Return the sum of `step` over the nine positions of a filter."""
    around, side = padded(values, stride), -(-values.shape[0] // stride)
    reach = stride * (side - 1) + 1
    return sum(
        step(around[row : row + reach : stride, column : column + reach : stride], row, column)
        for row in range(3)
        for column in range(3)
    )


def separable(arrays, values, name, stride):
    depthwise = arrays[f"{name}/depthwise_filter"]
    values = convolved(values, stride, lambda part, y, x: part * depthwise[y, x, :, 0])
    return values @ arrays[f"{name}/pointwise_filter"][0, 0] + arrays[f"{name}/bias"]


def logits(arrays, values):
    """Compute the net of face-api (`denseBlock4`, `FaceFeatureExtractor`) in numpy."""
    for block in CHANNELS:
        if block == "dense0":
            filters = arrays["dense0/conv0/filters"]
            first = convolved(values, 2, lambda part, y, x, filters=filters: part @ filters[y, x])
            first = first + arrays["dense0/conv0/bias"]
        else:
            first = separable(arrays, values, f"{block}/conv0", 2)
        total = np.maximum(first, 0)
        values = total
        for layer in (1, 2, 3):
            total = total + separable(arrays, values, f"{block}/conv{layer}", 1)
            values = np.maximum(total, 0)
    return values.mean((0, 1)) @ arrays["fc/weights"] + arrays["fc/bias"]


def test_opencv_runs_the_converted_net_as_numpy_computes_it(maker, arrays):
    net = cv2.dnn.readNetFromONNX(np.frombuffer(maker.converted(arrays), np.uint8))
    face = np.random.default_rng(1).normal(0, 0.3, (112, 112, 3)).astype(np.float32)
    net.setInput(np.ascontiguousarray(face.transpose(2, 0, 1)[None]))
    assert net.forward()[0] == pytest.approx(logits(arrays, face), rel=1e-3, abs=1e-3)


def test_numbers_in_bytes_are_unpacked(maker):
    packing = {"dtype": "uint8", "scale": 0.5, "min": -1.0}
    entries = [
        {"name": "plain", "shape": [2], "dtype": "float32"},
        {"name": "packed", "shape": [1, 3], "dtype": "float32", "quantization": packing},
    ]
    manifest = json.dumps([{"weights": entries, "paths": ["numbers.bin"]}]).encode()
    numbers = np.array([1.5, -2], np.float32).tobytes() + bytes([0, 1, 4])
    found = maker.weights(manifest, numbers)
    assert {name: array.tolist() for name, array in found.items()} == {
        "plain": [1.5, -2.0],
        "packed": [[-1.0, -0.5, 1.0]],
    }


def test_a_file_other_than_the_checked_one_is_refused(maker, tmp_path):
    import tarfile

    folder = tmp_path / "package" / "model"
    folder.mkdir(parents=True)
    for name, _ in maker.SOURCES.values():
        (tmp_path / name).write_bytes(b"something else")
    archive = tmp_path / "package.tgz"
    with tarfile.open(archive, "w:gz") as files:
        files.add(tmp_path / "package", "package")
    with pytest.raises(RuntimeError, match="SHA-256"):
        maker.make(archive, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_existing_weights_are_not_built_again(maker, tmp_path):
    assert not maker.are_made(tmp_path)
    (tmp_path / maker.HASH_FILE).write_text(maker.sources_hash() + "\n")
    assert maker.are_made(tmp_path)
    (tmp_path / maker.HASH_FILE).write_text("of another version\n")
    assert not maker.are_made(tmp_path)
