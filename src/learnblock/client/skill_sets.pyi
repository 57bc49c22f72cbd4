"""The skills of each robot, written from their source: `scripts/docs`."""

from collections.abc import Mapping
from learnblock.devices import Frame, Pose
from typing import Any, Literal
from learnblock_home.own_skills import OwnSkills

class _NeedsNothing:
    """Skills that need nothing."""

    def cozmoBored(self) -> None:
        """Start acting bored; the program continues meanwhile."""

    def cozmoCat(self) -> None:
        """Start acting like a cat; the program continues meanwhile."""

    def cozmoDances(self) -> None:
        """Start dancing; the program continues meanwhile."""

    def cozmoDog(self) -> None:
        """Start acting like a dog; the program continues meanwhile."""

    def cozmoDuck(self) -> None:
        """Start acting like a duck; the program continues meanwhile."""

    def cozmoElephant(self) -> None:
        """Start acting like an elephant; the program continues meanwhile."""

    def cozmoIdle(self) -> None:
        """Start looking around and moving a little; the program continues meanwhile."""

    def cozmoSheep(self) -> None:
        """Start acting like a sheep; the program continues meanwhile."""

    def cozmoSleep(self) -> None:
        """Start falling asleep; the program continues meanwhile."""

    def cozmoSneezes(self) -> None:
        """Start sneezing; the program continues meanwhile."""

    def cozmoVampire(self) -> None:
        """Start acting like a vampire; the program continues meanwhile."""

    def cozmoZombie(self) -> None:
        """Start acting like a zombie; the program continues meanwhile."""

    def expressJoy(self) -> None:
        """Look happy."""

    def expressSadness(self) -> None:
        """Look sad."""

    def expressSurprise(self) -> None:
        """Look surprised."""

    def expressDisgust(self) -> None:
        """Look disgusted."""

    def expressAnger(self) -> None:
        """Look angry."""

    def expressFear(self) -> None:
        """Look scared."""

    def expressNeutral(self) -> None:
        """Show no emotion."""

    def is_Joy(self) -> bool:
        """Does the robot look happy?"""

    def is_Sadness(self) -> bool:
        """Does the robot look sad?"""

    def is_Surprised(self) -> bool:
        """Does the robot look surprised?"""

    def is_Disgust(self) -> bool:
        """Does the robot look disgusted?"""

    def is_Angry(self) -> bool:
        """Does the robot look angry?"""

    def is_Scared(self) -> bool:
        """Does the robot look scared?"""

    def is_Neutral(self) -> bool:
        """Does the robot look neutral after `expressNeutral`?"""

    def change_score(self, points: float = 1) -> None:
        """Change the score of the game.

        Args:
            points: what is added to it; a negative number is taken away.
        """

    def set_score(self, score: float = 0) -> None:
        """Set the score of the game.

        Args:
            score: the new score.
        """

    def get_score(self) -> float:
        """The score of the game: what the world and the program have added to it."""

    def show_score(self) -> None:
        """Show the score on the robot's screen; a real robot without a screen prints it.

        In a world with a game, the page shows the score anyway.
        """

    def change_lives(self, lives: float = -1) -> None:
        """Change the number of lives; without any left, the game is over.

        A game that has not said how many there are begins with three.

        Args:
            lives: how many are added; a negative number is taken away.
        """

    def set_lives(self, lives: float = 3) -> None:
        """Set the number of lives.

        Args:
            lives: how many there are.
        """

    def get_lives(self) -> float:
        """The lives that are left."""

    def start_countdown(self, seconds: float = 60) -> None:
        """Begin a countdown, instead of the one before. It belongs to all robots of the world.

        Args:
            seconds: how long it takes.
        """

    def get_time_left(self) -> float:
        """The seconds until the countdown ends; 0 after that, and without a countdown."""

    def is_time_up(self) -> bool:
        """Has the countdown ended? Answered with yes once for each countdown."""

    def collected(self, kind: str = "star") -> bool:
        """Has the robot collected such a thing? Each one is answered with yes once.

        On a real robot, and in a world without such things, nothing is collected.

        Args:
            kind: what it is, such as star, or anything.
        """

    def win_game(self) -> None:
        """Win the game, which ends the programs of all its robots."""

    def game_over(self) -> None:
        """End the game without winning it, and the programs of all its robots."""

    def is_key_pressed(self, key: str = "space") -> bool:
        """Is this key of the keyboard held down?

        Args:
            key: up, down, left, right, space, enter, a letter from a to z or a digit from 0 to 9.

        Raises:
            UnknownNameError: there is no such key.
        """

    def led(self, intensity: bool | float, slot: str = "first") -> None:
        """Switch an LED on or off; a coloured one is white when it is on.

        Args:
            intensity: False switches it off and True on; so do 0 and any number above.
            slot: which LED, by its position, such as ``Left``; ``first`` is any robot's first.
        """

    def RGBled(self, red: int, green: int, blue: int, slot: str = "first") -> None:
        """Set the colour of an LED.

        Args:
            red: 0 to 255.
            green: 0 to 255.
            blue: 0 to 255.
            slot: which LED, by its position, such as ``Left``; ``first`` is any robot's first.
        """

    def matrix_number(self, number: float, intensity: int = 4) -> None:
        """Show a number on the LED matrix; without one, as `show_number` does.

        Args:
            number: what to show.
            intensity: brightness of the LEDs, 0 to 7.
        """

    def matrix_text(self, text: str, intensity: int = 4, column: int = 0) -> None:
        """Show text on the LED matrix; without one, as `show_text` does.

        Args:
            text: what to show.
            intensity: brightness of the LEDs, 0 to 7.
            column: of the LEDs, 0 to 15 from the left, where the text starts.
        """

    def matrix_icon(self, icon: str, intensity: int = 4) -> None:
        """Show an icon on the LED matrix.

        Args:
            icon: the icon's name.
            intensity: brightness, 0 to 7.
        """

    def send(self, message: str = "go", value: str | None = None) -> None:
        """Send a message to all other robots.

        Args:
            message: the name of the message, such as "go".
            value: a number, a text, true or false, or a list of these that goes with it.
        """

    def received(self, message: str = "go") -> bool:
        """Has another robot sent this message? Each message is answered with yes once.

        Args:
            message: the name of the message.
        """

    def message_value(self, message: str = "go") -> Any:
        """What came with the message that was received last; None before the first one.

        Args:
            message: the name of the message.
        """

    def down_camera(self, angle: float = 10) -> None:
        """Tilt the camera down from where it points.

        Args:
            angle: degrees.
        """

    def look_floor(self) -> None:
        """Look at the floor: tilt the camera 30 degrees down."""

    def look_front(self) -> None:
        """Look straight ahead."""

    def look_up(self) -> None:
        """Look up: tilt the camera 30 degrees up."""

    def setAngleCamera(self, angle: float) -> None:
        """Tilt the camera.

        Args:
            angle: degrees; 0 is straight ahead, positive is up.
        """

    def up_camera(self, angle: float = 10) -> None:
        """Tilt the camera up from where it points.

        Args:
            angle: degrees.
        """

    def select_audio(self, folder: int, song: int) -> None:
        """Choose the song that the music player plays.

        Args:
            folder: the number of the folder the song is in.
            song: its number in the folder.
        """

    def send_action(self, action: str = "Play") -> None:
        """Press a button of the music player.

        Args:
            action: what to do, such as ``Play`` or ``Pause``.
        """

    def modify_volume(self, volume: int = 5) -> None:
        """Make the music louder or softer.

        Args:
            volume: 0 (silent) to 100.
        """

    def modify_EQ(self, EQ: str = "NO") -> None:
        """Change the sound of the music.

        Args:
            EQ: the equalizer's setting, such as ``NO``, ``Pop`` or ``Rock``.
        """

    def modify_loop(self, loop: str = "Loop all") -> None:
        """Choose what the music player repeats.

        Args:
            loop: what to repeat, such as ``Loop all``.
        """

    def play_note(self, note: str = "C4", beats: float = 1) -> None:
        """Play a note, then continue with the program.

        A robot without a loudspeaker waits as long.

        Args:
            note: the English name with the octave, from C0 to B8: C4 is middle C (do), F#4 is higher
                and Bb3 lower by a semitone.
            beats: how long; `set_tempo` sets how long a beat is.

        Raises:
            UnknownNameError: there is no such note.
        """

    def rest(self, beats: float = 1) -> None:
        """Stay silent, then continue with the program.

        Args:
            beats: how long; `set_tempo` sets how long a beat is.
        """

    def set_tempo(self, bpm: float = 120) -> None:
        """Set how fast notes are played; without this it is 120 beats per minute.

        Args:
            bpm: beats per minute, 20 to 500.
        """

    def sleep(self, seconds: float = 1) -> None:
        """Wait; meanwhile the robot keeps moving.

        Args:
            seconds: how long to wait.
        """

    def elapsedTime(self, seconds: float) -> bool:
        """Has the program been running for longer than this?

        Args:
            seconds: since it started.
        """

    def reset_timer(self) -> None:
        """Start the timer again at 0."""

    def get_timer(self) -> float:
        """How many seconds have passed since the last `reset_timer`, or since the program started?"""

    def show_text(self, text: str = "hello") -> None:
        """Show a text on the robot's screen, instead of what was there.

        In a world, the text of a robot without a screen is beside it. A real robot without a screen
        prints it.

        Args:
            text: at most 100 characters; the rest is cut.
        """

    def show_number(self, value: float = 0) -> None:
        """Show a number on the robot's screen, instead of what was there.

        Args:
            value: the number; it is rounded to two decimals.
        """

    def clear_screen(self) -> None:
        """Clear the robot's screen."""

    def say_Text(self, text: str) -> None:
        """Start saying something aloud; the program continues meanwhile.

        Args:
            text: what to say.
        """

    def play_audio(self, audio: str = "Do") -> None:
        """Start a sound; the program continues meanwhile.

        Args:
            audio: a sound effect, such as coin, a note, such as Do, or one of the robot's own sounds.
        """

    def play_frequency(self, frequency: float, time: float) -> None:
        """Start a tone; the program continues meanwhile.

        Args:
            frequency: hertz; 440 is the note A.
            time: milliseconds.
        """

