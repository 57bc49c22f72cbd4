"""Any answer of CoppeliaSim, or of another server in its place, raises only our own errors."""

from contextlib import suppress

import cbor2
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from coppeliasim_answers import HEALTHY, SCENES, listed, use
from learnblock.errors import RobotConnectionError

VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=4) | st.binary(),
    lambda inner: st.lists(inner, max_size=16) | st.dictionaries(st.text(max_size=8), inner),
    max_leaves=20,
)
REPLIES = (
    st.sampled_from(HEALTHY).map(lambda value: {"ret": listed(value)})
    | st.lists(VALUES, max_size=4).map(lambda values: {"ret": values})
    | VALUES.map(lambda value: {"ret": value})
    | st.text(max_size=30).map(lambda text: {"err": text})
    | VALUES
).map(cbor2.dumps) | st.binary(max_size=60)


# No deadline: a client that is repeatedly asked to wait does so for a tenth of a second.
@pytest.mark.parametrize("scene", SCENES)
@given(answers=st.lists(REPLIES, min_size=1, max_size=8))
@example(answers=[cbor2.dumps({"ret": [float("nan")] * 12})])
@example(answers=[cbor2.dumps({"ret": [{"devices": ["Base"]}]}), b"\x9b" + b"\xff" * 8])
@example(answers=[b"\x81" * 2000])
@example(answers=[cbor2.dumps({"func": "_*wait*_", "args": []})])
@example(answers=[cbor2.dumps({"func": "_*repeat*_", "args": []})])
@example(answers=[cbor2.dumps({"func": "print", "args": ["I call you"]})])
@example(answers=[cbor2.dumps({"ret": [[10**400] * 12]})])
@example(answers=[cbor2.dumps({"ret": [[10**400], [10**400], [], ""]})])
@example(
    answers=[
        cbor2.dumps({"ret": [{"pose": [10**400] * 3}]}),
        cbor2.dumps({"ret": [{"devices": ["Base"]}]}),
    ]
)
def test_any_answer_raises_only_our_own_errors(scene, answers):
    with suppress(RobotConnectionError):
        use(scene, answers)
