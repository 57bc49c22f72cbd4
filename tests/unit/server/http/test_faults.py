"""What repeated faults print is said once."""

import asyncio
import logging

import pytest

from clocks import Clock
from learnblock.server.http.faults import SaidOnce, faults_said_once


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def said(clock):
    """A logger, and what it has printed."""
    printed = []
    once = SaidOnce(clock)
    logger = logging.Logger("test")

    class Printing(logging.Handler):
        def emit(self, record):
            printed.append(record.getMessage())

    handler = Printing()
    handler.addFilter(once)
    logger.addHandler(handler)
    return logger, printed


def test_a_fault_is_said_once_a_minute_with_its_count(said, clock):
    logger, printed = said
    for _ in range(1000):
        logger.warning("Invalid HTTP request received.")
    assert printed == ["Invalid HTTP request received."]
    clock.time += 61
    logger.warning("Invalid HTTP request received.")
    assert printed[1:] == ["Invalid HTTP request received. (999 times more since)"]


def test_details_make_no_other_fault(said):
    logger, printed = said
    logger.error("accept failed on <socket fd=%d at 0x7f01>", 7)
    logger.error("accept failed on <socket fd=%d at 0x8abc>", 8)
    assert len(printed) == 1


def test_other_faults_are_said(said):
    logger, printed = said
    logger.warning("one")
    logger.warning("other")
    for error in (ValueError("a"), KeyError("a"), KeyError("b")):
        logger.error("failed", exc_info=error)
    assert printed == ["one", "other", "failed", "failed", "failed"]


def test_memory_for_faults_is_bounded(said):
    logger, printed = said
    for number in range(150):
        logger.warning("fault %s", "x" * number)
    assert len(printed) == 150
    (handler,) = logger.handlers
    assert len(handler.filters[0]._faults) == 100


def test_a_request_that_the_end_of_the_server_cuts_off_is_no_fault(capsys):
    with faults_said_once():
        for error in (asyncio.CancelledError(), ValueError("a")):
            logging.getLogger("uvicorn.error").error("in the application", exc_info=error)
    said = capsys.readouterr().err
    assert "ValueError" in said
    assert "CancelledError" not in said
