# Errors and warnings in a program that can be parsed: names, arguments, devices, likely mistakes.

## Names

check-unknown-name = '{ $name }' no tiene valor. Dale uno antes: '{ $name } = ...'.
check-unknown-name-near = '{ $name }' no tiene valor. ¿Querías decir '{ $near }'?
check-read-before-set = '{ $name }' se usa aquí antes de tener valor. Escribe '{ $name } = ...' más arriba.
check-when-as-variable = '{ $name }' es un 'when'. Escribe 'state_{ $name }' para saber si está activo.
check-function-as-variable = '{ $name }' es una función. Escribe '{ $name }(...)' para llamarla.
check-skill-as-name = '{ $name }' es una habilidad del robot. Escribe 'function.{ $name }(...)' para usarla.
check-unknown-function = No hay ninguna función '{ $name }'. Defínela con 'def { $name }(...)', o revisa el nombre.
check-unknown-function-near = No hay ninguna función '{ $name }'. ¿Querías decir '{ $near }'?
check-robot-not-first = 'robot(...)' va antes que todo lo demás. Muévelo al principio.
check-unknown-skill = No hay ninguna habilidad '{ $name }'. En la paleta están todas.
check-unknown-skill-near = No hay ninguna habilidad '{ $name }'. ¿Querías decir '{ $near }'?
check-function-as-skill = '{ $name }' es una función tuya. Llámala sin 'function.'.
# $reason: file, line and message
check-skill-with-error = La habilidad '{ $name }' no se puede usar porque hay un error en su archivo. { $reason }
check-unknown-when = No hay ningún 'when { $name }'. Escribe uno, o revisa el nombre.
check-unknown-when-near = No hay ningún 'when { $name }'. ¿Querías decir '{ $near }'?
# $word: def or when
check-defined-twice = Ya hay otro '{ $word } { $name }' en la línea { $line }. Cambia el nombre de uno o únelos.
check-function-and-variable = '{ $name }' es a la vez una función y una variable. Cambia uno de los nombres.

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
    [one] '{ $call }' lleva 1 argumento ({ $parameters }), no { $given }.
   *[other] '{ $call }' lleva { $most } argumentos ({ $parameters }), no { $given }.
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
# $value, $choices: as written in the program
check-outside-range = '{ $parameter }' de '{ $call }' es { $value } aquí. Debería estar entre { $least } y { $most }.
check-unknown-choice = '{ $parameter }' de '{ $call }' es { $value } aquí. Las opciones son: { $choices }.
check-not-a-colour = '{ $parameter }' de '{ $call }' es { $value } aquí. Escribe un color como "#ff8800".
check-whole-number = 'for ... from ... to' cuenta con números enteros, no con { $number }.
check-text-for-number = Esto es un texto, pero tiene que ser un número.
check-step-zero = Con 'step 0' el bucle no terminaría nunca. Escribe otro paso.

## Devices

# $devices: noun phrases from check-device
check-skill-without-answer = Este robot no tiene { $devices }: no puede responder a 'function.{ $skill }'.
check-skill-without-base = Este robot no tiene { $devices }: no puede hacer 'function.{ $skill }'.
check-skill-without-effect = Este robot no tiene { $devices }: 'function.{ $skill }' no hace nada.
# $kind: the type of the device. $key: the name of one of several such devices, or empty
check-device = { $kind ->
    [Accelerometer] acelerómetro
    [Animator] animaciones
    [Base] ruedas
    [Bumper] parachoques
    [Camera] cámara
    [Controller] mando
    [Display] pantalla
    [DistanceSensors] sensores de distancia
    [GroundSensors] sensores de suelo
    [Gyroscope] giroscopio
    [Infrared] receptor de infrarrojos
    [JointMotor] { $key ->
        [CAMERA] motor de la cámara
       *[other] motor { $key }
    }
    [Led] LED
    [LightSensor] sensor de luz
    [MP3] reproductor de música
    [Matrix] matriz de LED
    [RGBLed] LED de colores
    [Speaker] altavoz
   *[other] { $kind } { $key }
}

## Structure

check-too-many-blocks = Aquí hay más de { $limit } bloques unos dentro de otros, y son demasiados para Python. Mueve algunos a una función.
check-too-many-loops = Aquí hay más de { $limit } bucles unos dentro de otros, y son demasiados para Python. Mueve algunos a una función.
# $word: break or continue
check-outside-loop = '{ $word }' solo funciona dentro de un bucle.
check-outside-function = 'return' solo funciona dentro de un 'def'.
# $word: break, continue or return
check-unreachable-after-jump = Aquí no se llega nunca, por el '{ $word }' de la línea { $line }.
check-unreachable-after-loop = Aquí no se llega nunca, porque el bucle 'while True' de la línea { $line } no termina.
check-unreachable-after-branches = Aquí no se llega nunca, porque ninguna rama del 'if' de la línea { $line } sigue hasta aquí.
check-sensor-outside-loop = 'function.{ $skill }' se mira una sola vez, cuando el programa llega aquí. Pon el 'if' dentro de 'while True:' para seguir mirando, o usa un 'when'.

## A program that can't run. $problem: a message from above, or from another file

check-program-error = El programa tiene un error. { $problem }
check-program-error-in-line = El programa tiene un error en la línea { $line }. { $problem }
