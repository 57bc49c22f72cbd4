# Thymio. $place es una dirección con un puerto, o un puerto serie.

thymio-not-plugged-in = No hay ningún Thymio conectado. Conecta su cable o su adaptador y enciéndelo, o elige su puerto en los ajustes del robot.
thymio-no-listener = Ningún programa para un Thymio responde en { $place }. Inicia allí asebaswitch o el playground de Aseba, o corrige la dirección y el puerto en los ajustes del robot.
thymio-no-suite = Thymio Suite no responde en { $place }. Inícialo, o elige otra conexión en los ajustes del robot.
thymio-not-found = No hay ningún Thymio en este ordenador. Enciéndelo y conecta su cable o su adaptador, o inicia Thymio Suite. En { $place }, donde estaría asebaswitch, tampoco responde nada.
thymio-port-closed = No se puede abrir el Thymio en { $place } ({ $reason }). ¿Está conectado y no lo usa otro programa, como Thymio Suite?
thymio-no-answer = Ningún Thymio responde en { $place }. ¿Está encendido y no lo usa otro programa?
thymio-not-ready = El Thymio en { $place } ha respondido, pero no estaba listo a tiempo. Apágalo y enciéndelo, y cierra los programas que lo usen.
thymio-other-robot = El robot en { $place } no es un Thymio, sino '{ $name }'. Cambia la conexión en los ajustes del robot.
thymio-too-old = El firmware del Thymio en { $place } es demasiado antiguo. Actualízalo con Thymio Suite.
thymio-suite-empty = Thymio Suite en { $place } no muestra ningún Thymio. ¿Está encendido y conectado el robot?
thymio-suite-busy = Thymio Suite en { $place } no tiene ningún Thymio libre. ¿Está encendido el robot y no lo usa otro programa?
thymio-suite-silent = Thymio Suite no responde en { $place }. Reinícialo y cierra los programas que usen el Thymio.
thymio-suite-refused = Thymio Suite en { $place } ha rechazado el programa (error { $code }). Cierra los programas que usen el Thymio.
thymio-silent = El Thymio en { $place } no responde desde hace { $seconds } segundos. ¿Está encendido y cerca, y no lo usa otro programa?
thymio-garbled = Los datos que llegan de { $place } no son de un Thymio. Cambia la conexión en los ajustes del robot.
thymio-taken = Otro programa usa ahora el Thymio en { $place }. Ciérralo y ejecuta el programa otra vez.
thymio-link-broke = Se ha perdido la conexión con el Thymio en { $place } ({ $reason }). ¿Está encendido y cerca, y no lo usa otro programa?
thymio-unknown-sound = Un Thymio no tiene ningún sonido '{ $name }'. Usa uno de estos, o el número de un archivo de su tarjeta de memoria: { $known }.
thymio-unknown-sound-like = Un Thymio no tiene ningún sonido '{ $name }'. ¿Querías decir '{ $suggestion }'?
