"""Bluetooth Low Energy for drivers: find a robot, and read, write and hear its characteristics.

    def connect(self):
        self.radio = Radio("spike", self.settings.address, SERVICE, self.steady_clock)
        self.radio.hear(EVENTS, self.note_event, seconds=2)
        self.add(Base(self.move))

    def move(self, adv, rot):
        self.radio.write(COMMANDS, packed(adv, rot), seconds=1)

`bleak` does the work; it is part of the add-on of each robot that needs it, and imported only when
such a robot is looked for or connected. An address such as ``127.0.0.1:18816`` is that of an
emulator on this computer, which is reached by a back end of bleak's in
`learnblock.robots.bluetooth.loopback`.
"""

from learnblock.robots.bluetooth.finding import scan
from learnblock.robots.bluetooth.radio import Radio
from learnblock.robots.bluetooth.report_link import ReportLink
from learnblock.robots.bluetooth.standby import standby

__all__ = ["Radio", "ReportLink", "scan", "standby"]
