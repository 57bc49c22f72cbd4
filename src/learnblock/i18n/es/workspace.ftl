# Problems of blocks, shown at the block.

workspace-missing-value = Este bloque tiene un hueco vacío. Encaja en él un valor, como un número, un texto o una variable.
workspace-missing-number = Este bloque tiene un hueco vacío para un número. Encaja uno, como un número de 'Cálculo' o una variable.
workspace-missing-text = Este bloque tiene un hueco vacío para un texto. Encaja uno, como un texto de 'Cálculo' o una variable.
workspace-missing-dictionary = A este bloque le falta un diccionario. Encaja la variable que lo guarda.
workspace-missing-list = Este bloque tiene un hueco vacío para una lista. Encaja una, como 'crear lista con' o una variable.
workspace-missing-text-or-list = 'longitud de' tiene un hueco vacío. Encaja un texto de 'Cálculo', 'crear lista con' de 'Variables', o una variable.
workspace-missing-variable-of-list = Este bloque no tiene lista que cambiar. Encaja una variable que contenga una lista.
workspace-missing-condition = A este bloque le falta una condición, y un hueco vacío cuenta como 'falso'. Encaja una comparación de 'Cálculo' o una pregunta al robot.
workspace-wait-without-condition = A este bloque le falta una condición, así que espera para siempre. Encaja una comparación de 'Cálculo' o una pregunta al robot.
workspace-missing-side = Un lado de este bloque está vacío, y un hueco vacío cuenta como 'falso'. Encaja una comparación de 'Cálculo' o una pregunta al robot.
workspace-empty-block = Dentro de este bloque no hay nada, así que no hace nada. Pon bloques dentro, o quítalo.
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
workspace-without-robot = Este programa no tiene robot. Borra el bloque 'sin robot'.
workspace-robot-not-first = 'robot' va antes que todo lo demás. Mueve este bloque al principio.
workspace-second-main = Un programa solo puede tener un 'al pulsar Ejecutar'. Mueve los bloques de este al otro, y borra este.
# $words: the first line of a part of a statement in Python
workspace-not-a-part = '{ $words }' no puede ser otra parte de este bloque. Empiézala con 'except', 'else', 'finally' o 'case'.
workspace-not-a-beginning = Un bloque no puede empezar con '{ $words }'. Pon esta parte en el bloque al que pertenece.
workspace-empty-comparison = Esta comparación no compara nada. Quítala.
workspace-python-lines = Un valor de Python va en una sola línea. Usa el bloque de líneas de Python.
workspace-unused-value = Este valor no se usa. Ponlo en un bloque 'establecer ... a', o quítalo.
workspace-list-without-name = Solo se puede cambiar una lista que esté en una variable. Elige una.
workspace-import-name = Escribe solo el nombre de la biblioteca, como 'dance', sin carpeta y sin '.py'.
workspace-too-many-values = Aquí hay demasiados valores unos dentro de otros. Guarda algunos en una variable.
workspace-too-deep = Aquí hay demasiados bloques unos dentro de otros. Mueve algunos a una función.

## Blocks that do not run

# $count: the number of blocks in the stack
workspace-loose-blocks = { $count ->
    [one] Este bloque no se ejecuta, porque no está unido al programa. Arrástralo debajo de 'al pulsar Ejecutar' o de otro bloque del programa, o bórralo.
   *[other] Estos { $count } bloques no se ejecutan, porque no están unidos al programa. Arrástralos debajo de 'al pulsar Ejecutar' o de otro bloque del programa, o bórralos.
}
workspace-no-program = { $count ->
    [one] Este bloque no se ejecuta, porque el programa no tiene 'al pulsar Ejecutar'. Tómalo de 'Eventos' y arrastra este bloque debajo.
   *[other] Estos { $count } bloques no se ejecutan, porque el programa no tiene 'al pulsar Ejecutar'. Tómalo de 'Eventos' y arrastra estos bloques debajo.
}
workspace-loose-value = Este valor no está encajado en ningún bloque, así que no hace nada. Arrástralo a un hueco de otro bloque, o bórralo.
workspace-only-functions = Nadie llama a '{ $name }', así que el programa no hace nada. Pon 'al pulsar Ejecutar', de 'Eventos', y debajo '{ $name }', de 'Mis bloques'.

## Mistakes in a program that check.ftl words for text: the same, in the words of blocks