class _NeedsBase:
    """Skills that need `Base`."""

    def move_straight(self, advSpeed: float = 40) -> None:
        """Drive straight until the next command.

        Args:
            advSpeed: mm/s; a negative speed drives backwards.
        """

    def move_left(self, advSpeed: float = 20, rotSpeed: float = -15) -> None:
        """Drive in a curve to the left until the next command.

        Args:
            advSpeed: mm/s; a negative speed drives backwards.
            rotSpeed: degrees/s; negative turns to the left.
        """

    def move_right(self, advSpeed: float = 20, rotSpeed: float = 15) -> None:
        """Drive in a curve to the right until the next command.

        Args:
            advSpeed: mm/s; a negative speed drives backwards.
            rotSpeed: degrees/s; positive turns to the right.
        """

    def turn_left(self, rotSpeed: float = -23) -> None:
        """Turn to the left on the spot until the next command.

        Args:
            rotSpeed: degrees/s; negative turns to the left.
        """

    def turn_right(self, rotSpeed: float = 23) -> None:
        """Turn to the right on the spot until the next command.

        Args:
            rotSpeed: degrees/s; positive turns to the right.
        """

    def set_move(self, adv: float, rot: float) -> None:
        """Drive and turn at the same time until the next command.

        Args:
            adv: mm/s; a negative speed drives backwards.
            rot: degrees/s; positive turns to the right.
        """

    def stop_bot(self) -> None:
        """Stop the wheels."""

    def turn(self, angle: float, rotSpeed: float = 120) -> None:
        """Turn on the spot by an angle, then continue with the program.

        The robot slows down towards the end and stops within 1 degree of the angle by its gyroscope
        or, without one, by its wheels.

        Args:
            angle: degrees; positive to the right, negative to the left; 720 is two full turns.
            rotSpeed: degrees/s at most, more than 0.

        Raises:
            DeviceValueError: the speed is not more than 0.
            StillTurningError: the turn takes far too long; the robot may be stuck.
        """

    def turn_90_left(self) -> None:
        """Turn left by 90 degrees on the spot."""

    def turn_90_right(self) -> None:
        """Turn right by 90 degrees on the spot."""

    def turn_back(self) -> None:
        """Turn around by 180 degrees on the spot."""

    def slow_down(self, decAdv: float = 4, decRot: float = 2) -> None:
        """Drive one step slower, until the robot stops; each step takes 0.1 seconds.

        Args:
            decAdv: mm/s by which each step reduces the speed; the sign does not matter.
            decRot: degrees/s by which each step reduces the turning; the sign does not matter.
        """

    def is_moving_straight(self) -> bool:
        """Is the robot driving straight, forward or backward?"""

    def is_moving_left(self) -> bool:
        """Is the robot driving in a curve to the left?"""

    def is_moving_right(self) -> bool:
        """Is the robot driving in a curve to the right?"""

    def is_turning(self) -> bool:
        """Is the robot turning on the spot?"""

    def is_turning_left(self) -> bool:
        """Is the robot turning to the left on the spot?"""

    def is_turning_right(self) -> bool:
        """Is the robot turning to the right on the spot?"""

    def wait_until_still(self) -> None:
        """Wait until the robot has stopped, for example after `stop_bot` or at an obstacle.

        The robot measures this with its wheels. If nothing makes it stop, the program waits forever.
        """

    def get_pose(self) -> Pose | None:
        """Where is the robot? Its x and y in mm and its heading in degrees.

        x is ahead of the robot's start, y to the left of it; the heading is positive to the right.
        """

    def near_to_target(self, x: float, y: float, nearDist: float = 50) -> bool:
        """Is the robot near a place?

        Args:
            x: x of the place in mm.
            y: y of the place in mm.
            nearDist: mm that still count as near.
        """

    def target_at_front(self, x: float, y: float, diffX: float = 20) -> bool:
        """Is a place straight ahead of the robot?

        Args:
            x: x of the place in mm.
            y: y of the place in mm.
            diffX: mm to either side that still count as straight ahead.
        """

    def target_at_left(self, x: float, y: float) -> bool:
        """Is a place to the left of the robot?

        Args:
            x: x of the place in mm.
            y: y of the place in mm.
        """

    def target_at_right(self, x: float, y: float) -> bool:
        """Is a place to the right of the robot?

        Args:
            x: x of the place in mm.
            y: y of the place in mm.
        """

