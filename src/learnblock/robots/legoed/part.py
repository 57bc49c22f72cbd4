"""The connection to one device of LEGO Education."""

from collections.abc import Callable
from contextlib import suppress

from learnblock.closing import Closing
from learnblock.errors import LearnBlockError, RobotConnectionError
from learnblock.robots.bluetooth import Radio, ReportLink
from learnblock.robots.legoed import messages
from learnblock.robots.legoed.messages import Info, KitReport, Product
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

#: Milliseconds between two reports of a device; 15 is the shortest time that it takes.
INTERVAL = 30


class KitPart(Closing):
    """A device that reports by itself.

    Args:
        product: what it must be.
        address: its address.
        patience: the time limit in seconds for connecting, and for each answer.
        on_report: called with each report, in the thread of the connection.
        clock: the clock of its limits.

    Raises:
        RobotConnectionError: it can't be reached, or speaks another version; the error says why.
    """

    def __init__(
        self,
        product: Product,
        address: str,
        patience: float,
        on_report: Callable[[KitReport], None] = lambda _: None,
        clock: SteadyClock = MONOTONIC,
    ) -> None:
        self._patience = patience
        self._on_report = on_report
        self._info: Info | None = None
        self._radio = Radio("legoed", address, messages.SERVICE, clock, seconds=patience)
        self._reports: ReportLink[KitReport] = ReportLink(self._radio, clock)
        try:
            self._begin(product, Deadline.after(patience, clock))
        except BaseException:
            self._radio.close()
            raise

    @property
    def signal(self) -> int | None:
        """How strong its radio was when it was found, dBm."""
        return self._reports.signal

    @property
    def known(self) -> KitReport | None:
        """The last report, however old."""
        return self._reports.known

    def latest(self) -> KitReport:
        """A report that is at most 0.1 s old.

        Raises:
            RobotConnectionError: the device does not report any more.
        """
        return self._reports.latest()

    def say(self, message: bytes) -> None:
        """Send a message.

        Raises:
            RobotConnectionError: the connection is broken.
        """
        self._reports.check()
        self._radio.write(messages.COMMANDS, message, self._patience)

    def check(self) -> None:
        """Check that it reports.

        Raises:
            RobotConnectionError: it does not.
        """
        self._reports.check()

    def close(self, *farewell: bytes) -> None:
        """Send the last messages, and close the connection."""
        for message in farewell:
            # Not if the connection is broken.
            with suppress(LearnBlockError):
                self.say(message)
        self._reports.close()
        self._radio.close()

    def _begin(self, product: Product, deadline: Deadline) -> None:
        self._radio.hear(messages.EVENTS, self._note, deadline.left)
        self.say(messages.ask())
        if not self._reports.wait_for(lambda: self._info is not None, deadline.left):
            raise RobotConnectionError("robot-link-silent", place=self._reports.place)
        assert self._info  # noqa: S101 - it was waited for
        if self._info.product != product:
            raise self._unexpected()
        if not messages.fits(self._info):
            raise RobotConnectionError(
                "legoed-other-version",
                place=self._reports.place,
                device=".".join(map(str, self._info.version)),
                package=".".join(map(str, messages.version())),
                newer=str(self._info.version > messages.version()).lower(),
            )
        self.say(messages.report_every(INTERVAL))
        if not self._reports.wait_for(lambda: self.known is not None, deadline.left):
            raise RobotConnectionError("robot-link-silent", place=self._reports.place)

    def _note(self, message: bytes) -> None:
        """Take what the device sends, in the thread of the connection."""
        try:
            answer = messages.parsed(message)
        except ValueError:
            self._reports.fail(self._unexpected())
            return
        if isinstance(answer, Info):
            with self._reports.changed:
                self._info = answer
                self._reports.changed.notify_all()
        elif isinstance(answer, KitReport):
            self._on_report(answer)
            self._reports.note(answer)

    def _unexpected(self) -> RobotConnectionError:
        return RobotConnectionError("legoed-garbled", place=self._reports.place)
