# Errors and warnings in a program that can be parsed: names, arguments, devices, likely mistakes.

## Names

check-unknown-name = '{ $name }' no tiene valor. Dale uno antes: '{ $name } = ...'. Si es un texto, escríbelo entre comillas.
check-unknown-name-near = '{ $name }' no tiene valor. ¿Querías decir '{ $near }'?
check-read-before-set = '{ $name }' se usa aquí antes de tener valor. Escribe '{ $name } = ...' más arriba.
check-defined-below = '{ $name }' se usa aquí, pero no se define hasta la línea { $line }. Pon su definición encima de esta línea.
check-when-as-variable = '{ $name }' es un 'when'. Escribe 'state_{ $name }' para saber si está activo.
check-function-as-variable = '{ $name }' es una función. Escribe '{ $name }(...)' para llamarla.
check-skill-as-name = '{ $name }' es una habilidad del robot. Escribe '{ $skill }(...)' para usarla.
check-unknown-function = No hay ninguna función '{ $name }'. Defínela con 'def { $name }(...)', o revisa el nombre.
check-unknown-function-near = No hay ninguna función '{ $name }'. ¿Querías decir '{ $near }'?
check-without-robot = Este programa no tiene robot. Borra la línea 'without robot'.
check-robot-not-first = 'robot(...)' va antes que todo lo demás. Muévelo al principio.
check-unknown-skill = No hay ninguna habilidad '{ $name }'. En la paleta están todas.
check-unknown-skill-near = No hay ninguna habilidad '{ $name }'. ¿Querías decir '{ $near }'?
# $advice: one of the two messages below
check-unknown-skill-meant = No hay ninguna habilidad '{ $name }'. { $advice }
check-unknown-function-meant = No hay ninguna función '{ $name }'. { $advice }
check-write = Escribe '{ $instead }'.
check-keeps-driving = Con '{ $instead }' el robot avanza a 40 mm/s hasta la siguiente orden. Para que pare a los 2 segundos, escribe debajo '{ $sleep }' y '{ $stop }'.
check-range = En Block-Text no hay 'range'. Escribe 'repeat { $count }:', o 'for i from { $first } to { $last }:' para contar.
check-function-as-skill = '{ $name }' es una función tuya. Llámala sin 'function.'.
# $reason: file, line and message
check-skill-with-error = La habilidad '{ $name }' no se puede usar porque hay un error en su archivo. { $reason }
check-unknown-when = No hay ningún 'when { $name }'. Escribe uno, o revisa el nombre.
# $name: of an event that has no condition
check-never-started = Nada inicia 'when { $name }', así que no se ejecuta nunca. Escribe 'activate { $name }' donde deba empezar, o dale una condición: 'when { $name } = ...:'.
check-never-started-python = Nada inicia el evento '{ $name }', así que no se ejecuta nunca. Escribe '{ $name }.activate()' donde deba empezar, o dale una condición: '@robot.when(lambda: ...)'.
check-events-never-run = Este bucle no termina nunca, así que los eventos como '{ $name }' no se ejecutan. Pasa lo que repite el bucle a un evento que se ejecute siempre, como 'when drive = True:', o termina el bucle con 'if ...:' y 'break' dentro.
check-events-never-run-python = Este bucle no termina nunca, así que los eventos como '{ $name }' no se ejecutan. Pasa lo que repite el bucle a una función debajo de '@robot.when(lambda: True)', o termina el bucle con 'if ...:' y 'break' dentro.
check-events-held-up = Cuando este bucle empieza, ya no termina nunca, así que los eventos como '{ $name }' dejan de ejecutarse. Termina el bucle con 'if ...:' y 'break' dentro.
check-events-held-up-by-event = Cuando este bucle empieza, ya no termina nunca, así que otros eventos como '{ $name }' dejan de ejecutarse. Quita 'forever:' y su 'end': las líneas de un evento se repiten de todos modos mientras está activo.
check-events-held-up-by-event-python = Cuando este bucle empieza, ya no termina nunca, así que otros eventos como '{ $name }' dejan de ejecutarse. Quita 'while True:': las líneas de un evento se repiten de todos modos mientras está activo.
check-unknown-when-near = No hay ningún 'when { $name }'. ¿Querías decir '{ $near }'?
# $word: def or when
check-defined-twice = Ya hay otro '{ $word } { $name }' en la línea { $line }. Cambia el nombre de uno o únelos.
check-function-and-variable = '{ $name }' es a la vez una función y una variable. Cambia uno de los nombres.
check-follows-condition = 'when { $name }' sigue a su condición, así que '{ $word } { $name }' dura como mucho una vuelta. Pon en la condición lo que deba iniciarlo o pararlo.
check-follows-condition-python = El evento '{ $name }' sigue a su condición, así que '{ $name }.{ $word }()' dura como mucho una vuelta. Pon en la condición lo que deba iniciarlo o pararlo.
check-value-of-event = '{ $name }' es de 'when { $event }', así que nada más puede llamarse así. { $value ->
    [time] Elige otro nombre, o escribe 'deactivate { $event }' y 'activate { $event }' para que su tiempo empiece otra vez.
   *[active] Elige otro nombre, o escribe 'activate { $event }' o 'deactivate { $event }' para cambiar su estado.
}
check-value-of-event-python = '{ $event }.{ $value }' es del evento y no se puede cambiar así. { $value ->
    [time] Escribe '{ $event }.deactivate()' y '{ $event }.activate()' para que su tiempo empiece otra vez.
   *[active] Escribe '{ $event }.activate()' o '{ $event }.deactivate()' para cambiarlo.
}