class _NeedsBaseHeading:
    """Skills that need `Base` and `heading`."""

    def set_orientation(self, angle: float) -> None:
        """Turn on the spot to face a direction, the shorter way.

        The robot turns at 5 to 15 degrees/s, stops within 1 degree by its gyroscope or, without one,
        by its wheels, and corrects an error of more than 2 degrees after it has stopped.

        Args:
            angle: degrees to the right of the heading at the last `reset_orientation`.

        Raises:
            StillTurningError: the turn takes far too long; the robot may be stuck.
        """

    def drive_distance(self, distance: float, advSpeed: float = 80) -> None:
        """Drive straight for a distance, then continue with the program.

        The distance is that of the wheels, which may slip. The robot keeps its heading, by its
        gyroscope or, without one, by its wheels.

        Args:
            distance: mm; negative drives backwards.
            advSpeed: mm/s, more than 0.

        Raises:
            DeviceValueError: the speed is not more than 0.
            StillDrivingError: the drive takes far too long; the robot may be stuck.
        """

    def drive_arc(self, radius: float, angle: float, advSpeed: float = 80) -> None:
        """Drive forward along a part of a circle, then continue with the program.

        The angle is measured by the gyroscope or, without one, by the wheels.

        Args:
            radius: mm from the middle of the circle to the robot, more than 0.
            angle: degrees by which the robot turns meanwhile; positive to the right, negative to the
                left; 360 is a whole circle.
            advSpeed: mm/s, more than 0; in a narrow arc the robot drives slower.

        Raises:
            DeviceValueError: the radius or the speed is not more than 0.
            StillDrivingError: the drive takes far too long; the robot may be stuck.
        """

    def go_to(self, x: float, y: float, advSpeed: float = 80) -> None:
        """Turn to a place and drive there, then continue with the program.

        Places are those of `get_pose`: a robot that counts its wheels' turns starts at (0, 0).

        Args:
            x: mm ahead of the start.
            y: mm to the left of the start.
            advSpeed: mm/s, more than 0.

        Raises:
            DeviceValueError: the speed is not more than 0.
            StillTurningError: the turn takes far too long; the robot may be stuck.
            StillDrivingError: the drive takes far too long; the robot may be stuck.
        """

