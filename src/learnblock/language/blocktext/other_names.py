"""Names that pupils expect from Scratch, MakeCode, Python and their language, and ours for them."""

from collections.abc import Mapping
from types import MappingProxyType

from learnblock.language.blocktext.foreign_words import foreign_names

#: The robot then drives until the next command.
MOVE_STRAIGHT = "move_straight(40)"

#: Skills that do not exist, and the call that was meant.
SKILLS: Mapping[str, str] = MappingProxyType(
    {
        **dict.fromkeys(
            ("forward", "forwards", "go", "move", "drive", "straight", "run", "advance"),
            MOVE_STRAIGHT,
        ),
        **dict.fromkeys(("back", "backward", "backwards", "reverse"), "set_move(-40, 0)"),
        **dict.fromkeys(("left", "rotate_left", "spin_left"), "turn(-90)"),
        **dict.fromkeys(("right", "rotate_right", "spin_right"), "turn(90)"),
        **dict.fromkeys(("rotate", "spin"), "turn(90)"),
        **dict.fromkeys(("arc", "curve", "driveArc"), "drive_arc(200, 90)"),
        **dict.fromkeys(("goto", "go_to_xy", "glide", "move_to", "drive_to"), "go_to(200, 0)"),
        **dict.fromkeys(("stop", "halt", "brake"), "stop_bot()"),
        **dict.fromkeys(("wait", "pause", "delay", "wait_seconds"), "sleep(2)"),
        **dict.fromkeys(("say", "speak", "talk", "tell"), 'say_Text("hello")'),
        **dict.fromkeys(("happy", "smile", "joy"), "expressJoy()"),
        **dict.fromkeys(("sad", "cry"), "expressSadness()"),
        **dict.fromkeys(("beep", "tone", "play_tone", "playTone"), "play_frequency(440, 500)"),
        **dict.fromkeys(("note", "playNote", "play_notes"), 'play_note("C4", 1)'),
        **dict.fromkeys(("tempo", "setTempo", "change_tempo"), "set_tempo(120)"),
        **dict.fromkeys(
            ("key", "key_pressed", "is_key_down", "is_pressed", "pressed", "button_pressed"),
            'is_key_pressed("up")',
        ),
        **dict.fromkeys(("broadcast", "send_message"), 'send("go")'),
        **dict.fromkeys(("receive", "on_received"), 'received("go")'),
        **dict.fromkeys(("time", "timer", "stopwatch"), "get_timer()"),
        **dict.fromkeys(("resetTimer", "reset_time"), "reset_timer()"),
        **dict.fromkeys(("heading", "angle", "direction", "yaw"), "get_heading()"),
        **dict.fromkeys(("touching", "touch", "bumped", "is_touching"), "is_bumped()"),
        **dict.fromkeys(("light", "brightness", "light_level"), "get_light()"),
        **dict.fromkeys(("point_in_direction", "set_heading", "turn_to"), "set_orientation(90)"),
        **dict.fromkeys(("show_string", "showString"), 'show_text("hello")'),
        **dict.fromkeys(("show_icon", "showIcon", "show_leds"), 'matrix_icon("heart")'),
        **dict.fromkeys(("steer", "tank", "move_tank", "drive_tank"), "set_move(40, 20)"),
        **dict.fromkeys(("distance", "get_distance", "ultrasonic"), "get_min_distance()"),
        **dict.fromkeys(("obstacle", "is_obstacle"), "is_front_obstacle()"),
        **dict.fromkeys(("tag", "is_any_tags", "sees_tag"), "is_any_tag()"),
        **foreign_names("skills"),
    }
)

