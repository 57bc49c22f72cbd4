# Files written or chosen by users.

# A value that is not allowed: $place is its position in the file, $reason a sentence.
file-wrong-value = { $place }: { $reason }
file-too-many-statements = The file has { $count } functions and other statements; the limit is { $limit }. Split it into several files.
file-too-large = { $name } is too large: the limit is { $limit } MB.
# $most is a number of MB.
file-quota = Your folder is full: it may hold { $most } MB. Delete runs, projects or other files that you don't need.
# $size and $limit are numbers of bytes.
file-too-many-bytes = The file has { $size } bytes, but it can have at most { $limit }.
# $position counts the bytes of the file from 0.
file-not-utf-8 = Byte { $position } of the file is not UTF-8. Save the file as UTF-8.
# $reason is Python's own text.
file-not-python = This is not valid Python: { $reason }.

# A position in a file; these are parts of other sentences.
file-itself = the file
file-place = '{ $path }'

# $place is one of the two above.
file-unknown-key = The key '{ $key }' is unknown in { $place }.
file-unknown-key-of = { file-unknown-key } Known keys: { $known }.
file-unknown-key-like = { file-unknown-key } Did you mean '{ $suggestion }'?
file-missing-key = The key '{ $key }' is missing from { $place }.

# Several mistakes in one file: each a sentence, with its line where it has one.
file-at-line = Line { $line }: { $problem }
file-mistakes = { $first } { $rest }
file-more-mistakes = { $count ->
    [one] There is one more mistake.
   *[other] There are { $count } more mistakes.
}

# What is refused of a zip, or of a folder; $file is in it.
file-link = '{ $file }' is a link. Replace it with the file.
file-zip-outside = The file '{ $file }' would be outside the folder of its zip.
file-zip-encrypted = '{ $file }' is encrypted or compressed in an unknown way.
file-zip-two = There are two files named '{ $file }'.
file-zip-bomb = '{ $file }' is compressed more than any file that a person makes.
