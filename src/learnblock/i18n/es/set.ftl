# Los conjuntos de bloques: sus nombres y archivos.

set-bad-name = Un conjunto de bloques no se puede llamar '{ $name }'. Usa como mucho 60 letras, cifras, espacios, - y _.
set-built-in-name = '{ $name }' es el nombre de un conjunto de bloques incluido. Elige otro nombre.
set-name-taken = Ya tienes un conjunto de bloques '{ $name }'. Elige otro nombre, o guarda otra vez para sustituirlo.
set-unreadable = No se puede leer el conjunto de bloques: { $reason }

# Los conjuntos incluidos.
set-first-steps-title = Primeros pasos
set-first-steps-about = Una cosa tras otra: avanzar, girar, esperar, mostrar una emoción.
set-loops-and-functions-title = Bucles y funciones
set-loops-and-functions-about = Escribirlo una vez y ejecutarlo muchas: repetir, contar y dar nombre a una parte del programa.
set-senses-title = Sentidos y decisiones
set-senses-about = El robot percibe y decide: si, mientras, obstáculos, líneas, etiquetas, caras.
set-events-title = Eventos
set-events-about = Varias cosas a la vez: un evento para todo lo que puede pasar, y estados entre los que cambiar.
set-everything-title = Todo
set-everything-about = Todos los bloques, también los tuyos y los de las bibliotecas.
