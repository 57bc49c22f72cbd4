# Bluetooth de bajo consumo. $robot es el identificador de un robot, $place una dirección o un identificador.

bluetooth-none = Este ordenador no tiene un Bluetooth que se pueda usar. Conecta un adaptador Bluetooth o usa otro ordenador.
bluetooth-off = El Bluetooth de este ordenador está apagado. Enciéndelo y prueba otra vez.
bluetooth-denied = LearnBlock no tiene permiso para usar el Bluetooth de este ordenador. Dale permiso en los ajustes de privacidad del sistema y prueba otra vez.
bluetooth-not-found = No se ha encontrado ningún robot '{ $robot }' por Bluetooth en { $seconds } segundos. ¿Está encendido, cerca y sin otro programa que lo use?
bluetooth-other-not-found = No se ha encontrado el robot '{ $address }' por Bluetooth en { $seconds } segundos. ¿Está encendido, cerca y sin otro programa que lo use? Con la dirección vacía en los ajustes del robot se usa el primer '{ $robot }'.
bluetooth-taken = Otro programa está usando el robot de { $place }. Cierra ese programa y prueba otra vez.
bluetooth-lost = El robot de { $place } ha cortado la conexión Bluetooth. ¿Está encendido y cerca?
