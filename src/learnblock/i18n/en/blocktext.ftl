# Errors in Block-Text: what cannot be read, and what to write instead.
# They appear under the line that they are about, on the page and in "learnblock check".

## A whole program

blocktext-too-long = The program has { $characters } characters, which is too long. The limit is { $limit }.
# $number: such as U+0000
blocktext-forbidden-character = The character { $number } is not allowed in a program. Remove it.
blocktext-second-main = A program can only have one 'main'. Combine the two.

## What was expected: $wanted and $found are noun phrases from the messages below

blocktext-expected = Expected { $wanted }, not { $found }.
blocktext-no-statement = A statement can't begin with { $found }.
# $text: a word or symbol of the program
blocktext-token = '{ $text }'
blocktext-end-of-line = the end of the line
blocktext-end-of-program = the end of the program
blocktext-wanted-value = a value
blocktext-wanted-value-after = a value after '{ $word }'
blocktext-wanted-operator = an operator
blocktext-wanted-either = '{ $first }' or '{ $second }'
blocktext-wanted-dot-and-skill = '.' and the name of a skill after 'function'
blocktext-wanted-skill = the name of a skill after 'function.'
# $word: the word that begins the block
blocktext-wanted-colon = ':' to end the '{ $word }' line
# $word: activate or deactivate
blocktext-wanted-when = the name of a 'when' after '{ $word }'
blocktext-wanted-when-name = a name after 'when', as in 'when seen = condition:'
blocktext-wanted-loop-variable = the name of a variable after 'for'
blocktext-wanted-in = 'in' and a list
blocktext-wanted-in-or-from = 'in' and a list, or 'from' and a number
blocktext-wanted-to = 'to' and the last number
blocktext-wanted-library = the name of a library in quotes, as in 'import "dance"'
blocktext-wanted-function-name = the name of the function after 'def'
blocktext-wanted-parameters = '(' after 'def { $name }'
blocktext-wanted-parameter = the name of a parameter or ')'

## Words and symbols

blocktext-write-instead = Write '{ $instead }' instead of '{ $found }'.
# $quote: " or '
blocktext-straight-quote = Write a straight quote { $quote } instead of { $found }.
blocktext-semicolon = Remove ';' and write each statement on its own line.
blocktext-braces = Block-Text has braces only for dictionaries, such as 'ages = {"{"}"Ana": 10{"}"}'. A block begins with ':' and closes with 'end'.
blocktext-entry-equals = Between a key and its value there is ':', not '='.
blocktext-entry-without-value = A dictionary has a value for each key, such as '{"{"}"Ana": 10{"}"}'. A list has square brackets.
blocktext-meaningless = '{ $found }' has no meaning in Block-Text. Remove it.
# $name: the character's name in Unicode, such as zero width space; $number: such as U+200B
blocktext-invisible = There is an invisible character here: { $name }, { $number }. Delete it, or type this part of the line again.
blocktext-odd-space = There is an unusual space here: { $name }, { $number }. Type a plain space instead.
blocktext-reserved-word = '{ $word }' is a reserved word. Choose another name.
blocktext-unknown-word = No statement begins with '{ $word }'. Check its spelling.
blocktext-unknown-word-near = No statement begins with '{ $word }'. Did you mean '{ $near }'?
blocktext-switch = Block-Text has no 'switch'. Use 'if' and 'elif'.
blocktext-case = Block-Text has no 'case'. Write 'if' or 'elif' and a condition, such as 'elif x == 1:'.
blocktext-walrus = In Block-Text, a value can't set a variable. Write '{ $line }' on the line above, and '{ $instead }' instead of '{ $found }'.
# $word: var or let
blocktext-declaration = Block-Text has no '{ $word }'. Write only the name, '=' and the value.
blocktext-loop = Block-Text has no 'loop'. Write 'repeat 10:' or 'forever:'.
blocktext-foreach = Block-Text has no 'foreach'. Write 'for x in values:'.
blocktext-from = Block-Text has no 'from'. Write 'import "name"' to import a library.
blocktext-python-statement = Block-Text has no '{ $word }', but Python has. Write a backtick before and after this line.
blocktext-python-block = Block-Text has no '{ $word }', but Python has. Write a backtick before this line and another before its ':'; below the last part write 'end'.
# $word: a word of Python, such as class
blocktext-global = Remove 'global': every variable is shared, except for those that are 'local'.
blocktext-is = Write '==' to compare. Block-Text has no 'is'.

## Values

