"""LearnBlock's agent: it runs on a hub with Pybricks, and executes a remote program's commands.

The driver compiles this file with mpy-cross and sends it to the hub each time it connects, so it
is written for MicroPython and for the modules that are documented at docs.pybricks.com. It is one
file because a hub runs one.

The hub's standard input and output are lines of text. The first one says which ports the user
chose, and names no port where any will do. The agent answers with the protocol and the ports where
it found the motors and sensors, or with an error:

    ports left=A right=B
    learnblock 1 left=A right=B distance=C colour=D force=
    error no-motor left A

Then it reports its state 30 times a second: degrees that the wheels have turned, forward positive,
the heading in tenths of a degree, clockwise positive, mm, % of reflected light, whether the force
sensor is pressed, and the battery in mV; "-" where there is no such sensor or it was unplugged.

    s 120 118 -45 2000 87 0 8123

These are the commands:

    d 143 -143       degrees/s of the left and the right wheel
    b 440 500        beep: hertz, milliseconds
    t hello          show a text on the light matrix, letter by letter, or nothing
    l 240 100 100    the status light's hue, saturation and brightness
    p                still there

The motors stop if no line arrives for 0.3 s, until the next drive command. After 1.5 s the agent
ends, and with it the sound and the light.
"""

from pybricks.hubs import PrimeHub
from pybricks.iodevices import PUPDevice
from pybricks.parameters import Color, Direction, Port
from pybricks.pupdevices import ColorSensor, ForceSensor, Motor, UltrasonicSensor
from pybricks.tools import StopWatch, wait
from uselect import poll
from usys import stdin

PORTS = "ABCDEF"
#: Milliseconds of silence until the motors stop, and until the agent ends.
SILENCE, ABSENCE = 300, 1500
#: Milliseconds between two reports, and between two looks at the input.
PERIOD, STEP = 33, 5
#: Milliseconds for which a letter is shown, and then none.
LETTER, GAP = 500, 50
#: The maximum number of bytes of a line.
LONGEST_LINE = 200
#: The devices' numbers in LEGO's protocol: SPIKE's medium, large and small motor, and those that
#: came with Technic and the Robot Inventor.
MOTORS = (48, 49, 65, 75, 76, 46, 47)
SENSORS = {
    "distance": (62, UltrasonicSensor),
    "colour": (61, ColorSensor),
    "force": (63, ForceSensor),
}


class AgentError(Exception):
    """An error that ends the agent: the words of its line."""


class Devices:
    """The motors and sensors at the hub's ports.

    Args:
        wishes: the ports that the user chose, by the name of the device; "" is any port.
    """

    def __init__(self, wishes):
        self.plugged = {port: number_at(port) for port in PORTS}
        self.ports = {}
        self.left = self.motor("left", wishes, Direction.COUNTERCLOCKWISE)
        self.right = self.motor("right", wishes, Direction.CLOCKWISE)
        self.sensors = {name: self.sensor(name, wishes) for name in SENSORS}

    def motor(self, name, wishes, direction):
        port = self.find(name, wishes, MOTORS)
        if not port:
            raise AgentError("no-motor {} {}".format(name, wishes.get(name, "")))
        return Motor(getattr(Port, port), direction)

    def sensor(self, name, wishes):
        number, kind = SENSORS[name]
        port = self.find(name, wishes, (number,))
        if port:
            return kind(getattr(Port, port))
        if wishes.get(name):
            raise AgentError("no-sensor {} {}".format(name, wishes[name]))
        return None

    def find(self, name, wishes, numbers):
        """The port of a device with one of these numbers; each port has one device."""
        wish = wishes.get(name) or PORTS
        for port in wish:
            if self.plugged[port] in numbers and port not in self.ports.values():
                self.ports[name] = port
                return port
        return ""


def number_at(port):
    """The number of the device that is plugged in there; 0 if there is none."""
    try:
        return PUPDevice(getattr(Port, port)).info()["id"]
    except OSError:
        return 0


def reading(measure):
    """A sensor's reading as a word; "-" if its cable is unplugged."""
    try:
        return str(int(measure()))
    except OSError:
        return "-"


class Arrivals:
    """The lines that arrive."""

    def __init__(self):
        self.line = b""
        self.keyboard = poll()
        self.keyboard.register(stdin)

    def lines(self):
        """The lines that have arrived since the last call."""
        complete = []
        while self.keyboard.poll(0):
            byte = stdin.buffer.read(1)
            if not byte:
                break
            if byte == b"\n":
                complete.append(self.line)
                self.line = b""
            else:
                self.line = (self.line + byte)[-LONGEST_LINE:]
        return complete

    def first(self):
        """The first line; empty if none arrives."""
        watch = StopWatch()
        while watch.time() < ABSENCE:
            lines = self.lines()
            if lines:
                return lines[0]
            wait(STEP)
        return b""


