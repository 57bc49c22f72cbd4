# Why a name can't be changed, or functions can't become a library.

## A new name

edit-bad-name = '{ $name }' no puede ser un nombre. Usa letras, cifras y _, y no empieces con una cifra.
edit-variable-exists = Ya hay una variable '{ $name }'. Elige otro nombre.
edit-function-exists = Ya hay una función '{ $name }'. Elige otro nombre.
edit-when-exists = Ya hay un 'when { $name }'. Elige otro nombre.
edit-name-of-state = '{ $name }' es el estado de 'when { $when }'. Elige otro nombre.
edit-language-function = '{ $name }' es una función del lenguaje. Elige otro nombre.
edit-when-start = 'when start' no puede cambiar de nombre, porque solo este nombre se ejecuta al empezar.
edit-used-in-line = El código de Python de la línea { $line } usa '{ $name }'. Cámbialo allí a mano.
edit-used-in-python = El código de Python del programa usa '{ $name }'. Cámbialo allí a mano.

## Functions for a library. $function: the function that needs something else

edit-event-in-library = '{ $function }' usa el evento '{ $name }', y una biblioteca no puede tener un 'when'. Pasa el valor como argumento.
edit-call-in-library = '{ $function }' llama a '{ $name }', que no es una función de este programa. Una biblioteca tiene que contener todas las funciones que llama.
edit-function-without-call = '{ $function }' usa la función '{ $name }' sin llamarla en Block-Text. Llámala en Block-Text, para que reciba el robot.
edit-set-in-python = El código de Python de '{ $function }' usa '{ $name }', que otro código de Python del programa define. Defínelo o impórtalo dentro de la función.
edit-shared-variable = Las funciones usan '{ $name }', que también cambia en la línea { $line }. Pásalo como argumento, porque una biblioteca tiene sus propias variables.
edit-variable-from-robot = '{ $name }' recibe su primer valor del robot o de una función, que una biblioteca todavía no tiene. Pásalo como argumento.

## The program has errors

# $task: rename, import (a library) or format
edit-errors-first = Corrige primero los errores del programa. { $task ->
    [import] Después importa la biblioteca.
    [rename] Después cambia el nombre.
   *[format] Después ordena el programa.
}