## Libraries

check-unknown-library = No hay ninguna biblioteca '{ $name }', solo: { $known }. Importa su archivo con 'learnblock library import', o pon { $name }.py junto al programa.
check-unknown-library-near = No hay ninguna biblioteca '{ $name }'. ¿Querías decir '{ $near }'?
check-no-libraries = No hay ninguna biblioteca '{ $name }'. Importa su archivo con 'learnblock library import', o pon { $name }.py junto al programa.
check-not-imported = La habilidad '{ $skill }' es de la biblioteca '{ $library }'. Escribe 'import "{ $library }"' al principio del programa.

## Arguments. $call: such as function.turn

check-no-arguments = '{ $call }' no lleva argumentos. Deja sus paréntesis vacíos.
# $parameters: their names
check-too-many-arguments = { $most ->
    [0] '{ $call }' no lleva argumentos. Deja sus paréntesis vacíos.
    [one] '{ $call }' lleva solo 1 argumento ({ $parameters }), no { $given }. Escribe '{ $instead }'.
   *[other] '{ $call }' lleva solo { $most } argumentos ({ $parameters }), no { $given }. Escribe '{ $instead }'.
}
check-argument-count = { $count ->
    [0] '{ $call }' no lleva argumentos. Deja sus paréntesis vacíos.
    [one] '{ $call }' lleva 1 argumento, no { $given }.
   *[other] '{ $call }' lleva { $count } argumentos, no { $given }.
}
check-argument-range = '{ $call }' lleva de { $least } a { $most } argumentos, no { $given }.
check-too-few-arguments = { $least ->
    [one] '{ $call }' lleva al menos 1 argumento, no { $given }.
   *[other] '{ $call }' lleva al menos { $least } argumentos, no { $given }.
}
# $names: of the missing arguments
check-missing-argument = { $count ->
    [one] A '{ $call }' le falta un valor para '{ $names }'.
   *[other] A '{ $call }' le faltan valores para: { $names }.
}
check-unknown-argument = '{ $call }' no tiene ningún argumento '{ $name }', solo: { $known }.
check-unknown-argument-near = '{ $call }' no tiene ningún argumento '{ $name }'. ¿Querías decir '{ $near }'?
check-no-named-arguments = '{ $call }' no tiene ningún argumento llamado '{ $name }'. Escribe solo los valores, sin nombres.
check-number-expected = '{ $parameter }' de '{ $call }' tiene que ser un número, no un texto.
check-number-in-quotes = '{ $parameter }' de '{ $call }' tiene que ser un número, no un texto. Escribe { $number } sin comillas.
check-negative-wait = El robot no puede esperar { $seconds } segundos. Escribe 0 o más.
# $value, $choices: as written in the program
check-outside-range = '{ $parameter }' de '{ $call }' es { $value } aquí. Debería estar entre { $least } y { $most }.
check-unknown-choice = '{ $parameter }' de '{ $call }' es { $value } aquí. Las opciones son: { $choices }.
check-unknown-choice-near = '{ $parameter }' de '{ $call }' es { $value } aquí. ¿Querías decir { $near }?
check-not-a-colour = '{ $parameter }' de '{ $call }' es { $value } aquí. Escribe un color como "#ff8800".
check-whole-number = 'for ... from ... to' cuenta con números enteros, no con { $number }.
check-text-for-number = Esto es un texto, pero tiene que ser un número.
check-counts-up = Este bucle no se ejecuta nunca, porque cuenta hacia delante de { $start } a { $stop }. Para contar hacia atrás escribe 'for { $name } from { $start } to { $stop } step -1:'.
check-counts-up-python = Este bucle no se ejecuta nunca, porque cuenta hacia delante y { $stop } no es mayor que { $start }. Para contar hacia atrás escribe 'range({ $start }, { $stop }, -1)': se detiene antes de llegar a { $stop }.
check-never-repeats = Con 'repeat { $count }' las líneas de dentro no se ejecutan nunca. Escribe un número mayor que 0.
check-never-repeats-python = Con 'range({ $count })' las líneas de dentro no se ejecutan nunca. Escribe un número mayor que 0.
check-wait-until = Esperar a una condición no es una habilidad. Escribe 'wait until' y la condición, por ejemplo 'wait until function.is_front_obstacle()'.
check-idle-wait = Nada cambia esto mientras el programa espera aquí, así que espera para siempre o nada. Pregunta en ello al robot, por ejemplo '{ $skill }'.
check-unchanged-in-wait = Solo otras líneas podrían cambiar '{ $name }', y ninguna se ejecuta mientras el programa espera aquí. Así que espera para siempre o nada. Pregunta en ello al robot, por ejemplo '{ $skill }'.
check-unchanged-in-loop = Nada en este bucle cambia '{ $name }' y ninguna otra línea se ejecuta mientras tanto, así que una vez que empieza no termina nunca. Cambia '{ $name }' dentro, o escribe 'break' donde deba terminar.
check-told-stays = '{ $name }' solo repite lo último que se le mandó al robot, y aquí nada le manda otra cosa. Así que el programa se queda aquí para siempre o nada. Pregunta a un sensor, por ejemplo '{ $skill }'.
# $name: such as state_go
check-state-in-wait = Los eventos no se ejecutan mientras el programa espera aquí, así que '{ $name }' no puede cambiar: espera para siempre o nada. Pasa las líneas de abajo a 'when { $event }', o pregunta al robot, por ejemplo '{ $skill }'.
check-state-in-wait-python = Los eventos no se ejecutan mientras el programa espera aquí, así que '{ $name }' no puede cambiar: espera para siempre o nada. Pasa las líneas de abajo al evento '{ $event }', o pregunta al robot, por ejemplo '{ $skill }'.
check-state-in-loop = Los eventos no se ejecutan durante este bucle, así que '{ $name }' no puede cambiar y, una vez que empieza, no termina nunca. Pasa sus líneas a 'when { $event }', o pregunta al robot, por ejemplo '{ $skill }'.
check-state-in-loop-python = Los eventos no se ejecutan durante este bucle, así que '{ $name }' no puede cambiar y, una vez que empieza, no termina nunca. Pasa sus líneas al evento '{ $event }', o pregunta al robot, por ejemplo '{ $skill }'.
# $name: such as time_go
check-time-stays = '{ $name }' sigue en 0 aquí, porque nada ha activado antes 'when { $event }'. Escribe 'activate { $event }' encima, o espera con '{ $sleep }'.
check-time-stays-python = '{ $name }' sigue en 0 aquí, porque nada ha activado antes el evento '{ $event }'. Escribe '{ $event }.activate()' encima, o espera con '{ $sleep }'.
check-growing-list = Este bucle añade a '{ $name }' mientras lo recorre, así que no termina nunca. Recorre una copia: 'for { $target } in copy({ $name }):'.
check-growing-list-python = Este bucle añade a '{ $name }' mientras lo recorre, así que no termina nunca. Recorre una copia: 'for { $target } in { $name }.copy():'.
check-idle-loop = Este bucle no hace nada, así que no termina nunca. Escribe dentro las líneas que debe repetir, o quítalo.
check-step-zero = Con 'step 0' el bucle no terminaría nunca. Escribe otro paso.

