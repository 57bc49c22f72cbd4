# Robots de cualquier tipo: su clase, sus dispositivos y habilidades, sus ajustes.

robot-key-taken = Este robot ya tiene un dispositivo de tipo { $device } con la clave '{ $key }'. Dale otra clave al segundo.
# Mensajes entre robots.
robot-message-name = El nombre de un mensaje es un texto de 1 a { $limit } caracteres, como "ya".
robot-message-value = Un mensaje no puede llevar este valor ({ $type }). Envía un número, un texto, verdadero o falso, o una lista o un diccionario de estos.
robot-message-too-large = El valor del mensaje '{ $message }' tiene { $size } bytes, pero un mensaje puede llevar { $limit } como máximo. Envía menos de una vez.
robot-stopped = El robot se ha parado y ya no se puede usar. Ejecuta el programa otra vez.
# El programa pide un sentido o un dispositivo que la comprobación no podía conocer.
robot-lacks = Este robot no tiene { $device }, que esta parte del programa necesita.
robot-lacks-for-skill = Este robot no tiene { $device }: no puede hacer '{ $skill }'.
robot-skill-name-taken = Una habilidad no se puede llamar '{ $name }', porque todos los robots ya tienen ese nombre. Elige otro nombre.
robot-unknown-skill = Este robot no tiene ninguna habilidad '{ $name }'.
robot-unknown-skill-like = { robot-unknown-skill } ¿Querías decir '{ $suggestion }'?

# La clase de un robot. $module es el nombre del módulo en Python.
robot-no-class = El archivo del robot { $module } necesita una clase 'Robot' que herede de 'Client'.
robot-not-loaded = No se puede cargar el robot '{ $name }' ({ $reason }).
# The guardian of a robot without a watchdog.
robot-computer-froze = Este ordenador estuvo parado o demasiado ocupado durante medio segundo, así que se pararon los motores de '{ $robot }'. Cierra otros programas si pasa a menudo y vuelve a ejecutar el programa.
robot-guardian-ended = El proceso que para '{ $robot }' en una emergencia ha terminado, así que no es seguro conducir el robot. Vuelve a ejecutar el programa.
# La conexión con un robot cuya biblioteca es asíncrona. $reason es el error de la biblioteca, en inglés.
robot-link-silent = El robot en { $place } ha dejado de responder. ¿Está encendido y cerca?
robot-link-broke = Se ha perdido la conexión con el robot en { $place } ({ $reason }). ¿Está encendido y cerca?
robot-link-closed = La conexión con el robot en { $place } está cerrada. Ejecuta el programa otra vez.
robot-needs-no-setup = El robot '{ $name }' no necesita preparación.
robot-missing-add-on = El robot '{ $robot }' necesita un complemento que no está instalado. Instálalo con: { $command }
robot-missing-package = El robot '{ $robot }' necesita el paquete de Python { $package }. Instálalo donde está instalado LearnBlock.
robot-not-written = { $file }, línea { $line }: falta escribir '{ $call }'. { $task }

# Los componentes de EBO y de RCIS.
robot-part-unreachable = { $robot ->
    [rcis] RCIS no responde en { $place } ({ $part ->
        [base] las ruedas
        [joint] la inclinación de la cámara
        [laser] los sensores de distancia
        [face] la cara
        [screen] la pantalla
       *[camera] la cámara
    }). ¿Está en marcha, con todos sus componentes?
   *[ebo] EBO no responde en { $place } ({ $part ->
        [base] las ruedas
        [joint] la inclinación de la cámara
        [laser] los sensores de distancia
        [face] la cara
        [screen] la pantalla
       *[camera] la cámara
    }). ¿Está encendido y este ordenador está en su wifi?
}
robot-part-layout = { $robot ->
    [rcis] RCIS
   *[ebo] EBO
} en { $place } usa otro formato de mensajes. Elige otro 'layout' en los ajustes del robot.
robot-part-refused = { $robot ->
    [rcis] RCIS
   *[ebo] EBO
} en { $place } no puede hacer eso ({ $reason }).
robot-unknown-layout = { $robot ->
    [rcis] RCIS
   *[ebo] EBO
} en { $address } usa un formato de mensajes que LearnBlock no conoce. Actualiza sus componentes o LearnBlock.

# Qué significa un ajuste; aparece debajo de su campo y en la línea de órdenes.
robot-setting-patience = tiempo máximo de espera en segundos
robot-setting-address = nombre del equipo o dirección IP
robot-setting-port = puerto de red
robot-setting-serial-port = puerto serie, como /dev/ttyUSB0 o COM3
robot-setting-baud = bits por segundo
robot-setting-length = mm
robot-setting-speed = mm/s
robot-setting-voice = voz de espeak-ng
robot-setting-colour = imágenes en color con la mitad de ancho; si no, en gris
robot-setting-stop-at-cliff = parar donde acaba el suelo
robot-setting-volume = volumen en tanto por ciento
robot-setting-camera-port = puerto de red; 0 sin cámara
robot-setting-layout = formato de mensajes de los componentes; auto lo averigua
robot-setting-connection = agent o rpyc con ev3dev, direct con el firmware de LEGO; auto los prueba por orden
robot-setting-device = firmware de LEGO por USB o Bluetooth: un dispositivo como /dev/hidraw0
robot-setting-token = secreto compartido con el agente, creado por setup
robot-setting-user = nombre de usuario en ev3dev
robot-setting-password = contraseña de ese usuario
robot-setting-full-speed = velocidad del motor de una rueda al 100 %, en grados/s
robot-setting-legoed-card = la tarjeta de conexión de los dispositivos del robot, como azure 3683; vacía para el único Motor doble cercano
robot-setting-legoed-address = dirección Bluetooth del Motor doble; vacía para encontrarlo por su tarjeta
robot-setting-legoed-device = dirección Bluetooth del dispositivo; vacía para el que tenga la misma tarjeta, none si no lo hay
robot-setting-legoed-front = el extremo del Motor doble que es la parte delantera del robot, según su propio adelante
robot-setting-irobot-address = nombre o dirección Bluetooth del robot; vacío para el primero que se encuentre
robot-setting-spike-address = nombre o dirección Bluetooth del hub; vacío para el primero que se encuentre
robot-setting-thymio-connection = auto usa Thymio Suite si está en marcha; si no, un cable; si no, tcp
robot-setting-thymio-device = puerto serie; vacío para el primer Thymio que se encuentre
robot-setting-track = distancia entre las ruedas en mm
robot-setting-speed-unit = velocidad de una rueda con velocidad de motor 1, en mm/s
robot-setting-name = cómo llamas a este robot
robot-setting-scene = el script de LearnBlock, la escena del artículo o un robot por los nombres de sus partes
robot-setting-script = objeto con el script; vacío para el habitual
robot-setting-object = ruta de un objeto en la escena, como /Robot/sonar
robot-setting-sensors = sensores de distancia, de izquierda a derecha
