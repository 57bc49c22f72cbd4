# Files in TOML: worlds, simulated robots, block sets, libraries and settings.

# $reason is a technical text in English.
toml-broken = This is not valid TOML: { $reason }.
toml-too-deep = It is nested too deeply.

# $place is a key such as 'wall[2].height'; $value is the value in the file; $allowed is one of the descriptions below.
toml-wrong-value = { $place } is { $value }, but must be { $allowed }.
toml-wrong-value-like = { toml-wrong-value } Did you mean '{ $suggestion }'?
toml-missing-value = The key '{ $key }' is missing from { $place }. It must be { $allowed }.
# A table whose keys are free, such as a text by language.
toml-wrong-key = A key of { $place } must be { $allowed }.
toml-wrong-entry = Each value of { $place } must be { $allowed }.
# A header with one pair of brackets where several tables are allowed.
toml-single-table = '{ $name }' is a single table, but there can be several. Write its header as [[{ $name }]].

# What a value must be: parts of the sentences above, also shown below a field of the settings.
toml-number = a number from { $least } to { $most }
toml-whole-number = a whole number from { $least } to { $most }
toml-text = text of { $least } to { $most } characters
toml-plain-text = text
toml-tagged = a table whose '{ $key }' is { $allowed }
toml-boolean = true or false
toml-table = a table of keys and values
toml-choice = { $count ->
        [1] { $choices }
       *[other] one of { $choices }
    }
toml-either = { $first } or { $second }
toml-list = a list of { $least } to { $most } items, each { $item }
toml-list-exactly = a list of { $count } items, each { $item }
toml-items = [{ $items }]
# $note says what the value is for.
toml-with-note = { $allowed } ({ $note })