class Agent:
    """Reads lines, and reports the state.

    Args:
        hub: the hub.
        devices: its motors and sensors.
        arriving: the lines that arrive.
    """

    def __init__(self, hub, devices, arriving):
        self.hub = hub
        self.devices = devices
        self.arriving = arriving
        self.watch = StopWatch()
        self.heard = self.reported = self.watch.time()
        self.moves = False
        self.sound_ends = None
        self.letters = ""
        self.next_letter = 0

    def run(self):
        """Serve until nothing has been heard for `ABSENCE`."""
        while self.watch.time() - self.heard < ABSENCE:
            self.listen()
            now = self.watch.time()
            if self.moves and now - self.heard >= SILENCE:
                self.drive(0, 0)
            if self.sound_ends is not None and now >= self.sound_ends:
                self.hush()
            self.spell(now)
            if now - self.reported >= PERIOD:
                self.reported = now
                self.report()
            wait(STEP)

    def close(self):
        """Stop everything."""
        self.drive(0, 0)
        self.hush()
        self.hub.display.off()

    def listen(self):
        """Execute each line that has arrived."""
        for line in self.arriving.lines():
            self.heard = self.watch.time()
            try:
                self.execute(line.decode())
            except ValueError:
                # A line that is not of this protocol changes nothing.
                continue

    def execute(self, line):
        word, _, rest = line.partition(" ")
        if word == "d":
            left, right = numbers(rest, 2)
            self.drive(left, right)
        elif word == "b":
            hertz, milliseconds = numbers(rest, 2)
            self.beep(hertz, milliseconds)
        elif word == "t":
            self.letters, self.next_letter = rest, self.watch.time()
            self.hub.display.off()
        elif word == "l":
            self.hub.light.on(Color(*numbers(rest, 3)))

    def drive(self, left, right):
        self.moves = bool(left or right)
        self.turn(self.devices.left, left, "left")
        self.turn(self.devices.right, right, "right")

    def turn(self, motor, speed, name):
        try:
            if speed:
                motor.run(speed)
            else:
                motor.brake()
        except OSError:
            raise AgentError("motor-lost " + name)

    def beep(self, hertz, milliseconds):
        # A duration would let the hub wait for its end.
        self.hub.speaker.beep(min(max(hertz, 64), 24000), -1)
        self.sound_ends = self.watch.time() + milliseconds

    def hush(self):
        if self.sound_ends is not None:
            self.sound_ends = None
            self.hub.speaker.beep(64, 0)

    def spell(self, now):
        """Show the next letter when it is due: `display.text` would wait for its end."""
        if not self.letters or now < self.next_letter:
            return
        letter, self.letters = self.letters[0], self.letters[1:]
        if letter == " ":
            self.hub.display.off()
        else:
            self.hub.display.char(letter)
        self.next_letter = now + LETTER + GAP

    def report(self):
        devices = self.devices
        sensors = devices.sensors
        distance, colour, force = (sensors[name] for name in ("distance", "colour", "force"))
        print(
            "s",
            reading(devices.left.angle),
            reading(devices.right.angle),
            reading(lambda: 10 * self.hub.imu.heading()),
            reading(distance.distance) if distance else "-",
            reading(colour.reflection) if colour else "-",
            reading(force.pressed) if force else "-",
            reading(self.hub.battery.voltage),
        )


def numbers(text, count):
    """So many whole numbers."""
    values = [int(word) for word in text.split()]
    if len(values) != count:
        raise ValueError(text)
    return values


def main():
    arriving = Arrivals()
    try:
        serve(Devices(wished(arriving.first().decode())), arriving)
    except AgentError as error:
        print("error", error)


def wished(line):
    """The ports that the user chose, by the name of the device."""
    wishes = {}
    for word in line.split()[1:]:
        name, _, port = word.partition("=")
        wishes[name] = port
    return wishes


def serve(devices, arriving):
    """Serve the driver until it is gone."""
    places = ("left", "right", "distance", "colour", "force")
    print("learnblock 1", *("{}={}".format(name, devices.ports.get(name, "")) for name in places))
    agent = Agent(PrimeHub(), devices, arriving)
    try:
        agent.run()
    finally:
        agent.close()


main()
