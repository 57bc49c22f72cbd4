# Errors in Block-Text: what cannot be read, and what to write instead.
# They appear under the line that they are about, on the page and in "learnblock check".

## A whole program

blocktext-too-long = El programa tiene { $characters } caracteres y es demasiado largo. El límite es { $limit }.
# $number: such as U+0000
blocktext-forbidden-character = El carácter { $number } no puede estar en un programa. Quítalo.
blocktext-second-main = Un programa solo puede tener un 'main'. Une los dos.

## What was expected: $wanted and $found are noun phrases from the messages below

blocktext-expected = Aquí hace falta { $wanted }, no { $found }.
blocktext-no-statement = Una instrucción no puede empezar con { $found }.
# $text: a word or symbol of the program
blocktext-token = '{ $text }'
blocktext-end-of-line = el final de la línea
blocktext-end-of-program = el final del programa
blocktext-wanted-value = un valor
blocktext-wanted-value-after = un valor después de '{ $word }'
blocktext-wanted-operator = un operador
blocktext-wanted-either = '{ $first }' o '{ $second }'
blocktext-wanted-dot-and-skill = '.' y el nombre de una habilidad después de 'function'
blocktext-wanted-skill = el nombre de una habilidad después de 'function.'
# $word: the word that begins the block
blocktext-wanted-colon = ':' para terminar la línea de '{ $word }'
# $word: activate or deactivate
blocktext-wanted-when = el nombre de un 'when' después de '{ $word }'
blocktext-wanted-when-name = un nombre después de 'when', como en 'when seen = condition:'
blocktext-wanted-loop-variable = el nombre de una variable después de 'for'
blocktext-wanted-in = 'in' y una lista
blocktext-wanted-in-or-from = 'in' y una lista, o 'from' y un número
blocktext-wanted-to = 'to' y el último número
blocktext-wanted-library = el nombre de una biblioteca entre comillas, como en 'import "dance"'
blocktext-wanted-function-name = el nombre de la función después de 'def'
blocktext-wanted-parameters = '(' después de 'def { $name }'
blocktext-wanted-parameter = el nombre de un parámetro o ')'

## Words and symbols

blocktext-write-instead = Escribe '{ $instead }' en lugar de '{ $found }'.
# $quote: " or '
blocktext-straight-quote = Escribe una comilla recta { $quote } en lugar de { $found }.
blocktext-semicolon = Quita ';' y escribe cada instrucción en su propia línea.
blocktext-braces = En Block-Text las llaves son solo para diccionarios, por ejemplo 'ages = {"{"}"Ana": 10{"}"}'. Un bloque empieza con ':' y se cierra con 'end'.
blocktext-entry-equals = Entre una clave y su valor va ':', no '='.
blocktext-entry-without-value = Un diccionario tiene un valor para cada clave, por ejemplo '{"{"}"Ana": 10{"}"}'. Una lista lleva corchetes.
blocktext-meaningless = '{ $found }' no significa nada en Block-Text. Quítalo.
# $name: the character's name in Unicode, such as zero width space; $number: such as U+200B
blocktext-invisible = Aquí hay un carácter invisible: { $name }, { $number }. Bórralo, o vuelve a escribir esta parte de la línea.
blocktext-odd-space = Aquí hay un espacio poco común: { $name }, { $number }. Escribe un espacio normal en su lugar.
blocktext-reserved-word = '{ $word }' es una palabra reservada. Elige otro nombre.
blocktext-unknown-word = Ninguna instrucción empieza con '{ $word }'. Revisa cómo está escrito.
blocktext-unknown-word-near = Ninguna instrucción empieza con '{ $word }'. ¿Querías decir '{ $near }'?
blocktext-switch = En Block-Text no hay 'switch'. Usa 'if' y 'elif'.
blocktext-case = En Block-Text no hay 'case'. Escribe 'if' o 'elif' y una condición, por ejemplo 'elif x == 1:'.
blocktext-walrus = En Block-Text, un valor no da valor a ninguna variable. Escribe '{ $line }' en la línea anterior, y '{ $instead }' en lugar de '{ $found }'.
# $word: var or let
blocktext-declaration = En Block-Text no hay '{ $word }'. Escribe solo el nombre, '=' y el valor.
blocktext-loop = En Block-Text no hay 'loop'. Escribe 'repeat 10:' o 'forever:'.
blocktext-foreach = En Block-Text no hay 'foreach'. Escribe 'for x in values:'.
blocktext-from = En Block-Text no hay 'from'. Escribe 'import "name"' para importar una biblioteca.
blocktext-python-statement = En Block-Text no hay '{ $word }', pero en Python sí. Escribe un acento grave antes y otro después de esta línea.
blocktext-python-block = En Block-Text no hay '{ $word }', pero en Python sí. Escribe un acento grave antes de esta línea y otro antes de sus ':'; debajo de la última parte, escribe 'end'.
# $word: a word of Python, such as class
blocktext-global = Quita 'global': todas las variables son compartidas, salvo las que son 'local'.
blocktext-is = Escribe '==' para comparar. En Block-Text no hay 'is'.

