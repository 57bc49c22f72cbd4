"""The ten groups of the palette: each has a colour and an icon on the page, and its first blocks.

A group gathers several categories, which are its headings. It first shows the few blocks that most
programs begin with; the others follow on request.
"""

from dataclasses import dataclass

#: The group of categories that are not listed here, such as those of libraries.
OTHERS = "my_blocks"


@dataclass(frozen=True, slots=True)
class Section:
    """Blocks under one heading.

    Args:
        heading: the key of its words; empty for none.
        blocks: the names of blocks as in block sets, or of categories whose blocks depend on the
            program.
    """

    heading: str
    blocks: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Group:
    """One of the ten groups.

    Args:
        name: its name for the page, which knows its colour and icon.
        categories: the categories in it, as in configurations or, for the language, block sets.
        first: what it shows first.
    """

    name: str
    categories: tuple[str, ...]
    first: tuple[Section, ...]

    @property
    def word(self) -> str:
        """The key of its name in the translations."""
        return f"LB_GROUP_{self.name.upper()}"


def _section(blocks: str, heading: str = "") -> Section:
    return Section(heading, tuple(blocks.split()))


#: In the order of the palette.
GROUPS = (
    Group(
        "events",
        ("lb_events", "lb_whens", "Messages"),
        (_section("lb_main lb_whens lb_start"),),
    ),
    Group(
        "move",
        ("Base", "Motor"),
        (
            _section("function.drive_distance function.turn function.move_straight"),
            _section("function.turn_left function.move_left function.stop_bot"),
            _section("function.look_front function.look_up function.look_floor", "LB_HEAD"),
            _section("function.get_heading function.is_turning", "LB_ASK_MOVING"),
        ),
    ),
    Group(
        "sense",
        ("Distances", "Ground", "Camera", "Light", "IR", "Controller"),
        (
            _section("function.is_front_obstacle function.is_bumped function.is_there_ground"),
            _section("function.is_illuminated function.is_tag function.is_key_pressed"),
            _section("function.get_min_distance function.get_light", "LB_ASK_MEASURE"),
        ),
    ),
    Group(
        "show",
        ("Emotion", "Led", "Matrix", "Screen", "Pen", "Cozmo"),
        (
            _section("function.expressJoy function.expressSadness function.expressSurprise"),
            _section("function.expressNeutral"),
            _section("function.RGBled function.show_text function.matrix_text", "LB_LIGHTS"),
            _section("function.pen_down function.pen_up function.set_pen_color", "LB_SKILLS_PEN"),
        ),
    ),
    Group(
        "sound",
        ("Speaker", "MP3"),
        (_section("function.say_Text function.play_note function.play_audio function.rest"),),
    ),
    Group(
        "control",
        ("lb_control", "Control", "lb_python"),
        (
            _section("function.sleep controls_repeat_ext lb_forever controls_if controls_if:else"),
            _section("lb_wait_until controls_whileUntil"),
        ),
    ),
    Group(
        "game",
        ("Game",),
        (
            _section("function.change_score function.show_score function.change_lives"),
            _section("function.win_game function.game_over"),
            _section("function.get_score function.get_lives function.get_time_left"),
        ),
    ),
    Group(
        "maths",
        ("lb_maths", "lb_logic", "lb_text"),
        (
            _section("math_number math_arithmetic math_random_int"),
            _section("logic_compare logic_operation logic_negate", "LB_CATEGORY_LOGIC"),
            _section("text text_join text_print", "LB_CATEGORY_TEXT"),
        ),
    ),
    Group(
        "variables",
        ("lb_variables", "lb_lists", "lb_dictionaries"),
        (
            _section("lb_variables"),
            _section("lists_create_with lists_getIndex lists_length", "LB_CATEGORY_LISTS"),
        ),
    ),
    Group(
        OTHERS,
        ("lb_functions", "lb_own", "Others"),
        (_section("lb_functions"), _section("lb_own", "LB_GROUP_MY_BLOCKS")),
    ),
)

_OF_CATEGORY = {category: group.name for group in GROUPS for category in group.categories}


def group_of(category: str) -> str:
    """The group of a category, as in configurations or, for the language, block sets.

    >>> group_of("Base"), group_of("My dances")
    ('move', 'my_blocks')
    """
    return _OF_CATEGORY.get(category, OTHERS)


def style_of(category: str) -> str:
    """The style of the blocks of a category: all blocks of a group have one colour."""
    return f"lb_{group_of(category)}"
