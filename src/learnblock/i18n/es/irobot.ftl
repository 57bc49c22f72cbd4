# Robots educativos de iRobot. $place es una dirección o el identificador de un robot.

irobot-garbled = El dispositivo de { $place } no se comporta como un robot de iRobot. Comprueba la dirección en los ajustes del robot.
irobot-button = Se ha pulsado el botón del robot de { $place }: el robot se ha parado y el programa ha terminado.
irobot-is-root = El robot de { $place } es un Root. Elige para él el robot 'root'.
irobot-is-create3 = El robot de { $place } es un Create 3. Elige para él el robot 'create3'.
irobot-marker-stuck = El rotulador de Root no se ha movido en tres segundos. Sácalo y ponlo de modo que casi toque el suelo.
