# Problems of blocks, shown at the block.

workspace-missing-value = A este bloque le falta un valor. Encaja uno.
workspace-missing-condition = Este bloque no tiene condición y por eso cuenta como falsa. Encaja una.
workspace-missing-variable = A este bloque le falta una variable. Elige una.
workspace-missing-python = Escribe aquí una expresión de Python.
workspace-bad-number = Esto no es un número. Escribe uno, como 40.
# $field: the name of the field
workspace-unknown-choice = Este bloque tiene una opción desconocida en '{ $field }'. Elige otra.
# $nearest: a name that is allowed
workspace-bad-name = '{ $name }' no puede ser un nombre aquí. Usa letras, cifras y _, como en '{ $nearest }', pero no una palabra reservada.
workspace-duplicate-argument = El argumento '{ $name }' aparece dos veces. Cambia el nombre de uno o quítalo.
workspace-duplicate-parameter = Dos parámetros de esta función se llaman igual. Cambia el nombre de uno.
workspace-unknown-skill = Aquí no hay ninguna habilidad '{ $name }'. Quita este bloque.
# $type: the name of the type in Blockly
workspace-unknown-block = Un programa no puede tener aquí un bloque de tipo '{ $type }'. Quítalo.
workspace-misplaced-block = Este bloque va bajo 'al empezar', fuera de todos los demás bloques.
workspace-robot-not-first = 'robot' va antes que todo lo demás. Mueve este bloque al principio.
workspace-second-main = Un programa solo puede tener un bloque principal. Mueve los bloques de debajo de este al otro.
workspace-empty-comparison = Esta comparación no compara nada. Quítala.
workspace-python-lines = Un valor de Python va en una sola línea. Usa el bloque de líneas de Python.
workspace-unused-value = Este valor no se usa. Guárdalo en una variable, o quítalo.
workspace-list-without-name = Solo se puede cambiar una lista que esté en una variable. Elige una.
workspace-import-name = Escribe solo el nombre de la biblioteca, como 'dance', sin carpeta y sin '.py'.
workspace-too-many-values = Aquí hay demasiados valores unos dentro de otros. Guarda algunos en una variable.
workspace-too-deep = Aquí hay demasiados bloques unos dentro de otros. Mueve algunos a una función.