class _NeedsBumper:
    """Skills that need `Bumper`."""

    def is_bumped(self) -> bool:
        """Does the robot's bumper touch something?"""

class _NeedsCamera:
    """Skills that need `Camera`."""

    def get_image(self) -> Frame | None:
        """The camera's picture: uint8 RGB, shape (height, width, 3); None before the first one."""

    def is_line_crossing(self) -> bool:
        """Does the camera see a red and a black line crossing ahead?"""

    def is_any_tag(self) -> bool:
        """Does the camera see a tag?"""

    def is_tag(self, idTag: int | str = 8) -> bool:
        """Does the camera see this tag?

        Args:
            idTag: the number or name of the tag.

        Raises:
            UnknownNameError: no tag has this name.
        """

    def is_image(self, id: int | str = 0) -> bool:
        """Does the camera see the picture that belongs to this tag?

        Args:
            id: the number or name of the tag.

        Raises:
            UnknownNameError: no tag has this name.
        """

    def tag_on_the_left(self, idTag: int | str | None = None) -> bool:
        """Does the camera see the tag on the left of the picture?

        Args:
            idTag: the number or name of the tag; None means the first tag seen.

        Raises:
            UnknownNameError: no tag has this name.
        """

    def tag_on_the_right(self, idTag: int | str | None = None) -> bool:
        """Does the camera see the tag on the right of the picture?

        Args:
            idTag: the number or name of the tag; None means the first tag seen.

        Raises:
            UnknownNameError: no tag has this name.
        """

    def tag_on_the_center(self, idTag: int | str | None = None) -> bool:
        """Does the camera see the tag in the middle of the picture?

        Args:
            idTag: the number or name of the tag; None means the first tag seen.

        Raises:
            UnknownNameError: no tag has this name.
        """

    def get_tag_distance(self, idTag: int | str | None = None) -> float | None:
        """How far is the tag from the camera, in mm?

        None if the tag is not in the picture, or if the camera's focal length is unknown. The black
        square of a tag is assumed to be 80 mm wide.

        Args:
            idTag: the number or name of the tag; None means the first tag seen.

        Raises:
            UnknownNameError: no tag has this name.
        """

    def is_there_face(self) -> bool:
        """Does the camera see a face?"""

    def is_left_face(self) -> bool:
        """Does the camera see a face on the left of the picture?"""

    def is_right_face(self) -> bool:
        """Does the camera see a face on the right of the picture?"""

    def is_up_face(self) -> bool:
        """Does the camera see a face high in the picture?"""

    def is_down_face(self) -> bool:
        """Does the camera see a face low in the picture?"""

    def is_center_face(self) -> bool:
        """Does the camera see a face in the middle of the picture?"""

    def is_there_object(
        self, colour: Literal["red", "orange", "yellow", "green", "blue", "purple"] = "red"
    ) -> bool:
        """Does the camera see something of this colour?

        Args:
            colour: red, orange, yellow, green, blue or purple.

        Raises:
            UnknownNameError: there is no such colour.
        """

    def is_left_object(
        self, colour: Literal["red", "orange", "yellow", "green", "blue", "purple"] = "red"
    ) -> bool:
        """Is the largest object of this colour on the left of the picture?

        Args:
            colour: red, orange, yellow, green, blue or purple.

        Raises:
            UnknownNameError: there is no such colour.
        """

    def is_center_object(
        self, colour: Literal["red", "orange", "yellow", "green", "blue", "purple"] = "red"
    ) -> bool:
        """Is the largest object of this colour in the middle of the picture?

        Args:
            colour: red, orange, yellow, green, blue or purple.

        Raises:
            UnknownNameError: there is no such colour.
        """

    def is_right_object(
        self, colour: Literal["red", "orange", "yellow", "green", "blue", "purple"] = "red"
    ) -> bool:
        """Is the largest object of this colour on the right of the picture?

        Args:
            colour: red, orange, yellow, green, blue or purple.

        Raises:
            UnknownNameError: there is no such colour.
        """

    def get_object_size(
        self, colour: Literal["red", "orange", "yellow", "green", "blue", "purple"] = "red"
    ) -> float | None:
        """How much of the picture does the largest object of this colour cover, in percent?

        The value grows as the robot comes closer. None without a camera.

        Args:
            colour: red, orange, yellow, green, blue or purple.

        Raises:
            UnknownNameError: there is no such colour.
        """

