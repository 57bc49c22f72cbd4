# Blocks: values of their fields, type hints and block configurations.

# What to write instead of a wrong value; shown behind a sentence that names the value.
block-expects-number = Write a number.
block-expects-text = Write text in quotes.
block-expects-truth = Write True or False.
block-expects-list = Write a list.
block-expects-tag = Write the number or the name of a tag.
block-expects-colour = Write a colour such as "#ff8800".
block-expects-range = Choose a number from { $least } to { $most }.
block-expects-choice = Choose one of: { $choices }.

# A field's type, such as float.
block-type = { $type }
block-type-with-range = { $type } from { $least } to { $most }

# Mistakes in a range; shown behind the range.
block-range-ends = The ends of a range must be numbers.
block-range-order = The first number must be smaller than the second.
block-range-step = The step must be above zero and fit into the range.

# Type hints.
block-unknown-hint = { $hint } has no field on a block. Write float, int, str, bool, list, Colour, Angle, TagName, Annotated[float, Range(0, 100)] or Literal["a", "b"].
block-hint-range-not-number = { $hint } has a range, but only numbers can have one.
block-hint-range-form = { $hint } is not a range. Write Range(0, 100) or Range(0, 10, step=1).
# $problem is a whole sentence.
block-hint-range = { $hint } is not valid. { $problem }
block-hint-range-number = { $hint } in a Range is not a number.
block-hint-choices = Literal[{ $hint }] is not valid. Write at most { $most } different choices of one line each, such as Literal["slow", "fast"].

# Files in the blocks and skills folders, and plugins. $reason is the operating system's.
block-file-unreadable = { $file } cannot be read: { $reason }
block-plugin-unreadable = The plugin '{ $plugin }' cannot be read: { $reason }
block-plugin-missing = The module { $module } of the plugin '{ $plugin }' is not installed as Python source. Reinstall the plugin.
# $reason is a whole sentence.
block-broken-file = { $file }, line { $line }: { $reason }

# Block configurations (JSON). $where names the block or parameter.
block-not-utf-8 = This file is not UTF-8. Save it as UTF-8.
block-where-block = the block '{ $name }'
block-where-nameless-block = the block
block-where-parameter = the parameter '{ $name }' of { $block }
block-where-nameless-parameter = a parameter of { $block }
block-duplicate-key = The key '{ $key }' appears twice. Keep one.
block-not-object = { $value } must be an object {"{...}"}, because it describes { $where }.
block-unknown-key = There is no key '{ $key }' for { $where }. Known keys: { $known }.
block-unknown-key-like = There is no key '{ $key }' for { $where }. Did you mean '{ $suggestion }'?
block-missing-key = The key '{ $key }' is missing from { $where }. { $key ->
    [type] It is the kind of the block or of the parameter, such as "motor" or "float".
    [category] It is the tab of the palette, such as "Base".
    [name] It is the name of the Python function or of its parameter.
   *[shape] Write ["blockVertical"] for a statement, or ["blockLeft"] for a value.
}
block-unknown-value = '{ $key }' of { $where } is { $value }. Write one of: { $known }.
block-unknown-value-like = '{ $key }' of { $where } is { $value }. Did you mean '{ $suggestion }'?
block-not-text = '{ $key }' of { $where } is { $value }. Write some text in double quotes.
block-bad-name = Python cannot use the name '{ $value }'. Use letters, digits and _, such as turn_left.
block-empty-shape = 'shape' of { $where } is empty. Write ["blockVertical"] for a statement, or ["blockLeft"] for a value.
block-two-shapes = 'shape' of { $where } is both a statement and a value. Write ["blockVertical"] for a statement, or ["blockLeft"] for a value.
block-not-translations = '{ $key }' of { $where } is { $value }. Write {"{\"EN\": \"...\", \"ES\": \"...\"}"}.
block-bad-language = { $value } in '{ $key }' of { $where } is not a language. Write a code such as EN, ES or PT-BR.
block-duplicate-language = The language { $language } appears twice in '{ $key }' of { $where }. Keep one.
block-bad-need = { $value } in 'needs' of { $where } is neither a sense nor a device. Write a sense such as heading, a device such as Base, or one with its key, such as JointMotor:CAMERA or RGBLed:{"{"}slot{"}"}.
block-not-list = '{ $key }' of { $where } is { $value }. Write a list, such as { $example }.
block-bad-default = The default { $value } of { $where } does not fit the type { $type }. { $type ->
    [float] Write a number, such as 0.5.
    [int] Write a whole number, such as 3.
    [boolean] Write true or false.
    [list] Write a list, such as [1, 2].
    [colour] Write a colour, such as "#ff8800".
    [angle] Write degrees, such as 90.
    [apriltext] Write a tag's number, such as 8, or its name, such as "ball".
   *[other] Write text in double quotes, such as "Up".
}
block-bad-range = 'range' of { $where } is { $value }. { $problem }
block-range-form = Write [0, 100], or [0, 10, 1] with a step.
block-range-not-number = Only numbers can have a range.
block-choices-type = 'choices' of { $where } needs the type "choice" or "string".
block-bad-choices = 'choices' of { $where } is { $value }. Write at most { $most } different choices of one line each, such as ["slow", "fast"].
block-unknown-choice = 'choiceNames' in { $where } has a translation for { $value }, which is not one of the choices.
block-unknown-choice-like = 'choiceNames' in { $where } has a translation for { $value }, which is not one of the choices. Did you mean '{ $suggestion }'?
block-not-directions = 'directions' of { $where } is { $value }. Write {"{\"positive\": {\"EN\": \"right\"}, \"negative\": {\"EN\": \"left\"}}"}.
block-directions-not-number = Only numbers can have 'directions', and { $where } is none. Remove them, or change its type.
block-not-choice-names = 'choiceNames' of { $where } is { $value }. Write {"{\"slow\": {\"ES\": \"lento\"}}"}.
block-duplicate-block = There is already a block '{ $name }' above. Choose another name.
block-duplicate-parameter = There is already a parameter '{ $name }' of { $where } above. Choose another name.
block-missing-default = '{ $name }' of { $where } needs a default, because '{ $optional }' before it has one.
