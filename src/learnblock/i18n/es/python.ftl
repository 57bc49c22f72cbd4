# Errors in Python: in a Python program, or in a part of a program that is Python.

python-too-deep = En este código de Python hay demasiadas cosas unas dentro de otras. Guarda una parte en una variable.
# Any other error. $reason: the message of Python, in English
python-syntax = Esto no es Python válido: { $reason }.
python-invalid-syntax = Python no entiende esto. Revisa si hay erratas o si falta algún símbolo.
python-missing-comma = Python no entiende esto. ¿Falta una coma?
python-comparison = Escribe '==' para comparar. '=' da valor a una variable.
python-expected = Escribe '{ $symbol }' aquí.
python-missing-block = Pon { $spaces } espacios al principio de esta línea. Pertenece a '{ $header }', más arriba.
python-no-block = Dentro de '{ $header }' no hay nada. Escribe una línea debajo, con { $spaces } espacios al principio.
python-unexpected-indent = Quita los espacios del principio de esta línea. Tiene demasiada sangría.
python-uneven-indent = Pon en esta línea la misma sangría que en una de las líneas de arriba.
python-tabs-and-spaces = Usa solo espacios para la sangría. Aquí se mezclan tabuladores y espacios.
python-never-closed = Este '{ $symbol }' no se cierra nunca. Escribe '{ $closing }' donde termina.
python-never-closed-in-line = Este '{ $symbol }' no se cierra nunca. Escribe '{ $closing }' donde termina: '{ $instead }'.
python-brackets-never-closed = Aquí quedan { $count } paréntesis o corchetes sin cerrar. Escribe '{ $closing }' al final: '{ $instead }'.
python-never-closed-below = Este '{ $symbol }' no se cierra nunca. Escribe '{ $closing }' al final de la línea { $last }, después de '{ $after }'.
python-unmatched = Este '{ $symbol }' no cierra nada. Quítalo, o escribe el paréntesis que lo abre.
python-wrong-bracket = Este '{ $closing }' no corresponde al '{ $opening }' que está abierto.
python-missing-quote = A este texto le faltan las comillas de cierre. Escríbelas donde termina el texto.
python-unexpected-end = El programa se acaba antes de tiempo. Revisa si falta un paréntesis o una línea.
python-bad-number = Esto no es ni un número ni un nombre. Empieza los nombres con una letra.
python-bad-character = El carácter { $character } no puede estar aquí. Quítalo, o escribe uno normal.
python-bad-target = Escribe el nombre de una variable antes de '='.
python-after-backslash = Después de '\' no puede haber nada en su línea. Quítalo.
python-call-without-brackets = Escribe los argumentos de '{ $function }' entre paréntesis: '{ $function }(...)'.

## Lines of other languages

python-block-text = '{ $found }' es Block-Text, no Python. Dale al archivo un nombre que termine en '.bt', o escribe solo lo que hay dentro del bloque.
python-main = '{ $found }' es Block-Text. En Python no hay '{ $found }': quítalo, y también los espacios del principio de las líneas de debajo.
python-when = '{ $found }' es Block-Text. En Python escribe '{ $decorator }', debajo 'def { $name }():' y, en la última línea, 'robot.run()'.
python-count = Escribe '{ $found } += 1' para contar.
python-brace = Quita '{ $found }'. En Python un bloque termina donde termina su sangrado.

## Names that do not exist

# $module: such as sim_ebo
python-no-robot = El programa no tiene robot. Escribe 'from learnblock.robots.{ $module } import Robot' y 'robot = Robot()' al principio.
python-robot-import = 'Robot' no se puede importar de ahí. Escribe 'from learnblock.robots.{ $module } import Robot'.
python-robot-not-created = El robot todavía no está creado. Escribe 'robot = Robot()'.
python-robot-lower-case = Escribe 'Robot()' con 'R' mayúscula: 'robot = Robot()'.
python-robot-class = Escribe 'robot.{ $skill }(...)', con 'r' minúscula.
python-function = En Python las habilidades son del robot. Escribe 'robot.{ $skill }(...)' en lugar de 'function.{ $skill }(...)'.
python-end = En Python no hay 'end'. Quítalo: un bloque termina donde termina su sangrado.
python-not-imported = El módulo '{ $module }' no está importado. Escribe 'import { $module }' al principio.
python-not-imported-from = '{ $name }' no está importado. Escribe 'from { $module } import { $name }' al principio.
python-skill-without-brackets = Una habilidad lleva paréntesis. Escribe 'robot.{ $skill }()'.
python-unknown-when = No hay ningún evento '{ $name }'. Escribe encima de esta línea '@robot.when' y, debajo, 'def { $name }():', o revisa el nombre.

## Events

# $found: such as @robot.whem
python-unknown-event = No existe '{ $found }'. Escribe '@robot.when' para un evento, o '@robot.when_start' para lo que se ejecuta una vez al empezar.
python-unknown-event-near = No existe '{ $found }'. ¿Querías decir '@robot.{ $near }'?
python-event-of-robot = Un evento es del robot. Escribe '@robot.{ $name }' en lugar de '{ $found }'.
python-event-without-at = Un evento empieza por '@'. Escribe '@robot.{ $name }'.
python-wait-without-lambda = Para esperar hay que comprobar la condición una y otra vez. Escribe 'robot.wait_until(lambda: { $condition })'.
python-event-without-lambda = Un evento tiene que comprobar su condición una y otra vez. Escribe '@robot.when(lambda: { $condition })'.
python-never-run = Los eventos no se ejecutan nunca, porque falta 'robot.run()'. Escríbelo en la última línea.