blocktext-assignment-in-condition = Write '==' to compare. '=' sets a variable.
blocktext-not-needs-brackets = Put 'not' and what follows it in brackets, as in '(not x)'.
blocktext-closes-nothing = This '{ $found }' closes nothing. Remove it.
blocktext-missing-comma = Write ',' between '{ $first }' and '{ $second }'.
blocktext-without-space = Write '{ $operator }' without a space.
blocktext-slice = Write 'sublist(values, from, to)' for part of a list.
blocktext-unclosed-bracket = This '{ $opening }' is never closed. Write '{ $closing }' where it ends.
blocktext-unclosed-bracket-in-line = This '{ $opening }' is never closed. Write '{ $closing }' at the end of the line: '{ $instead }'.
blocktext-unclosed-bracket-before-colon = This '(' is never closed. Write ')' before the ':': '{ $instead }'.
blocktext-unclosed-bracket-below = This '{ $opening }' is never closed. Write '{ $closing }' at the end of line { $last }: '{ $instead }'.
blocktext-default-value = A parameter has no default value in Block-Text. Write '{ $instead }', and give all values in each call.
blocktext-parameter-type = A parameter is only a name in Block-Text, without a type. Write '{ $instead }'.
blocktext-any-arguments = A function in Block-Text takes a fixed number of values. Write '{ $instead }', and pass a list for more of them.
blocktext-result-type = A function has no type in Block-Text. Write '{ $instead }'.
blocktext-too-deep = This is nested too deeply. Store part of it in a variable.
blocktext-too-many-operators = This calculation has more than { $limit } steps. Store the first part in a variable, and continue with it on the next line.
blocktext-number-too-long = A number with { $digits } digits is too long. It must have fewer than { $limit }.
blocktext-bad-number = '{ $text }' is not a number. Write one such as 40 or 0.5.
# $text: such as 3m
blocktext-number-with-letters = '{ $text }' is neither a number nor a name. Write numbers without a unit, and begin names with a letter.

## Text

# $quote: the character that opens the text
blocktext-missing-quote = There is no closing { $quote } on this line. Write { $quote } where the text ends.
blocktext-triple-quote = Write one quote on each side of the text. Use '\n' for a new line.
blocktext-join-texts = Use '+' to join two pieces of text.
# $prefix: a letter such as f
blocktext-string-prefix = Block-Text has no '{ $prefix }' before quotes. Leave it out, and write '\\' for a backslash in the text.
blocktext-f-string-quotes = The text ends at these quotes. Use the other kind of quotes inside the braces, as in f"{"{"}d['name']{"}"}".
blocktext-f-string-space = Write no space between '{ $prefix }' and the quotes.
blocktext-f-string-value = This value is too complicated for a text. Give it a name on the line above, such as 'x = ...', and write '{"{"}x{"}"}' here.
blocktext-f-string-brace = In text with 'f', values go between '{"{"}' and '{"}"}'. To show a brace, write it twice.
blocktext-f-string-format = Block-Text writes a value as it is. Round it first, such as '{"{"}round(x, 1){"}"}'.
# $escape: such as \u
blocktext-escape-without-number = '{ $escape }' must be followed by the number of a character. Write '\\' for a backslash.
blocktext-no-character-number = There is no character with the number { $number }. Write '\\' for a backslash.
blocktext-no-character-name = There is no character named '{ $name }'. Write '\\' for a backslash.

## Names and calls

blocktext-comparison-as-statement = Write '{ $name } = ...' to set '{ $name }'. '==' compares.
blocktext-count = Write '{ $name } { $operator }= 1' to count.
blocktext-name-alone = '{ $name }' does nothing by itself. Write '{ $name }()' to call it.
blocktext-call-or-assignment = Write '(' after '{ $name }' to call it, or '=' to set it.
blocktext-skill-of-robot = Write 'function.{ $skill }(...)' to use this skill.
# $name: with a dot, such as values.append
blocktext-dot = Block-Text has no '{ $name }': call functions without a dot, as in 'append(values, 1)' or 'sqrt(9)'. Write a backtick before and after other Python.
blocktext-call-needs-brackets = Write 'function.{ $skill }()'. A call needs its brackets.
blocktext-missing-brackets = Write the arguments of '{ $name }' in brackets: '{ $name }(...)'.
blocktext-duplicate-argument = The argument '{ $name }' is given twice. Remove one.
blocktext-argument-order = Write arguments without a name before '{ $name }='.
blocktext-unused-value = This value is not used. Store it in a variable.
blocktext-unused-result = This value is not used. Store it in a variable, or write only the call.
blocktext-call-as-target = A call can't be set. Write a variable before '='.
blocktext-second-assignment = Set one variable per line, with one '='. First store a value that you still need in another variable.
blocktext-duplicate-parameter = Two parameters are called '{ $name }'. Rename one.
# $example: the name of a library
blocktext-import-name = Write only the name of the library, as in 'import "{ $example }"', without a folder or '.py'.

## Lines and blocks