## Values

blocktext-assignment-in-condition = Escribe '==' para comparar. '=' da valor a una variable.
blocktext-not-needs-brackets = Pon 'not' y lo que le sigue entre paréntesis, como en '(not x)'.
blocktext-closes-nothing = Este '{ $found }' no cierra nada. Quítalo.
blocktext-missing-comma = Escribe ',' entre '{ $first }' y '{ $second }'.
blocktext-without-space = Escribe '{ $operator }' sin espacio.
blocktext-slice = Escribe 'sublist(values, from, to)' para una parte de una lista.
blocktext-unclosed-bracket = Este '{ $opening }' no se cierra. Escribe '{ $closing }' donde termina.
blocktext-unclosed-bracket-in-line = Este '{ $opening }' no se cierra nunca. Escribe '{ $closing }' al final de la línea: '{ $instead }'.
blocktext-unclosed-bracket-before-colon = Este '(' no se cierra nunca. Escribe ')' antes de ':': '{ $instead }'.
blocktext-unclosed-bracket-below = Este '{ $opening }' no se cierra nunca. Escribe '{ $closing }' al final de la línea { $last }: '{ $instead }'.
blocktext-default-value = En Block-Text un parámetro no tiene valor por defecto. Escribe '{ $instead }' y da todos los valores en cada llamada.
blocktext-parameter-type = En Block-Text un parámetro es solo un nombre, sin tipo. Escribe '{ $instead }'.
blocktext-any-arguments = En Block-Text una función recibe un número fijo de valores. Escribe '{ $instead }' y pasa una lista si son más.
blocktext-result-type = En Block-Text una función no tiene tipo. Escribe '{ $instead }'.
blocktext-too-deep = Aquí hay demasiadas cosas unas dentro de otras. Guarda una parte en una variable.
blocktext-too-many-operators = Este cálculo tiene más de { $limit } pasos. Guarda la primera parte en una variable y sigue con ella en la línea siguiente.
blocktext-number-too-long = Un número de { $digits } cifras es demasiado largo. Debe tener menos de { $limit }.
blocktext-bad-number = '{ $text }' no es un número. Escribe uno, como 40 o 0.5.
# $text: such as 3m
blocktext-number-with-letters = '{ $text }' no es ni un número ni un nombre. Escribe los números sin unidad y empieza los nombres con una letra.

## Texts

# $quote: the character that opens the text
blocktext-missing-quote = En esta línea falta { $quote } para cerrar. Escribe { $quote } donde termina el texto.
blocktext-triple-quote = Escribe una sola comilla a cada lado del texto. Usa '\n' para una línea nueva.
blocktext-join-texts = Une dos textos con '+'.
# $prefix: a letter such as f
blocktext-string-prefix = En Block-Text no hay '{ $prefix }' antes de las comillas. Quítala, y escribe '\\' para una barra invertida en el texto.
blocktext-f-string-quotes = El texto termina en estas comillas. Usa el otro tipo de comillas dentro de las llaves, como en f"{"{"}d['name']{"}"}".
blocktext-f-string-space = No pongas espacio entre '{ $prefix }' y las comillas.
blocktext-f-string-value = Este valor es demasiado complicado para un texto. Dale un nombre en la línea de arriba, como 'x = ...', y escribe aquí '{"{"}x{"}"}'.
blocktext-f-string-brace = En un texto con 'f', los valores van entre '{"{"}' y '{"}"}'. Para escribir una llave, ponla dos veces.
blocktext-f-string-format = Block-Text escribe los valores como son. Redondéalos antes, por ejemplo '{"{"}round(x, 1){"}"}'.
# $escape: such as \u
blocktext-escape-without-number = Después de '{ $escape }' va el número de un carácter. Para una barra inversa, escribe '\\'.
blocktext-no-character-number = No hay ningún carácter con el número { $number }. Para una barra inversa, escribe '\\'.
blocktext-no-character-name = No hay ningún carácter que se llame '{ $name }'. Para una barra inversa, escribe '\\'.