class _NeedsCameraEmotions:
    """Skills that need `Camera:emotions`."""

    def is_any_face_happy(self) -> bool:
        """Does the camera see a happy face?"""

    def is_any_face_sad(self) -> bool:
        """Does the camera see a sad face?"""

    def is_any_face_neutral(self) -> bool:
        """Does the camera see a neutral face?"""

    def is_any_face_angry(self) -> bool:
        """Does the camera see an angry face?"""

    def is_any_face_surprised(self) -> bool:
        """Does the camera see a surprised face?"""

    def is_any_face_scared(self) -> bool:
        """Does the camera see a scared face?"""

    def is_any_face_disgusted(self) -> bool:
        """Does the camera see a disgusted face?"""

class _NeedsController:
    """Skills that need `Controller`."""

    def get_8_button_controller(self) -> Mapping[str, bool] | None:
        """Which buttons of the controller are pressed? True or False for each button by name."""

    def is_press_8_button_controller(self, button: str = "lUp") -> bool:
        """Is a button of the controller pressed?

        Args:
            button: lUp, lLeft, lRight, lDown, rUp, rLeft, rRight or rDown.

        Raises:
            UnknownNameError: the controller has no such button.
        """

class _NeedsGroundSensors:
    """Skills that need `GroundSensors`."""

    def is_there_ground(self) -> bool:
        """Is there ground under the whole robot?

        Beyond the edge of a table nothing is reflected, which looks dark, so there is ground if no
        sensor sees anything dark. A black line therefore counts as no ground.
        """

class _NeedsInfrared:
    """Skills that need `Infrared`."""

    def get_IR(self) -> int | None:
        """Which code did the remote control send last? None before the first one."""

    def is_this_code_IR(self, code: int) -> bool:
        """Did the remote control send this code last?

        Args:
            code: the number of a key.
        """

    def send_code_IR(self, code: int) -> None:
        """Send a code, as a remote control does.

        Args:
            code: the number of a key.
        """

class _NeedsJointMotor:
    """Skills that need `JointMotor`."""

    def setAngleMotor(self, key: str, angle: float) -> None:
        """Start moving a joint to an angle; the program continues meanwhile.

        Args:
            key: which joint, such as ``CAMERA`` or ``ARM``.
            angle: degrees; 0 is level, positive is up.
        """

