# Block configurations in JSON that cannot be read.

# $size and $limit are numbers of characters.
json-too-large = The file has { $size } characters, but the limit is { $limit }. Split it into several files.
json-empty = The file is empty. It must contain a block or a list of blocks.
json-too-deep = More than { $limit } brackets are nested inside each other. No block needs that many.
json-extra-comma = Remove this comma before the { $bracket }.
json-not-a-number = { $text } is not a number that a block can use.
json-too-many-digits = A number has more digits than a block can use.
# $text is the text in quotes.
json-half-character = { $text } contains an incomplete character: \ud8.. must be followed by its second half.
json-text-over-lines = This text continues on the next line. Is its closing " missing?
json-missing-comma = A comma or a closing bracket is missing before this.
json-missing-colon = A colon is missing here, between a key and its value.
json-missing-key = A key in double quotes is missing here.
json-missing-value = A value is missing here: text in double quotes, a number, true, false, null, a list or an object.
json-missing-quote = This text has no closing ".
json-several-values = The configuration ends before this. Write several blocks as a list.
json-backslash = A single \ can't be used here. Write a backslash as \\.
json-unicode-escape = Four hexadecimal digits are missing after \u.
# $reason is a technical text in English.
json-broken = This is not valid JSON: { $reason }.
