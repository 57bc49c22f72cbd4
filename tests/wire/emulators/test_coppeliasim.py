"""CoppeliaSim's end of the wire, tested with the vendor's own client and with invalid data."""

import socket
from contextlib import closing

import cbor2
import pytest
from coppeliasim_zmqremoteapi_client import RemoteAPIClient
from hypothesis import given
from hypothesis import strategies as st

from learnblock.emulators.coppeliasim import Emulator
from learnblock.emulators.twin import Twin


@pytest.fixture(scope="module")
def emulator():
    with Twin("sim-ebo", "empty") as twin, closing(Emulator(twin)) as emulator:
        yield emulator


@pytest.fixture
def sim(emulator, monkeypatch):
    # The vendor's client leaves a function in the main module.
    monkeypatch.setattr("__main__.require", None, raising=False)
    client = RemoteAPIClient("127.0.0.1", emulator.port)
    client.socket.linger = 0
    yield client.require("sim")
    client.socket.close()
    client.context.term()


def test_the_vendors_client_finds_the_functions_and_constants_it_knows(sim):
    assert sim.getSimulationState() == sim.simulation_stopped == 0
    sim.startSimulation()
    assert sim.getSimulationState() == sim.simulation_advancing_running == 17
    sim.stopSimulation()


def test_a_client_that_requests_a_step_waits_until_it_is_made(emulator, sim):
    before = emulator._twin.time
    sim.step()
    assert emulator._twin.time >= before + 0.05


def test_missing_objects_give_coppeliasims_own_errors(sim):
    with pytest.raises(Exception, match="Object does not exist: /Robby"):
        sim.getObject("/Robby")
    with pytest.raises(Exception, match="Object does not exist: 999"):
        sim.getObjectMatrix(999)


def test_a_script_answers_only_while_the_simulation_runs(sim):
    script = sim.getScript(sim.scripttype_simulation, "/LearnBlock")
    with pytest.raises(Exception, match="the simulation is stopped"):
        sim.callScriptFunction("sense", script)


def test_several_values_are_returned_separately(sim):
    image, resolution = sim.getVisionSensorImg(sim.getObject("/Robot/camera"))
    assert len(image) == 3 * resolution[0] * resolution[1]


def test_a_client_of_the_first_protocol_gets_an_error(emulator):
    answer = cbor2.loads(emulator.answer(cbor2.dumps({"func": "sim.getObject", "args": ["/x"]})))
    assert answer["success"] is False


def test_a_port_that_is_taken_is_an_oserror(emulator):
    with pytest.raises(OSError, match="is already in use"):
        Emulator(emulator._twin, emulator.port)


REQUESTS = st.fixed_dictionaries(
    {
        "uuid": st.text(max_size=3),
        "func": st.sampled_from(
            ["sim.getObject", "sim.callScriptFunction", "sim.getObjectMatrix", "sim.step", "sim.x"]
        )
        | st.text(max_size=5),
        "args": st.recursive(
            st.none() | st.integers(-1, 20) | st.floats() | st.text(max_size=12) | st.binary(),
            lambda inner: st.lists(inner, max_size=4),
            max_leaves=6,
        ),
    }
)


@given(st.binary(max_size=60) | REQUESTS.map(cbor2.dumps))
def test_every_request_is_answered_by_a_table(emulator, request_bytes):
    assert isinstance(cbor2.loads(emulator.answer(request_bytes)), dict)


def test_data_that_is_not_zeromq_is_harmless(emulator, sim):
    with socket.create_connection(("127.0.0.1", emulator.port)) as stranger:
        stranger.sendall(b"GET / HTTP/1.1\r\n\r\n")
        assert sim.getSimulationState() == 0