class _NeedsPen:
    """Skills that need `Pen`."""

    def pen_down(self) -> None:
        """Draw a line on the floor from now on, wherever the robot drives.

        The pen is at the middle between the wheels.
        """

    def pen_up(self) -> None:
        """Lift the pen, so that the robot no longer draws."""

    def set_pen_color(self, color: str = "red") -> None:
        """Set the colour of the pen.

        Args:
            color: the name of a colour, or red, green and blue as in "#ff8800".

        Raises:
            DeviceValueError: it is not a colour.
        """

    def set_pen_width(self, width: float = 6) -> None:
        """Set the width of the pen.

        Args:
            width: mm, 1 to 50.
        """

    def clear_drawing(self) -> None:
        """Erase everything that the robot has drawn."""

class _NeedsBlackLine:
    """Skills that need `black-line`."""

    def is_center_black_line(self) -> bool:
        """Is a black line mostly in the middle of the camera's picture?

        The camera tilts to the floor, unless the program has tilted it. A robot without a camera uses
        its ground sensors; a single one follows the line's right edge.
        """

    def is_left_black_line(self) -> bool:
        """Is a black line mostly on the left of the camera's picture?

        The camera tilts to the floor, unless the program has tilted it. A robot without a camera uses
        its ground sensors; a single one follows the line's right edge.
        """

    def is_right_black_line(self) -> bool:
        """Is a black line mostly on the right of the camera's picture?

        The camera tilts to the floor, unless the program has tilted it. A robot without a camera uses
        its ground sensors; a single one follows the line's right edge.
        """

    def is_there_black_line(self) -> bool:
        """Is there a black line in the camera's picture?

        The camera tilts to the floor, unless the program has tilted it. A robot without a camera uses
        its ground sensors; a single one follows the line's right edge.
        """

    def get_line_position(self) -> float | None:
        """How far to the side is the black line? From -100 (left) to 100 (right), 0 in the middle.

        By a camera, which tilts to the floor unless the program has tilted it, or by the sensors under
        the robot; for a single one the middle is the line's right
        edge. A robot that has lost the line gets -100 or 100, for the side on which it was last.
        """

class _NeedsBlueLine:
    """Skills that need `blue-line`."""

    def is_center_blue_line(self) -> bool:
        """Does the camera see a blue line mostly in the middle of the picture?"""

    def is_left_blue_line(self) -> bool:
        """Does the camera see a blue line mostly on the left of the picture?"""

    def is_right_blue_line(self) -> bool:
        """Does the camera see a blue line mostly on the right of the picture?"""

    def is_there_blue_line(self) -> bool:
        """Does the camera see a blue line anywhere in the picture?"""

class _NeedsBrightness:
    """Skills that need `brightness`."""

    def get_light(self) -> float | None:
        """How bright is it? From 0 (dark) to 1023."""

    def is_illuminated(self, threshold: float = 500) -> bool:
        """Is it bright?

        Args:
            threshold: the brightness, 0 to 1023, above which it is bright.
        """

class _NeedsGroundLine:
    """Skills that need `ground-line`."""

    def is_center_ground_line(self) -> bool:
        """Is there a dark line under the middle of the robot?

        On a robot without a central sensor: under both its left and its right sensor? A camera looks
        at the floor ahead.
        """

    def is_left_ground_line(self) -> bool:
        """Is there a dark line under the left sensor, and none under the right one?

        A robot with a single sensor looks for a line that it has lost on both sides, one after the
        other. A camera looks at the floor ahead.
        """

    def is_right_ground_line(self) -> bool:
        """Is there a dark line under the right sensor, and none under the left one?

        A robot with a single sensor looks for a line that it has lost on both sides, one after the
        other. A camera looks at the floor ahead.
        """

class _NeedsHeading:
    """Skills that need `heading`."""

    def reset_orientation(self, keygyro: str = "Z_AXIS") -> None:
        """Set the current heading to 0 degrees.

        Args:
            keygyro: which gyroscope; the one whose axis points up measures turns on the floor. A
                robot without it uses its wheels.
        """

    def get_heading(self) -> float | None:
        """How many degrees has the robot turned to the right since the last `reset_orientation`?"""

class _NeedsObstacleBack:
    """Skills that need `obstacle-back`."""

    def is_back_obstacle(self, threshold: float = 200) -> bool:
        """Is there an obstacle behind the robot?

        Args:
            threshold: the distance in mm within which an obstacle counts.
        """

