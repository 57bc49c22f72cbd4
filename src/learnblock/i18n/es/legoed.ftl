# Los dispositivos de LEGO Education. $place es una dirección o el identificador de un robot.

legoed-not-found = No se ha encontrado ningún Motor doble por Bluetooth en { $seconds } segundos. ¿Está encendido, cerca y sin otro programa que lo use?
# $choice es una dirección, o una tarjeta como "azure 3683".
legoed-other-not-found = No se ha encontrado el Motor doble '{ $choice }' por Bluetooth en { $seconds } segundos. ¿Está encendido, cerca y sin otro programa que lo use? Se elige en los ajustes del robot.
legoed-several = Hay { $number } motores dobles cerca. Acerca una tarjeta de conexión al tuyo y elige la tarjeta en Conectar o en los ajustes del robot.
legoed-garbled = El dispositivo de { $place } no se comporta como el dispositivo de LEGO Education que se esperaba. Comprueba las direcciones en los ajustes del robot.
# $device y $package son versiones, como 2.3.0.
legoed-other-version = { $newer ->
        [true] El dispositivo de { $place } tiene un software más nuevo ({ $device }) que el que conoce el paquete de Python de LEGO ({ $package }). Actualiza el paquete: instala otra vez el complemento, con --upgrade.
       *[false] El dispositivo de { $place } tiene un software más antiguo ({ $device }) que el que espera el paquete de Python de LEGO ({ $package }). Actualiza el dispositivo en https://code.legoeducation.com.
    }