check-speed-as-angle = '{ $call }' espera una velocidad: el robot seguiría girando a { $speed }°/s. Escribe '{ $turn }' para girar { $speed } grados a la { $side ->
    [left] izquierda
   *[other] derecha
}.

## Types. $value, $values and $item: a part of the program

check-convert-to-number = '{ $value }' es un texto aquí, pero hace falta un número. Escribe 'int({ $value })'.
check-answer-for-number = Lo que se escribe con el teclado es siempre un texto, aunque sea un número como 5. Escribe 'int({ $value })' para convertirlo en un número.
check-answer-changed = '{ $name }' contiene lo que se ha escrito con el teclado, que siempre es un texto, aunque sea 5. Escribe '{ $instead }'.
check-words-for-number = '{ $name }' contiene un texto, como "{ $text }", pero hace falta un número. Usa una variable que contenga un número.
check-number-without-quotes = Aquí hace falta un número, no un texto. Escribe { $number } sin comillas.
check-dictionary-for-number = '{ $value }' es aquí un diccionario, y hace falta un número. Escribe detrás una clave entre corchetes, por ejemplo '["Ana"]'.
check-list-for-number = '{ $values }' es una lista aquí, pero hace falta un número. Escribe '{ $values }[0]' para su primer elemento, o 'len({ $values })' para saber cuántos tiene.
check-join-text = A un texto solo se le puede sumar otro texto. Escribe 'str({ $value })'.
check-append = A una lista solo se le puede sumar otra lista. Escribe 'append({ $values }, { $item })' para añadir un elemento.
check-append-python = A una lista solo se le puede sumar otra lista. Escribe '{ $values }.append({ $item })' para añadir un elemento.
# $advice: one of the messages above
# $name: a variable; $value: what it is compared with
check-rounded = '{ $name }' se calcula con decimales, y los ordenadores los redondean: 0.1 + 0.2 es 0.30000000000000004. Por eso puede no llegar a { $value } por muy poco. Escribe aquí 'round({ $name }, 3)' en lugar de '{ $name }'.
check-rounded-sum = Los ordenadores redondean los decimales: 0.1 + 0.2 es 0.30000000000000004. Por eso estos dos pueden diferenciarse en muy poco. Escribe 'round(..., 3)' alrededor de lo que se calcula.
check-never-equal = Un texto nunca es igual a un número. { $advice }
check-decimals = Aquí hace falta un número entero, y Python le da decimales, como en 5.0. Escribe '//' en vez de '/', o ponlo dentro de 'int(...)'.
check-random-decimals = 'random' espera números enteros y responde con uno, no { $number }. Para un número con decimales escribe 'random_fraction() * 10'.
check-random-order = 'random' necesita primero el número menor. Escribe 'random({ $high }, { $low })'.
check-repeat-whole-number = 'repeat' necesita un número entero, no { $number }. Escribe 'repeat { $less }:' o 'repeat { $more }:'.
check-for-dictionary = Un diccionario solo da sus claves. Escribe 'for { $names } in items({ $value }):' para las claves con sus valores.
check-for-dictionary-python = Un diccionario solo da sus claves. Escribe 'for { $names } in { $value }.items():' para las claves con sus valores.
check-for-number = '{ $value }' es un número, no una lista. Escribe 'for { $name } from 1 to { $value }:' para contar.
check-for-number-python = '{ $value }' es un número, no una lista. Escribe 'for { $name } in range({ $value }):' para contar.
check-text-as-condition = Un texto entre comillas siempre es verdadero. Quita las comillas si es una condición.
check-number-as-condition = { $number } no es una condición. Escribe una comparación, como 'x == { $number }'.
check-action-as-condition = '{ $call }' hace algo y no responde nada, así que esto nunca se cumple. Usa una pregunta, como las que empiezan por 'is_'.
check-unused-answer = '{ $call }' da una respuesta, pero nada la usa. Guárdala con 'respuesta = { $spelled }', pregúntala en una condición como 'if', o muéstrala con 'print({ $spelled })'.
check-no-result = '{ $call }' hace algo y no devuelve nada. Escríbelo en su propia línea, sin '='.
check-bare-value = Cada lado de '{ $operator }' necesita su propia comparación. Escribe '{ $operator } { $variable } { $comparison } { $value }'.
check-divide-by-zero = No se puede dividir entre 0. Escribe otro número después de '{ $operator }'.
check-swapped-operator = '{ $found }' le da a '{ $name }' el número que sigue. Escribe '{ $instead }' para cambiar '{ $name }' en ese número.
check-no-items = '{ $value }' es un número, así que no tiene elementos. Usa una lista o un texto antes de '['.
check-past-end = { $length ->
    [one] '{ $values }' no tiene ningún elemento { $index }. Tiene solo 1 elemento, y los elementos se cuentan desde 0: escribe '{ $values }[0]'.
   *[other] '{ $values }' no tiene ningún elemento { $index }. Tiene { $length } elementos, contados desde 0: escribe '{ $values }[{ $last }]' para el último.
}
check-loop-past-end = En la última vuelta no hay ningún elemento { $index }, porque los elementos se cuentan desde 0. Cambia la línea { $line } por 'for { $index } from 0 to len({ $values }) - 1:'.
check-loop-past-end-python = En la última vuelta no hay ningún elemento { $index }, porque los elementos se cuentan desde 0. Cambia la línea { $line } por 'for { $index } in range(len({ $values })):'.
check-empty-list-item = '{ $values }' está vacía aquí, así que no tiene ningún elemento { $index }. Pon antes elementos en ella, por ejemplo con 'append({ $values }, 5)'.
check-empty-list-item-python = '{ $values }' está vacía aquí, así que no tiene ningún elemento { $index }. Pon antes elementos en ella, por ejemplo con '{ $values }.append(5)'.
check-variable-called = '{ $name }' es un número, no una función. Escribe '{ $name } * ({ $value })' para multiplicar.
check-list-called = '{ $name }' no es una función. Escribe '{ $name }[{ $value }]' para uno de sus elementos.
check-not-whole = "{ $text }" no es un número entero, y 'int' no puede leerlo. Escribe solo cifras, como "4".
check-argument-type = { $wanted ->
    [dictionary] '{ $call }' necesita primero un diccionario, y '{ $value }' no es un diccionario.
    [list] '{ $call }' necesita primero una lista, y '{ $value }' no es una lista.
   *[text] '{ $call }' necesita primero un texto, y '{ $value }' no es un texto.
}
check-length-of-number = 'len' necesita un texto o una lista, pero { $value } es un número. Escribe 'len(str({ $value }))' para contar sus cifras, o pon una lista entre los paréntesis.
check-no-length = 'len' necesita un texto o una lista, y '{ $value }' no es ninguno de los dos. Pon uno de ellos entre los paréntesis.
check-list-first = La lista va primero. Escribe '{ $call }({ $values }, { $item })'.
check-numbers-of-list = '{ $call }' calcula con los números de una lista, pero { $value } es un texto. Escribe '{ $call }([1, 2, 3])'.