class _NeedsObstacleFront:
    """Skills that need `obstacle-front`."""

    def is_front_obstacle(self, threshold: float = 200) -> bool:
        """Is there an obstacle ahead?

        Args:
            threshold: the distance in mm within which an obstacle counts.
        """

    def get_obstacle_direction(self) -> float | None:
        """In which direction is the nearest obstacle? In degrees: 0 ahead, positive to the right.

        In steps of 45 degrees, from -90 (left) to 90 (right), and 180 behind; None if the robot sees no
        obstacle. A robot that only looks ahead sees obstacles only there.
        """

class _NeedsObstacleFrontObstacleLeftObstacleRight:
    """Skills that need `obstacle-front` and `obstacle-left` and `obstacle-right`."""

    def is_obstacle_free(self, threshold: float = 200) -> bool:
        """Is the way clear ahead, on the left and on the right?

        Args:
            threshold: the distance in mm that must be clear.
        """

class _NeedsObstacleLeft:
    """Skills that need `obstacle-left`."""

    def is_left_obstacle(self, threshold: float = 200) -> bool:
        """Is there an obstacle on the left?

        Args:
            threshold: the distance in mm within which an obstacle counts.
        """

class _NeedsObstacleLeftOrObstacleFrontOrObstacleRight:
    """Skills that need `obstacle-left` or `obstacle-front` or `obstacle-right`."""

    def get_min_distance(
        self, left: bool = False, front: bool = True, right: bool = False
    ) -> float | None:
        """How far is the nearest obstacle, in mm? 2000 means that none is seen.

        Args:
            left: look to the left.
            front: look ahead.
            right: look to the right; without any side, all three are used.
        """

class _NeedsObstacleRight:
    """Skills that need `obstacle-right`."""

    def is_right_obstacle(self, threshold: float = 200) -> bool:
        """Is there an obstacle on the right?

        Args:
            threshold: the distance in mm within which an obstacle counts.
        """

class _NeedsRedLine:
    """Skills that need `red-line`."""

    def is_center_red_line(self) -> bool:
        """Does the camera see a red line mostly in the middle of the picture?"""

    def is_left_red_line(self) -> bool:
        """Does the camera see a red line mostly on the left of the picture?"""

    def is_right_red_line(self) -> bool:
        """Does the camera see a red line mostly on the right of the picture?"""

    def is_there_red_line(self) -> bool:
        """Does the camera see a red line anywhere in the picture?"""

class _NeedsShaking:
    """Skills that need `shaking`."""

    def is_shaken(self) -> bool:
        """Is the robot shaken, now or in the last half second?"""

class _NeedsTilting:
    """Skills that need `tilting`."""

    def is_tilted(self, direction: str = "any") -> bool:
        """Is the robot tilted by more than 15 degrees?

        Args:
            direction: the side that is lower: front, back, left, right or any.

        Raises:
            UnknownNameError: there is no such side.
        """

class SimEbo(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsCamera,
    _NeedsCameraEmotions,
    _NeedsJointMotor,
    _NeedsPen,
    _NeedsBlackLine,
    _NeedsBlueLine,
    _NeedsBrightness,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsObstacleFront,
    _NeedsObstacleFrontObstacleLeftObstacleRight,
    _NeedsObstacleLeft,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
    _NeedsObstacleRight,
    _NeedsRedLine,
):
    """The skills of `sim-ebo`."""

class SimThymio(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsGroundSensors,
    _NeedsPen,
    _NeedsBlackLine,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsObstacleBack,
    _NeedsObstacleFront,
    _NeedsObstacleFrontObstacleLeftObstacleRight,
    _NeedsObstacleLeft,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
    _NeedsObstacleRight,
    _NeedsShaking,
    _NeedsTilting,
):
    """The skills of `sim-thymio`."""

class SimEv3(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsBumper,
    _NeedsGroundSensors,
    _NeedsPen,
    _NeedsBlackLine,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsObstacleFront,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
):
    """The skills of `sim-ev3`."""

class SimCozmo(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsCamera,
    _NeedsCameraEmotions,
    _NeedsGroundSensors,
    _NeedsJointMotor,
    _NeedsPen,
    _NeedsBlackLine,
    _NeedsBlueLine,
    _NeedsBrightness,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsRedLine,
    _NeedsShaking,
    _NeedsTilting,
):
    """The skills of `sim-cozmo`."""

class SimSpike(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsBumper,
    _NeedsGroundSensors,
    _NeedsPen,
    _NeedsBlackLine,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsObstacleFront,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
):
    """The skills of `sim-spike`."""

class SimLegoed(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsGroundSensors,
    _NeedsJointMotor,
    _NeedsPen,
    _NeedsBlackLine,
    _NeedsGroundLine,
    _NeedsHeading,
):
    """The skills of `sim-legoed`."""