blocktext-two-statements = Start a new line before '{ $word }'. Each statement needs its own line.
# $word: the word that begins the block, here and below
blocktext-missing-colon = Write ':' at the end of this '{ $word }' line.
blocktext-empty-block = This '{ $word }' is empty. Write 'pass' if it should do nothing.
# $words: the first line of a part, such as except ValueError
blocktext-not-a-beginning = '{ $words }' can't begin a block. Remove the 'end' above it, or write the first part of its block above.
blocktext-match-without-case = A 'match' has cases and nothing else. Write one below it, such as '`case 1`:'.
blocktext-missing-end = This '{ $word }' has no 'end'. Write 'end' on its own line below the block.
blocktext-python-without-end = This 'python:' has no 'end'. Write 'end' on its own line below the Python code.
blocktext-stray-end = This 'end' closes nothing. Remove it, or check the block above.
# $word: elif or else
blocktext-stray-branch = This '{ $word }' has no 'if'. Remove it, or check the 'end' lines above.
# $word: elif or else
blocktext-after-else = This '{ $word }' comes after 'else'. Move 'else' to the end.
blocktext-else-with-condition = 'else' has no condition. Write '{ $instead }' instead of '{ $found }'.
blocktext-nested = '{ $word }' can't be inside '{ $opener }'. Move it to the top level.
blocktext-too-many-blocks = More than { $limit } blocks are nested here. Move some of them into a function.
blocktext-for-equals = Write 'for { $name } from 1 to 10:', without '='.

## Lines of other languages. $found: a part of the line, $instead: what to write instead

blocktext-comment = A comment begins with '#'. Write '{ $instead }' instead of '{ $found }'.
blocktext-endless = Block-Text has no '{ $found }'. Write 'forever:' to repeat forever, or 'repeat 10:' to repeat a number of times.
blocktext-repeat-number = 'repeat' needs a number. Write 'repeat 10:', or 'forever:' to repeat forever.
blocktext-function-for-def = 'function.' uses a skill of the robot. Write '{ $header }' to make your own function.
blocktext-drive = Block-Text has no '{ $found }'. '{ $instead }' drives at 40 mm/s until the next command. To stop after 2 seconds, write 'function.sleep(2)' and 'function.stop_bot()' below it.
blocktext-steps = The robot has no steps. '{ $instead }' drives at 40 mm/s until the next command. To stop after 2 seconds, write 'function.sleep(2)' and 'function.stop_bot()' below it.
blocktext-stop-all = Block-Text has no '{ $found }'. Write '{ $instead }' to stop the wheels, or 'break' to leave a loop.
blocktext-no-event = Block-Text has no event '{ $found }'. Write a condition of the robot, as in 'when seen = function.is_any_tag():'.
blocktext-broadcast = Write '{ $instead }' instead of '{ $found }', and a 'when { $name }:' block. To run it only once, put 'deactivate { $name }' as its last line.
blocktext-when-needs-name = A 'when' needs a name before its condition. Write '{ $instead }'.
blocktext-declared = A variable needs no type and no 'var'. Write '{ $instead }' instead of '{ $found }'.
blocktext-local-outside = Only a function or a 'when' has local variables. Write '{ $instead }' instead of '{ $found }'.
blocktext-name-with-space = A name is one word. Write '{ $instead }' instead of '{ $found }'.
blocktext-name-with-hyphen = A name has no '-', which subtracts. Write '{ $instead }' instead of '{ $found }'.
blocktext-name-with-digit = A name can't begin with a digit. Write '{ $instead }' instead of '{ $found }'.
blocktext-decimal-comma = Numbers have a decimal point. Write '{ $instead }' instead of '{ $found }'.
blocktext-sum-as-target = '=' sets the variable on its left, so only one name can be there. Write '{ $name } = ...'. To compare, write 'if { $sum } == { $value }:'.
blocktext-two-targets = A line sets only one variable. Write '{ $instead }', and '{ $second }' on the next line.
blocktext-many-targets = A line sets only one variable. Write { $lines }, each on its own line.
blocktext-swap = A line sets only one variable. To swap, write 'old = { $first }', '{ $first } = { $second }', '{ $second } = old', each on its own line.
blocktext-unit = Write numbers without a unit: '{ $instead }' instead of '{ $found }'.
blocktext-text-in-quotes = Text needs quotes. Write '{ $instead }' instead of '{ $found }'.
blocktext-straight-quotes = Text needs straight quotes. Write { $instead } instead of { $found }.
blocktext-two-quotes = Two ' next to each other do not make one ". Write { $instead } instead of { $found }.
blocktext-multiply = Write '*' to multiply: '{ $instead }' instead of '{ $found }'.
blocktext-name-again = Each side of 'and' and 'or' needs its own variable. Write '{ $instead }' instead of '{ $found }'.
blocktext-python-file = This line is Python. Remove it, or give the file a name that ends in '.py'.
blocktext-import-not-needed = Remove this line. Block-Text has functions such as 'sqrt(9)', 'random(1, 6)' and 'function.sleep(1)' without an import.
blocktext-if-without-else = A value with 'if' needs 'else' and the other value, such as '"near" if x < 10 else "far"'.
blocktext-lambda = Block-Text has no 'lambda'. Write '{ $header }', 'return { $value }', 'end', each on its own line.
blocktext-comprehension = Block-Text has no 'for' inside brackets, but Python has. Write a backtick before and after it: { $line }
blocktext-tuple = Write a list in square brackets, or Python's tuple between backticks: { $instead }
blocktext-set = A dictionary has a value for each key, such as '{"{"}"Ana": 10{"}"}'. Write a list in square brackets, or Python's set between backticks: { $instead }
blocktext-comma-in-list = Items of a list are separated by commas. Write '{ $instead }' instead of '{ $found }'.