## Devices

# $devices: noun phrases from check-device
check-skill-without-answer = Este robot no tiene { $devices }: no puede responder a '{ $skill }'.
check-skill-impossible = Este robot no tiene { $devices }: no puede hacer '{ $skill }'.
check-skill-without-effect = Este robot no tiene { $devices }: '{ $skill }' no hace nada.
check-skill-partly = Este robot no tiene { $devices }: esa parte de '{ $skill }' no hace nada.
check-too-fast = Este robot no puede ir a más de { $most } mm/s, así que da igual poner { $speed } mm/s.
check-turns-too-fast = Este robot no puede girar a más de { $most }°/s, así que da igual poner { $speed }°/s.
check-curve-too-fast = Este robot no puede ir a { $adv } mm/s y girar a { $rot }°/s a la vez: hace la misma curva a { $most } mm/s y { $turned }°/s.
check-no-device-of-name = Este robot no tiene { $device } '{ $key }': '{ $skill }' no hace nada. Usa uno de estos: { $known }.
# $kind: the type of the device. $key: the name of one of several such devices, or empty
check-device = { $kind ->
    [Accelerometer] acelerómetro
    [Animator] animaciones
    [Base] ruedas
    [Bumper] parachoques
    [Camera] { $key ->
        [emotions] cámara que pueda reconocer emociones (mira: learnblock perception)
       *[other] cámara
    }
    [Controller] mando
    [Display] cara
    [DistanceSensors] sensores de distancia
    [GroundSensors] sensores de suelo
    [black-line] cámara o sensores de suelo
    [blue-line] cámara
    [brightness] sensor de luz o cámara
    [ground-line] sensores de suelo o cámara
    [heading] giroscopio o ruedas
    [obstacle-back] sensor de distancia detrás
    [obstacle-front] sensor de distancia o parachoques delante
    [obstacle-left] sensor de distancia a la izquierda
    [obstacle-right] sensor de distancia a la derecha
    [red-line] cámara
    [shaking] acelerómetro
    [tilting] acelerómetro
    [text-display] matriz de LED o pantalla
    [Gyroscope] giroscopio
    [Infrared] receptor de infrarrojos
    [JointMotor] { $key ->
        [CAMERA] motor de la cámara
       *[other] motor
    }
    [Led] LED
    [LightSensor] sensor de luz
    [MP3] reproductor de música
    [Matrix] matriz de LED
    [Pen] { $key ->
        [full] sitio para más líneas: su dibujo ya tiene 20 000 puntos
       *[other] lápiz (los robots simulados sí)
    }
    [Screen] pantalla
    [RGBLed] LED de colores
    [Speaker] { $key ->
        [play] sonidos grabados
        [say] voz
       *[other] altavoz
    }
   *[other] { $kind } { $key }
}
# $device: one that only robots of users and plugins can have
check-serving = En este robot: { $devices }
check-serving-device = { $kind ->
    [Accelerometer] el acelerómetro
    [Base] las ruedas
    [Bumper] el parachoques
    [Camera] la cámara
    [DistanceSensors] { $key ->
        [front] los sensores de distancia de delante
        [left] los sensores de distancia de la izquierda
        [right] los sensores de distancia de la derecha
        [back] los sensores de distancia de detrás
       *[other] los sensores de distancia
    }
    [GroundSensors] los sensores de debajo
    [Gyroscope] el giroscopio
    [LightSensor] el sensor de luz
    [Matrix] la matriz de LED
    [Screen] la pantalla
   *[other] { $kind } { $key }
}
check-device-of-none = { $device } (ningún robot de LearnBlock tiene, pero uno tuyo puede tener)