class SimRoot(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsBumper,
    _NeedsGroundSensors,
    _NeedsPen,
    _NeedsBlackLine,
    _NeedsBrightness,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsObstacleFront,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
):
    """The skills of `sim-root`."""

class SimCreate3(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsBumper,
    _NeedsGroundSensors,
    _NeedsPen,
    _NeedsHeading,
    _NeedsObstacleFront,
    _NeedsObstacleFrontObstacleLeftObstacleRight,
    _NeedsObstacleLeft,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
    _NeedsObstacleRight,
):
    """The skills of `sim-create3`."""

class Coppeliasim(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsBumper,
    _NeedsCamera,
    _NeedsCameraEmotions,
    _NeedsController,
    _NeedsGroundSensors,
    _NeedsInfrared,
    _NeedsJointMotor,
    _NeedsPen,
    _NeedsBlackLine,
    _NeedsBlueLine,
    _NeedsBrightness,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsObstacleBack,
    _NeedsObstacleFront,
    _NeedsObstacleFrontObstacleLeftObstacleRight,
    _NeedsObstacleLeft,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
    _NeedsObstacleRight,
    _NeedsRedLine,
    _NeedsShaking,
    _NeedsTilting,
):
    """The skills of `coppeliasim`."""

class Cozmo(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsCamera,
    _NeedsGroundSensors,
    _NeedsJointMotor,
    _NeedsBlackLine,
    _NeedsBlueLine,
    _NeedsBrightness,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsRedLine,
    _NeedsShaking,
    _NeedsTilting,
):
    """The skills of `cozmo`."""

class Create3(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsBumper,
    _NeedsGroundSensors,
    _NeedsHeading,
    _NeedsObstacleFront,
    _NeedsObstacleFrontObstacleLeftObstacleRight,
    _NeedsObstacleLeft,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
    _NeedsObstacleRight,
):
    """The skills of `create3`."""

class Ebo(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsCamera,
    _NeedsJointMotor,
    _NeedsBlackLine,
    _NeedsBlueLine,
    _NeedsBrightness,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsObstacleFront,
    _NeedsObstacleFrontObstacleLeftObstacleRight,
    _NeedsObstacleLeft,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
    _NeedsObstacleRight,
    _NeedsRedLine,
):
    """The skills of `ebo`."""

class Ev3(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsBumper,
    _NeedsGroundSensors,
    _NeedsBlackLine,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsObstacleFront,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
):
    """The skills of `ev3`."""

class Legoed(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsController,
    _NeedsGroundSensors,
    _NeedsJointMotor,
    _NeedsBlackLine,
    _NeedsGroundLine,
    _NeedsHeading,
):
    """The skills of `legoed`."""

class Rcis(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsCamera,
    _NeedsJointMotor,
    _NeedsBlackLine,
    _NeedsBlueLine,
    _NeedsBrightness,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsObstacleFront,
    _NeedsObstacleFrontObstacleLeftObstacleRight,
    _NeedsObstacleLeft,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
    _NeedsObstacleRight,
    _NeedsRedLine,
):
    """The skills of `rcis`."""

class Root(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsBumper,
    _NeedsGroundSensors,
    _NeedsPen,
    _NeedsBlackLine,
    _NeedsBrightness,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsObstacleFront,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
):
    """The skills of `root`."""

class Spike(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsBumper,
    _NeedsGroundSensors,
    _NeedsBlackLine,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsObstacleFront,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
):
    """The skills of `spike`."""

class Thymio(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsController,
    _NeedsGroundSensors,
    _NeedsBlackLine,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsObstacleBack,
    _NeedsObstacleFront,
    _NeedsObstacleFrontObstacleLeftObstacleRight,
    _NeedsObstacleLeft,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
    _NeedsObstacleRight,
    _NeedsShaking,
    _NeedsTilting,
):
    """The skills of `thymio`."""

class EverySkill(
    OwnSkills,
    _NeedsNothing,
    _NeedsBase,
    _NeedsBaseHeading,
    _NeedsBumper,
    _NeedsCamera,
    _NeedsCameraEmotions,
    _NeedsController,
    _NeedsGroundSensors,
    _NeedsInfrared,
    _NeedsJointMotor,
    _NeedsPen,
    _NeedsBlackLine,
    _NeedsBlueLine,
    _NeedsBrightness,
    _NeedsGroundLine,
    _NeedsHeading,
    _NeedsObstacleBack,
    _NeedsObstacleFront,
    _NeedsObstacleFrontObstacleLeftObstacleRight,
    _NeedsObstacleLeft,
    _NeedsObstacleLeftOrObstacleFrontOrObstacleRight,
    _NeedsObstacleRight,
    _NeedsRedLine,
    _NeedsShaking,
    _NeedsTilting,
):
    """Every skill, for hints: a robot of any kind."""
