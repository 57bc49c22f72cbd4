# El EV3 de LEGO. $place es su dirección con un puerto, o un dispositivo de este ordenador.

ev3-not-found = No se encuentra el EV3 en { $address }. ¿Está encendido y este ordenador está en la misma red?
ev3-no-answer = Ningún EV3 responde en { $place }. ¿Está encendido y este ordenador está en la misma red?
ev3-not-agent = El programa que responde en { $place } no es el agente de LearnBlock. Ejecuta: learnblock robots setup ev3
ev3-not-rpyc = El programa que responde en { $place } no es un servidor rpyc. Elige otra 'connection' en los ajustes del robot.
ev3-rpyc-failed = El EV3 en { $place } no se puede manejar con rpyc ({ $reason }). Ejecuta 'learnblock robots setup ev3' para instalar en él el agente de LearnBlock.
ev3-not-firmware = El programa que responde en { $place } no es el firmware de LEGO. Elige otra 'connection' en los ajustes del robot.
ev3-firmware-silent = El firmware de LEGO no responde en { $place }. Solo atiende a un programa, así que cierra cualquier otro programa que use el EV3.
ev3-device-silent = { $place } no responde como un EV3. ¿Está encendido el EV3 y es este el dispositivo correcto?
ev3-no-device-files = Este ordenador solo puede usar el firmware de LEGO por wifi. Deja 'device' vacío en los ajustes del robot.
ev3-device-closed = No se puede abrir el dispositivo { $device } ({ $reason }). ¿Está conectado el EV3?
ev3-taken = Otro programa usa el EV3 en { $place }, o lo usaba hace un momento. Cierra el otro programa e inténtalo otra vez.
ev3-unknown-token = El EV3 en { $place } no conoce la clave de este ordenador. Ejecuta: learnblock robots setup ev3
ev3-no-speech = El EV3 en { $place } no puede hablar con el firmware de LEGO. Usa ev3dev para que hable.
ev3-no-motor = El EV3 en { $place } no tiene ningún motor en el puerto { $port }. Conéctalo o cambia el puerto en los ajustes del robot.
ev3-no-sensor = El EV3 en { $place } no tiene ningún { $sensor ->
        [ultrasonic] sensor de ultrasonidos
        [colour] sensor de color
        [gyroscope] giroscopio
        [touch] sensor de contacto
       *[other] sensor
    } en el puerto { $port }. Conéctalo o cambia el puerto en los ajustes del robot.
ev3-sensor-lost = El { $sensor ->
        [ultrasonic] sensor de ultrasonidos
        [colour] sensor de color
        [gyroscope] giroscopio
        [touch] sensor de contacto
       *[other] sensor
    } del EV3 ya no responde. ¿Está conectado su cable?
ev3-motor-lost = Un motor del EV3 en { $place } ya no responde. ¿Está conectado su cable?
ev3-command-refused = El EV3 en { $place } ha rechazado una orden. Apágalo, enciéndelo y ejecuta el programa otra vez.
ev3-timed-out = El EV3 en { $place } se ha parado porque no recibía nada del programa. Ejecuta el programa otra vez.
ev3-not-understood = El EV3 en { $place } no ha entendido una orden. Ejecuta: learnblock robots setup ev3
ev3-complaint = El EV3 en { $place } ha informado: { $reason }
ev3-closed = La conexión con el EV3 en { $place } está cerrada. Ejecuta el programa otra vez.
ev3-silent = El EV3 en { $place } ha dejado de responder. ¿Está encendido y cerca?
ev3-link-broke = Se ha perdido la conexión con el EV3 en { $place }. ¿Está encendido y cerca?
ev3-garbled = Los datos que llegan de { $place } no son de un EV3. Revisa la dirección y el puerto en los ajustes del robot.

# learnblock robots setup ev3: qué está haciendo y qué ha fallado.
ev3-setup-login = Entrando en { $address } como { $user }...
ev3-setup-copy = Copiando el agente de LearnBlock en el EV3...
ev3-setup-start = Poniendo en marcha el agente...
ev3-setup-done = El agente está en marcha y los programas para el robot 'ev3' ya pueden usarlo. Después de apagar y encender el EV3, elige { $file } en su explorador de archivos o repite esta orden.
ev3-setup-other-brick = El EV3 en { $place } no es el que se preparó antes. Si lo has cambiado o reinstalado, borra su línea en { $file }.
ev3-setup-no-login = El EV3 en { $place } no acepta la contraseña de '{ $user }'. Cámbiala con: learnblock robots set ev3 password
ev3-setup-broke = El EV3 en { $place } ha cortado la conexión ({ $reason }). Repite la orden.
ev3-setup-not-started = El agente no ha arrancado en el EV3: { $output }