## Names and calls

blocktext-comparison-as-statement = Escribe '{ $name } = ...' para dar valor a '{ $name }'. '==' compara.
blocktext-count = Escribe '{ $name } { $operator }= 1' para contar.
blocktext-name-alone = '{ $name }' no hace nada por sí solo. Escribe '{ $name }()' para llamarlo.
blocktext-call-or-assignment = Escribe '(' después de '{ $name }' para llamarlo, o '=' para darle un valor.
blocktext-skill-of-robot = Escribe 'function.{ $skill }(...)' para usar esta habilidad.
# $name: with a dot, such as values.append
blocktext-dot = En Block-Text no hay '{ $name }': las funciones se llaman sin punto, como en 'append(values, 1)' o 'sqrt(9)'. Escribe un acento grave antes y otro después de otro código de Python.
blocktext-call-needs-brackets = Escribe 'function.{ $skill }()'. Una llamada lleva paréntesis.
blocktext-missing-brackets = Escribe los argumentos de '{ $name }' entre paréntesis: '{ $name }(...)'.
blocktext-duplicate-argument = El argumento '{ $name }' aparece dos veces. Quita uno.
blocktext-argument-order = Escribe los argumentos sin nombre antes de '{ $name }='.
blocktext-unused-value = Este valor no se usa. Guárdalo en una variable.
blocktext-unused-result = Este valor no se usa. Guárdalo en una variable, o escribe solo la llamada.
blocktext-call-as-target = A una llamada no se le puede dar un valor. Escribe una variable antes de '='.
blocktext-second-assignment = Da valor a una sola variable por línea, con un solo '='. Guarda antes en otra variable el valor que todavía necesites.
blocktext-duplicate-parameter = Dos parámetros se llaman '{ $name }'. Cambia el nombre de uno.
# $example: the name of a library
blocktext-import-name = Escribe solo el nombre de la biblioteca, como en 'import "{ $example }"', sin carpeta y sin '.py'.

## Lines and blocks

blocktext-two-statements = Empieza una línea nueva antes de '{ $word }'. Cada instrucción va en su propia línea.
# $word: the word that begins the block, here and below
blocktext-missing-colon = Escribe ':' al final de esta línea de '{ $word }'.
blocktext-empty-block = Este '{ $word }' está vacío. Escribe 'pass' si no debe hacer nada.
# $words: la primera línea de una parte, por ejemplo except ValueError
blocktext-not-a-beginning = '{ $words }' no puede empezar un bloque. Quita el 'end' de arriba, o escribe encima la primera parte de su bloque.
blocktext-match-without-case = Un 'match' tiene casos y nada más. Escribe uno debajo, por ejemplo '`case 1`:'.
blocktext-missing-end = A este '{ $word }' le falta el 'end'. Escribe 'end' en su propia línea, debajo del bloque.
blocktext-python-without-end = A este 'python:' le falta el 'end'. Escribe 'end' en su propia línea, debajo del código de Python.
blocktext-stray-end = Este 'end' no cierra nada. Quítalo, o revisa el bloque de arriba.
# $word: elif or else
blocktext-stray-branch = A este '{ $word }' le falta su 'if'. Quítalo, o revisa las líneas 'end' de arriba.
# $word: elif or else
blocktext-after-else = Este '{ $word }' va después de 'else'. Mueve 'else' al final.
blocktext-else-with-condition = 'else' no lleva condición. Escribe '{ $instead }' en lugar de '{ $found }'.
blocktext-nested = '{ $word }' no puede ir dentro de '{ $opener }'. Muévelo fuera de todos los bloques.
blocktext-too-many-blocks = Aquí hay más de { $limit } bloques unos dentro de otros. Mueve algunos a una función.
blocktext-for-equals = Escribe 'for { $name } from 1 to 10:', sin '='.

## Lines of other languages. $found: a part of the line, $instead: what to write instead