## Which robots can run a program. $devices: noun phrases from check-device

check-robot-runs-with = funciona, con { $devices }
check-robot-runs = funciona
check-robot-without = funciona, pero sin { $devices }
check-robot-refused = no funciona: no tiene { $devices }
check-robot-unknown = depende de sus ajustes

## Structure

check-too-many-blocks = Aquí hay más de { $limit } bloques unos dentro de otros, y son demasiados para Python. Mueve algunos a una función.
check-too-many-loops = Aquí hay más de { $limit } bucles unos dentro de otros, y son demasiados para Python. Mueve algunos a una función.
# $word: break or continue
check-outside-loop = '{ $word }' solo funciona dentro de un bucle. Ponlo dentro de uno, o quítalo.
check-outside-function = 'return' solo funciona dentro de un 'def' o un 'when'. Ponlo dentro de uno, o quítalo.
check-calls-itself = '{ $name }' se llama aquí a sí misma una y otra vez, sin fin. Quita esta línea. Escribe 'forever:' encima de las demás líneas de '{ $name }' y 'end' debajo.
check-calls-itself-python = '{ $name }' se llama aquí a sí misma una y otra vez, sin fin. Quita esta línea. Escribe 'while True:' encima de las demás líneas de '{ $name }' y ponles 4 espacios más delante.
# $owner: the function or event that sets the variable here
check-shared-in-recursion = '{ $name }' es compartida: la llamada de la línea { $line } ejecuta otra vez '{ $owner }', que la cambia, y después se usa. Para que cada llamada tenga la suya, escribe aquí 'local { $name } = ...'.
check-shared-in-recursion-python = '{ $name }' es global: la llamada de la línea { $line } ejecuta otra vez '{ $owner }', que la cambia, y después se usa. Para que cada llamada tenga la suya, quita '{ $name }' de la línea 'global'.
check-shared-counter = '{ $name }' es compartida: el bucle que llama a '{ $owner }' en la línea { $line } también cuenta con ella. Para que '{ $owner }' tenga la suya, escribe aquí 'local { $name } = ...'.
check-shared-counter-python = '{ $name }' es global: el bucle que llama a '{ $owner }' en la línea { $line } también cuenta con ella. Para que '{ $owner }' tenga la suya, quita '{ $name }' de la línea 'global'.
check-shared-by-events = '{ $name }' es compartida: 'when { $event }' también cuenta con ella. Para que '{ $owner }' tenga la suya, escribe aquí 'local { $name } = ...'.
check-shared-by-events-python = '{ $name }' es global: el evento '{ $event }' también cuenta con ella. Para que '{ $owner }' tenga la suya, quita '{ $name }' de la línea 'global'.
# $word: break, continue or return
check-unreachable-after-jump = Aquí no se llega nunca, por el '{ $word }' de la línea { $line }. Escríbelo encima de esa línea, o quítalo.
check-unreachable-after-loop = Aquí no se llega nunca, porque el bucle de la línea { $line } no termina. Escríbelo dentro del bucle o encima, o sal del bucle con 'break'.
check-unreachable-after-call = Aquí no se llega nunca, porque '{ $name }', que se llama en la línea { $line }, no termina. Escríbelo encima de esa línea, o sal del bucle de '{ $name }' con 'break'.
check-unreachable-after-branches = Aquí no se llega nunca, porque ninguna rama del 'if' de la línea { $line } sigue hasta aquí. Escríbelo encima del 'if', o quítalo.
check-sensor-outside-loop = '{ $skill }' se mira una sola vez, cuando el programa llega aquí. Pon el 'if' dentro de 'forever:' para seguir mirando, o usa un 'when'.
check-sensor-outside-loop-python = '{ $skill }' se mira una sola vez, cuando el programa llega aquí. Pon el 'if' dentro de 'while True:' para seguir mirando, o escribe lo que hace como una función debajo de '@robot.when(lambda: { $skill }())'.

## A program that can't run. $problem: a message from above, or from another file

check-program-error = El programa tiene un error. { $problem }
check-program-error-in-line = El programa tiene un error en la línea { $line }. { $problem }
