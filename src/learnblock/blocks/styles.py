"""The colours of calls: each call has the colour of the group with its function."""

from collections.abc import Mapping
from types import MappingProxyType

_FUNCTIONS = {
    "text_blocks": """
        print input str int float upper lower title strip find replace split join
    """,
    "list_blocks": """
        list len append extend insert remove pop clear copy sort sorted reverse index count sublist
        shuffle choice sum max min mean median mode stdev keys items enumerate
    """,
    "math_blocks": """
        abs round sqrt exp log log10 floor ceil sin cos tan asin acos atan atan2 pi constrain random
        random_fraction
    """,
}
#: The styles of blocks that call a function of the language, by its name; others have the style of
#: the user's own functions.
CALLS: Mapping[str, str] = MappingProxyType(
    {name: style for style, names in _FUNCTIONS.items() for name in names.split()}
)
