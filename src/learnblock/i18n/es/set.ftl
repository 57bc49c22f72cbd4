# Los conjuntos de bloques: sus nombres y archivos.

set-bad-name = Un conjunto de bloques no se puede llamar '{ $name }'. Usa como mucho 60 letras, cifras, espacios, - y _.
set-built-in-name = '{ $name }' es el nombre de un conjunto de bloques incluido. Elige otro nombre.
set-name-taken = Ya tienes un conjunto de bloques '{ $name }'. Elige otro nombre, o guarda otra vez para sustituirlo.
set-unreadable = No se puede leer el conjunto de bloques: { $reason }