blocktext-comment = Un comentario empieza por '#'. Escribe '{ $instead }' en lugar de '{ $found }'.
blocktext-endless = En Block-Text no hay '{ $found }'. Escribe 'forever:' para repetir siempre, o 'repeat 10:' para repetir un número de veces.
blocktext-repeat-number = 'repeat' necesita un número. Escribe 'repeat 10:', o 'forever:' para repetir siempre.
blocktext-function-for-def = 'function.' usa una habilidad del robot. Escribe '{ $header }' para crear tu propia función.
blocktext-drive = En Block-Text no hay '{ $found }'. Con '{ $instead }' el robot avanza a 40 mm/s hasta la siguiente orden. Para que pare a los 2 segundos, escribe debajo 'function.sleep(2)' y 'function.stop_bot()'.
blocktext-steps = El robot no avanza por pasos. Con '{ $instead }' el robot avanza a 40 mm/s hasta la siguiente orden. Para que pare a los 2 segundos, escribe debajo 'function.sleep(2)' y 'function.stop_bot()'.
blocktext-stop-all = En Block-Text no hay '{ $found }'. Escribe '{ $instead }' para parar las ruedas, o 'break' para salir de un bucle.
blocktext-no-event = En Block-Text no hay el evento '{ $found }'. Escribe una condición del robot, como en 'when seen = function.is_any_tag():'.
blocktext-broadcast = Escribe '{ $instead }' en lugar de '{ $found }', y un bloque 'when { $name }:'. Para que se ejecute una sola vez, pon 'deactivate { $name }' en su última línea.
blocktext-when-needs-name = Un 'when' necesita un nombre antes de su condición. Escribe '{ $instead }'.
blocktext-declared = Una variable no necesita tipo ni 'var'. Escribe '{ $instead }' en lugar de '{ $found }'.
blocktext-local-outside = Solo una función o un 'when' tiene variables locales. Escribe '{ $instead }' en lugar de '{ $found }'.
blocktext-name-with-space = Un nombre es una sola palabra. Escribe '{ $instead }' en lugar de '{ $found }'.
blocktext-name-with-hyphen = Un nombre no lleva '-', que resta. Escribe '{ $instead }' en lugar de '{ $found }'.
blocktext-name-with-digit = Un nombre no puede empezar por una cifra. Escribe '{ $instead }' en lugar de '{ $found }'.
blocktext-decimal-comma = Los decimales van con punto. Escribe '{ $instead }' en lugar de '{ $found }'.
blocktext-sum-as-target = '=' da valor a la variable de su izquierda, así que ahí solo puede haber un nombre. Escribe '{ $name } = ...'. Para comparar, escribe 'if { $sum } == { $value }:'.
blocktext-two-targets = Una línea da valor a una sola variable. Escribe '{ $instead }' y, en la línea siguiente, '{ $second }'.
blocktext-many-targets = Una línea solo da valor a una variable. Escribe { $lines }, cada una en su propia línea.
blocktext-swap = Una línea da valor a una sola variable. Para intercambiarlas, escribe 'old = { $first }', '{ $first } = { $second }', '{ $second } = old', cada una en su propia línea.
blocktext-unit = Los números van sin unidad: escribe '{ $instead }' en lugar de '{ $found }'.
blocktext-text-in-quotes = Los textos van entre comillas. Escribe '{ $instead }' en lugar de '{ $found }'.
blocktext-straight-quotes = Los textos van entre comillas rectas. Escribe { $instead } en lugar de { $found }.
blocktext-two-quotes = Dos ' seguidas no son lo mismo que una ". Escribe { $instead } en lugar de { $found }.
blocktext-multiply = Para multiplicar se escribe '*': '{ $instead }' en lugar de '{ $found }'.
blocktext-name-again = Cada lado de 'and' y 'or' necesita su propia variable. Escribe '{ $instead }' en lugar de '{ $found }'.
blocktext-python-file = Esta línea es Python. Quítala, o dale al archivo un nombre que termine en '.py'.
blocktext-import-not-needed = Quita esta línea. Block-Text tiene funciones como 'sqrt(9)', 'random(1, 6)' y 'function.sleep(1)' sin importar nada.
blocktext-if-without-else = Un valor con 'if' necesita 'else' y el otro valor, por ejemplo '"near" if x < 10 else "far"'.
blocktext-lambda = En Block-Text no hay 'lambda'. Escribe '{ $header }', 'return { $value }', 'end', cada uno en su propia línea.
blocktext-comprehension = En Block-Text no hay 'for' entre corchetes o llaves, pero en Python sí. Escribe un acento grave delante y otro detrás: { $line }
blocktext-tuple = Escribe una lista entre corchetes, o la tupla de Python entre acentos graves: { $instead }
blocktext-set = Un diccionario tiene un valor para cada clave, por ejemplo '{"{"}"Ana": 10{"}"}'. Escribe una lista entre corchetes, o el conjunto de Python entre acentos graves: { $instead }
blocktext-comma-in-list = Los elementos de una lista se separan con comas. Escribe '{ $instead }' en lugar de '{ $found }'.
