# LEGO SPIKE con Pybricks. $place es una dirección o el identificador de un robot.

spike-too-old = El firmware Pybricks del hub de { $place } es demasiado antiguo (protocolo { $version }). Actualízalo en https://code.pybricks.com.
spike-garbled = El dispositivo de { $place } no se comporta como un hub con Pybricks. Comprueba la dirección en los ajustes del robot.
spike-not-started = El programa de LearnBlock no ha arrancado en el hub de { $place }. Apaga y enciende el hub y prueba otra vez.
spike-agent-ended = El programa de LearnBlock en el hub de { $place } ha terminado: se ha pulsado el botón del hub, o no ha oído nada durante 1,5 segundos. Ejecuta el programa otra vez.
# $motor es left o right, $port una letra.
spike-no-motor = El hub no tiene motor { $motor ->
        [left] izquierdo
       *[other] derecho
    }. Conéctalo a cualquier puerto.
spike-no-motor-at = El hub no tiene motor { $motor ->
        [left] izquierdo
       *[other] derecho
    } en el puerto { $port }. Conéctalo o cambia el puerto en los ajustes del robot.
spike-motor-lost = El motor { $motor ->
        [left] izquierdo
       *[other] derecho
    } del hub ya no responde. ¿Está enchufado su cable?
spike-no-sensor = El hub no tiene { $sensor ->
        [distance] sensor de distancia
        [colour] sensor de color
       *[force] sensor de fuerza
    } en el puerto { $port }. Conéctalo o cambia el puerto en los ajustes del robot.
spike-sensor-lost = El { $sensor ->
        [distance] sensor de distancia
        [colour] sensor de color
       *[force] sensor de fuerza
    } del hub ya no responde. ¿Está enchufado su cable?