workspace-unknown-name = '{ $name }' no tiene valor. Pon más arriba un bloque 'establecer { $name } a' de 'Variables'.
workspace-unknown-name-near = '{ $name }' no tiene valor. ¿Querías decir '{ $near }'? Elígela en este bloque.
workspace-read-before-set = '{ $name }' aún no tiene valor cuando el programa llega aquí. Sube el bloque 'establecer { $name } a' al principio del programa.
workspace-defined-below = El Python de este programa usa '{ $name }' aquí, por encima de su definición. Sube 'def { $name }' en la vista de Python.
workspace-unknown-function = No hay ninguna función '{ $name }'. Créala con un bloque 'definir' de 'Mis bloques', o quita este bloque.
workspace-no-such-skill = El robot no tiene ninguna habilidad '{ $name }'. Quita este bloque y toma otro de la paleta.
workspace-unknown-when = No hay ningún evento '{ $name }'. Créalo con 'Nuevo evento…' en 'Eventos', o elige otro en este bloque.
workspace-unknown-when-near = No hay ningún evento '{ $name }'. ¿Querías decir '{ $near }'? Elígelo en este bloque.
workspace-never-started = Nada inicia el evento '{ $name }', así que no se ejecuta nunca. Pon en el programa un bloque 'iniciar { $name }' de 'Eventos', o añade una condición a este bloque con su '+'.
workspace-events-never-run = Este bucle no termina nunca, así que los eventos como '{ $name }' no se ejecutan. Pasa lo que repite el bucle a un evento con 'verdadero' como condición, o pon en el bucle un 'si' con 'salir del bucle'.
workspace-events-held-up = Cuando este bucle empieza, ya no termina nunca, así que los eventos como '{ $name }' dejan de ejecutarse. Pon dentro del bucle un 'si' con 'salir del bucle'.
workspace-events-held-up-by-event = Cuando este bucle empieza, ya no termina nunca, así que otros eventos como '{ $name }' dejan de ejecutarse. Saca sus bloques del bucle: los bloques de un evento se repiten de todos modos mientras está activo.
# $word: def or when
workspace-defined-twice = { $word ->
    [def] Hay dos funciones '{ $name }'.
   *[other] Hay dos eventos '{ $name }'.
} Cambia el nombre de este bloque, o pasa sus bloques al otro y borra este.
workspace-follows-condition = El evento '{ $name }' sigue a su condición, así que este bloque dura como mucho una vuelta. Pon en la condición lo que deba iniciarlo o pararlo.
workspace-value-of-event = '{ $name }' es el { $value ->
    [time] tiempo
   *[active] estado
} del evento '{ $event }', así que nada más puede llamarse así. Elige otro nombre en este bloque.
workspace-not-imported = Este bloque es de la biblioteca '{ $library }'. Pon un bloque 'importar { $library }' de 'Control' bajo 'al empezar'.
# $names: of the parameters without a value
workspace-missing-argument = A este bloque le falta un valor para: { $names }. Quítalo y toma '{ $call }' otra vez de la paleta: ese tiene todos sus huecos.
workspace-too-many-arguments = { $most ->
    [0] '{ $call }' no lleva valores.
    [one] '{ $call }' lleva solo 1 valor ({ $parameters }).
   *[other] '{ $call }' lleva solo { $most } valores ({ $parameters }).
} Quita el bloque entero y toma '{ $call }' otra vez de la paleta: tiene los huecos justos.
workspace-text-for-number = Esto es un texto, pero hace falta un número. Pon aquí un número de 'Cálculo'.
workspace-number-as-text = "{ $number }" es un texto aquí, pero hace falta un número. Cambia este bloque por un número de 'Cálculo' y escribe en él { $number }.
workspace-outside-range = Este valor es { $value }. Elige uno entre { $least } y { $most }.
workspace-negative-wait = El robot no puede esperar { $seconds } segundos. Escribe 0 o más.
# $choices: as in a program
workspace-no-such-choice = { $value } no se puede elegir aquí. Las opciones son: { $choices }.
workspace-not-a-colour = { $value } no es un color. Elige uno en este bloque.
workspace-whole-number = 'contar con' cuenta con números enteros, no con { $number }. Escribe un número entero.
workspace-step-zero = Con 'de a 0' el bucle no terminaría nunca. Escribe otro número después de 'de a'.
workspace-counts-up = Este bucle no se ejecuta nunca, porque cuenta hacia delante de { $start } a { $stop }. Escribe -1 después de 'de a' para contar hacia atrás.
workspace-never-repeats = Si se repite { $count } veces, los bloques de dentro no se ejecutan nunca. Escribe un número mayor que 0.
workspace-idle-wait = Nada cambia esta condición mientras el programa espera aquí, así que espera para siempre o nada. Usa en ella una pregunta al robot.
workspace-unchanged-in-wait = Solo otros bloques podrían cambiar '{ $name }', y ninguno se ejecuta mientras el programa espera aquí. Así que espera para siempre o nada. Usa una pregunta al robot.
workspace-unchanged-in-loop = Nada en este bucle cambia '{ $name }' y ningún otro bloque se ejecuta mientras tanto, así que una vez que empieza no termina nunca. Cambia '{ $name }' dentro, o pon 'salir del bucle' donde deba terminar.
workspace-told-stays = Esta pregunta solo repite lo último que se le mandó al robot, y aquí nada le manda otra cosa. Así que el programa se queda aquí para siempre o nada. Usa una pregunta a un sensor.
workspace-state-in-wait = Los eventos no se ejecutan mientras el programa espera aquí, así que '{ $event }' no puede empezar ni parar: espera para siempre o nada. Pasa los bloques de abajo a 'cuando { $event }', o usa una pregunta al robot.
workspace-state-in-loop = Los eventos no se ejecutan durante este bucle, así que '{ $event }' no puede empezar ni parar y, una vez que empieza, el bucle no termina nunca. Pasa sus bloques a 'cuando { $event }', o usa una pregunta al robot.
workspace-time-stays = El tiempo de '{ $event }' sigue en 0 aquí, porque nada lo ha activado antes. Pon 'activar { $event }' encima, o espera unos segundos.
workspace-growing-list = Este bucle añade a '{ $name }' mientras lo recorre, así que no termina nunca. Recorre una copia de la lista.
workspace-idle-loop = Dentro de este bucle no hay nada, así que no termina nunca. Pon dentro los bloques que debe repetir, o quítalo.
workspace-speed-as-angle = Esto es una velocidad: el robot seguiría girando a { $speed }°/s. { $side ->
    [left] Para girar { $speed } grados a la izquierda, elige 'izquierda' en el bloque 'girar ...° a la ...'.
   *[other] Para girar { $speed } grados, usa el bloque 'girar ...° a la ...'.
}
workspace-convert-to-number = Esto es un texto, pero hace falta un número. Ponle alrededor el bloque 'int' de 'Cálculo', que lo convierte en un número.
workspace-answer-for-number = Lo que se escribe con el teclado es siempre un texto, aunque sea 5, pero aquí hace falta un número. Pon alrededor de esto el bloque 'int' de 'Cálculo'.
workspace-answer-changed = '{ $name }' contiene lo que se ha escrito con el teclado, que siempre es un texto, aunque sea 5. Usa 'establecer { $name } a' con 'int', de 'Cálculo', alrededor de lo que se escribe.
workspace-dictionary-for-number = Esto es un diccionario, y hace falta un número. Pon alrededor el bloque 'en el diccionario obtener' de 'Variables'.
workspace-list-for-number = Esto es una lista, pero hace falta un número. Usa 'en la lista ... obtener #' para uno de sus elementos, o 'longitud de' para saber cuántos tiene.
workspace-join-text = A un texto solo se le puede sumar otro texto. Pon alrededor de esto el bloque 'str' de 'Cálculo', que lo convierte en un texto.
workspace-append = A una lista solo se le puede sumar otra lista. Para añadir un elemento, cambia todo el bloque 'establecer ... a' por 'en la lista ... insertar en último', de 'Variables'.
# $advice: one of the messages about text for a number
workspace-rounded = Los ordenadores redondean los decimales: 0.1 + 0.2 es 0.30000000000000004. Por eso estos dos pueden diferenciarse en muy poco. Redondea lo que se calcula, o compara con '≥' o '≤'.
workspace-never-equal = Un texto nunca es igual a un número. { $advice }
workspace-decimals = Aquí hace falta un número entero, y este tiene decimales, como 5.0. Ponlo dentro de un bloque 'redondear'.
workspace-repeat-whole-number = 'repetir' necesita un número entero, no { $number }. Escribe { $less } o { $more }.
workspace-for-dictionary = Un diccionario solo da sus claves. Pon a su alrededor el bloque 'entradas de' para las claves con sus valores.
workspace-for-number = Esto es un número, no una lista. Para contar usa 'contar con { $name } desde 1 hasta { $value }' en vez de 'para cada elemento'.
workspace-text-as-condition = Un texto no es una condición: cuenta como verdadero. Pon aquí una comparación de 'Cálculo' o una pregunta al robot.
workspace-number-as-condition = El número { $number } no es una condición. Pon aquí una comparación de 'Cálculo' o una pregunta al robot.
workspace-action-as-condition = Este bloque hace algo y no responde nada. Pon aquí una comparación de 'Cálculo' o una pregunta al robot.
workspace-unused-answer = Este bloque da una respuesta, pero nada la usa. Ponla en una variable, una condición o 'escribir'.
workspace-no-result = Esta función no devuelve nada, así que no hay ningún valor que usar. Ponle un bloque 'devolver', o úsala en el programa sin este bloque alrededor.
workspace-bare-value = Cada lado de '{ $operator ->
    [and] y
    [or] o
   *[other] { $operator }
}' necesita su propia comparación. Cambia esto por '{ $variable } { $comparison } { $value }' de 'Cálculo'.
workspace-divide-by-zero = No se puede dividir entre 0. Escribe aquí otro número.
workspace-length-of-number = 'longitud de' necesita un texto o una lista, pero esto es un número. Encaja en su lugar un texto o una lista.
workspace-numbers-of-list = Esto es un texto, pero el bloque que lo rodea necesita una lista de números. Cámbialo por 'crear lista con', de 'Variables', y encaja números en ella.
workspace-past-end = { $length ->
    [one] No hay ningún elemento # { $index }. La lista tiene solo 1 elemento, el # 0: los elementos se cuentan desde 0.
   *[other] No hay ningún elemento # { $index }. La lista tiene { $length } elementos, que se cuentan desde 0: el último es el # { $last }.
}
workspace-loop-past-end = En la última vuelta no hay ningún elemento # { $index }: los elementos se cuentan desde 0. Cuenta desde 0 hasta 'longitud de { $values }' - 1.
workspace-empty-list-item = '{ $values }' está vacía, así que no tiene ningún elemento # { $index }. Antes de este bloque, pon elementos en ella con 'en la lista ... insertar en último', de 'Variables'.
workspace-calls-itself = '{ $name }' se llama aquí a sí misma una y otra vez, sin fin. Quita este bloque y pon 'repetir siempre' alrededor de los demás bloques de '{ $name }'.
# $owner: the function or event of this block
workspace-shared-in-recursion = '{ $name }' es compartida: '{ $owner }' se ejecuta otra vez a sí misma y la cambia, y después se usa. Para que cada llamada tenga la suya, usa 'establecer local { $name }' en lugar de este bloque.
workspace-shared-counter = '{ $name }' es compartida: un bucle que ejecuta '{ $owner }' también cuenta con ella. Para que '{ $owner }' tenga la suya, usa 'establecer local { $name }' en lugar de este bloque.
workspace-shared-by-events = '{ $name }' es compartida: el evento '{ $event }' también cuenta con ella. Para que '{ $owner }' tenga la suya, usa 'establecer local { $name }' en lugar de este bloque.
# $devices: noun phrases from check-device
workspace-skill-without-answer = Este robot no tiene { $devices }, así que no puede responder a esta pregunta. Quita el bloque o elige otro robot.
workspace-skill-impossible = Este robot no tiene { $devices }, así que no puede hacer esto. Quita el bloque o elige otro robot.
workspace-skill-without-effect = Este robot no tiene { $devices }, así que este bloque no hace nada. Quítalo o elige otro robot.
workspace-no-device-of-name = Este robot no tiene { $device } '{ $key }', así que este bloque no hace nada. Elige: { $known }.
workspace-outside-loop = Este bloque solo funciona dentro de un bucle. Ponlo dentro de un bloque 'repetir', 'contar con' o 'para cada elemento', o quítalo.
workspace-outside-function = Este bloque solo funciona dentro de una función o un evento. Ponlo dentro de un bloque 'definir' o 'cuando', o quítalo.
workspace-unreachable-after-jump = Este bloque no se ejecuta nunca: el de encima sale antes de { $word ->
    [return] la función
   *[other] esta vuelta del bucle
}. Ponlo encima de ese bloque, o quítalo.
workspace-unreachable-after-loop = Este bloque no se ejecuta nunca: el bucle de encima no termina. Ponlo dentro del bucle o encima de él, o termina el bucle con 'salir del bucle'.
workspace-unreachable-after-call = Aquí no se llega nunca, porque '{ $name }', más arriba, no termina. Ponlo encima de ese bloque, o pon 'salir del bucle' en el bucle de '{ $name }'.
workspace-unreachable-after-branches = Este bloque no se ejecuta nunca: todas las ramas del 'si' de encima salen antes. Ponlo encima del 'si', o quítalo.
workspace-sensor-outside-loop = Al robot se le pregunta solo una vez, cuando el programa llega aquí. Para seguir preguntando, pon este bloque dentro de 'repetir siempre', o usa un evento de 'Eventos'.