#: The same where they are called with a value, in place of ``{0}``.
SKILLS_WITH_VALUE: Mapping[str, str] = MappingProxyType(
    {
        **dict.fromkeys(
            (
                *("forward", "forwards", "go", "move", "straight", "advance", "move_forward"),
                *("move_steps", "drive_forward", "driveDistance", "fd"),
            ),
            "drive_distance({0})",
        ),
        **dict.fromkeys(
            (
                *("back", "backward", "backwards", "reverse", "move_backward", "drive_backward"),
                "bk",
            ),
            "drive_distance(-{0})",
        ),
        **dict.fromkeys(
            ("left", "rotate_left", "spin_left", "lt", "turnLeft", "turn_degrees_left"),
            "turn(-{0})",
        ),
        **dict.fromkeys(
            ("right", "rotate_right", "spin_right", "rt", "turnRight", "turn_degrees_right"),
            "turn({0})",
        ),
        **dict.fromkeys(("rotate", "spin", "turn_degrees"), "turn({0})"),
        **dict.fromkeys(("point_in_direction", "set_heading", "turn_to"), "set_orientation({0})"),
        **dict.fromkeys(("wait", "pause", "delay", "wait_seconds"), "sleep({0})"),
        **dict.fromkeys(("say", "speak", "talk", "tell"), "say_Text({0})"),
        **dict.fromkeys(("broadcast", "publish", "send_message", "radio_send"), "send({0})"),
        **dict.fromkeys(("when_i_receive", "receive", "subscribe", "on_received"), "received({0})"),
        **dict.fromkeys(
            ("show_string", "showString", "display_text", "text", "screen_print"), "show_text({0})"
        ),
        **dict.fromkeys(("showNumber", "display_number"), "show_number({0})"),
        **dict.fromkeys(
            (
                *("is_pressed", "pressed", "key_pressed", "is_key_down", "button_pressed"),
                *("button_is_pressed", "keyDown", "isPressed"),
            ),
            "is_key_pressed({0})",
        ),
        **dict.fromkeys(("setSpeed", "set_speed", "run"), "move_straight({0})"),
        **foreign_names("skills_with_value"),
    }
)

#: What pupils name without brackets, and the question that answers it.
QUESTIONS: Mapping[str, str] = MappingProxyType(
    {
        **dict.fromkeys(("timer", "time", "stopwatch"), "get_timer()"),
        **dict.fromkeys(("distance", "ultrasonic"), "get_min_distance()"),
        **dict.fromkeys(("heading", "direction", "yaw", "gyro"), "get_heading()"),
        **dict.fromkeys(("light", "brightness", "light_level"), "get_light()"),
        **dict.fromkeys(("touching", "bumped", "bumper", "touch"), "is_bumped()"),
        "obstacle": "is_front_obstacle()",
        **foreign_names("questions"),
    }
)

#: Functions that do not exist, and ours.
FUNCTIONS: Mapping[str, str] = MappingProxyType(
    {
        **dict.fromkeys(("echo", "println", "printf", "write", "puts"), "print"),
        **dict.fromkeys(("ask", "readline", "prompt"), "input"),
        **dict.fromkeys(("length", "size"), "len"),
        **dict.fromkeys(("toInt", "parseInt", "integer"), "int"),
        **dict.fromkeys(("decimal", "parseFloat", "toFloat", "number", "Number"), "float"),
        **dict.fromkeys(("string", "String", "toString"), "str"),
        **dict.fromkeys(("randint", "rand", "pick_random", "randrange"), "random"),
        "squareroot": "sqrt",
        "rounded": "round",
        "fabs": "abs",
        "total_of": "sum",
        "maximum": "max",
        "minimum": "min",
        "push": "append",
        **foreign_names("functions"),
    }
)

#: Functions in other languages that are skills here.
FUNCTIONS_AS_SKILLS: Mapping[str, str] = MappingProxyType(
    {
        **SKILLS,
        **foreign_names("functions_as_skills"),
    }
)
#: Values in other languages.
VALUES: Mapping[str, str] = MappingProxyType(
    {
        **dict.fromkeys(("true", "TRUE", "yes"), "True"),
        **dict.fromkeys(("false", "FALSE"), "False"),
        **dict.fromkeys(("none", "NONE", "null", "NULL", "nil", "undefined"), "None"),
        **foreign_names("values"),
    }
)
