# El diálogo que elige un robot, y encuentra, conecta y prueba uno real.

page-connect-title = Conectar un robot
page-connect-menu = Conectar un robot…
page-connect-which = Qué robots
page-connect-simulated = Simulado
page-connect-real = Robot real

page-connect-group-twins = En LearnBlock
page-connect-group-own = Los tuyos
page-connect-group-simulators = En otros simuladores
page-connect-simulators-help = Inicia el simulador antes de ejecutar un programa.
page-connect-use = Usar este robot
page-connect-use-named = Usar este robot: { $robot }
page-connect-chosen = Tu robot
page-connect-twin = Gemelo de tu robot

page-connect-found = Encontrados cerca: { $count }
# In the robot's menu, before the robots that answer.
page-connect-near = Cerca de ti
page-connect-before = Usados antes
page-connect-others = No encontrados
page-connect-connect = Conectar
page-connect-save-connect = Guardar y conectar
page-connect-connect-named = Conectar { $robot }
page-connect-disconnect = Desconectar
page-connect-connected = Conectado
page-connect-needs-add-on = Necesita un complemento
# La licencia de un complemento que no es libre.
page-connect-licence-legoed = Con el paquete propio de LEGO, que no es para uso comercial
page-connect-install = Instalar
page-connect-install-named = Instalar lo que necesita { $robot }
page-connect-installing = Instalando…
page-connect-install-stop = Detener la instalación
page-connect-install-terminal = En una terminal:
page-connect-busy = En uso por otra página o un programa
page-connect-looking = Buscándolo…
page-connect-away = No encontrado
page-connect-help = Ayúdame
page-connect-help-named = Ayúdame a encontrar { $robot }
page-connect-hint = ¿Está encendido? ¿Tiene batería?
page-connect-address = Escribir una dirección
page-connect-address-help = Dónde encuentra este ordenador al robot, y qué hay conectado a sus puertos. Guarda los cambios antes de conectar.
page-connect-way-wifi = wifi
page-connect-way-usb = USB
page-connect-way-bluetooth = Bluetooth
page-connect-way-computer = este ordenador
page-connect-charge = { $percent } %

page-connect-idle = Enciende tu robot. En cuanto se encuentre, conéctalo con un clic.
page-connect-state-connecting = Conectando con { $robot }…
page-connect-state-lost = Se ha perdido la conexión con { $robot }. Sus motores se detienen.
page-connect-state-failed = No se puede conectar con { $robot }
page-connect-again = Intentar de nuevo
page-connect-name = Nombre de este { $robot }
page-connect-reading = Leyendo sus sensores…
page-connect-signal-strong = Señal fuerte
page-connect-signal-weak = Señal débil
page-connect-heard = oído hace { $milliseconds } ms
# How long a question to the robot and its answer take together.
page-connect-answers = responde en { $milliseconds } ms
# La fuerza de la radio del robot cuando se encontró; $signal está en dBm.
page-connect-strength = { $strength ->
        [good] buena recepción
        [fair] recepción regular
       *[poor] mala recepción: acércate
    } ({ $signal } dBm al encontrarlo)
page-connect-battery = Batería al { $percent } % aprox. ({ $volts } V)
page-connect-full = Batería al { $percent } %
page-connect-test-wheels = Probar ruedas
page-connect-test-face = Probar cara
page-connect-test-lamps = Probar luces
page-connect-test-beep = Pitido
page-connect-stop = Detener
page-connect-warning = Probar ruedas avanza 50 mm y vuelve. Pon el robot en el suelo.
page-connect-stop-works = Detener funciona siempre:
page-connect-values = Valores en directo
page-connect-heading = Rumbo
page-connect-driving = Avance
page-connect-turning = Giro
page-connect-joint = { $key ->
    [CAMERA] Cabeza
    [ARM] Brazo
   *[other] { $key }
}

page-connect-calibrate = Calibrar
page-connect-exact = Este robot no necesita calibración.
page-connect-calibrate-help = No hay dos robots iguales. Deja que avance y gire, mide cuánto lo ha hecho y LearnBlock corrige sus ajustes.
page-connect-calibrate-warning = El robot necesita 1 m de suelo libre. Marca dónde empieza.
page-connect-drive-distance = Avanzar 500 mm
page-connect-drive-angle = Girar 360°
page-connect-measured-distance = Ha avanzado
page-connect-measured-angle = Ha girado
page-connect-corrections = Ajustes nuevos
page-connect-setting = Ajuste
page-connect-before-correction = Ahora
page-connect-after-correction = Nuevo
page-connect-save-correction = Guardar los ajustes
page-connect-calibrated = Guardado. El robot los usa desde ahora.
page-connect-back = Atrás

page-connect-help-step = Pregunta { $step } de { $steps }
page-connect-help-yes = Sí, siguiente
page-connect-help-looking = Buscando { $robot } todo el tiempo…
page-connect-help-found = ¡{ $robot } está aquí!
page-connect-help-end = { $robot } sigue sin encontrarse. Quizá tiene una dirección distinta de la habitual.

page-connect-help-cozmo-on = ¿Está despierto Cozmo?
page-connect-help-cozmo-on-do = Pon a Cozmo en su cargador. Así se enciende: aparece su cara.
page-connect-help-cozmo-charged = ¿Tiene batería Cozmo?
page-connect-help-cozmo-charged-do = Si se duerme enseguida, déjalo media hora en el cargador.
page-connect-help-cozmo-wifi = ¿Está este ordenador en el wifi de Cozmo?
page-connect-help-cozmo-wifi-do = Sube y baja una vez el brazo de Cozmo. Su pantalla muestra una red, Cozmo_ y seis letras, y la contraseña. Elige esa red en este ordenador. No habrá internet hasta que vuelvas a tu red.
page-connect-help-cozmo-other = ¿Está libre Cozmo?
page-connect-help-cozmo-other-do = Cierra la aplicación de Cozmo en todos los móviles y otros programas que lo usen. Solo uno puede usarlo a la vez.
page-connect-help-cozmo-again = ¿Lo has apagado y encendido?
page-connect-help-cozmo-again-do = Mantén pulsado el botón de su espalda hasta que se apaguen sus luces. Después ponlo otra vez en el cargador y conecta este ordenador a su wifi.

page-connect-help-thymio-on = ¿Está encendido Thymio?
page-connect-help-thymio-on-do = Toca tres segundos el botón redondo entre las flechas, hasta que brillen sus luces.
page-connect-help-thymio-charged = ¿Tiene batería Thymio?
page-connect-help-thymio-charged-do = Déjalo un rato con su cable. La luz junto al conector muestra que carga.
page-connect-help-thymio-cable = ¿Está conectado el cable o el adaptador?
page-connect-help-thymio-cable-do = Conecta el cable USB de Thymio o su adaptador de radio a este ordenador. Algunos cables solo cargan: prueba otro.
page-connect-help-thymio-permission = ¿Puedes usar los puertos serie de este ordenador?
page-connect-help-thymio-permission-do = En Linux, ejecuta: sudo usermod -a -G dialout $USER. Después vuelve a iniciar sesión. Otros sistemas no necesitan nada.
page-connect-help-thymio-other = ¿Está libre Thymio?
page-connect-help-thymio-other-do = Cierra otros programas que usen Thymio, como Aseba Studio o Scratch. Thymio Suite puede seguir abierta.

page-connect-help-legoed-on = ¿Está encendido el Motor doble?
page-connect-help-legoed-on-do = Pulsa su botón hasta que parpadee la luz. Haz lo mismo con el sensor de color, el mando y el Motor simple, si los usas.
page-connect-help-legoed-charged = ¿Tienen batería los dispositivos?
page-connect-help-legoed-charged-do = Si uno se apaga solo, cárgalo con su cable USB.
page-connect-help-legoed-card = ¿Tienen todos los dispositivos la misma tarjeta de conexión?
page-connect-help-legoed-card-do = Acerca una misma tarjeta a cada dispositivo de tu robot, uno tras otro. En una clase, cada grupo tiene su tarjeta.
page-connect-help-legoed-bluetooth = ¿Está encendido el Bluetooth de este ordenador?
page-connect-help-legoed-bluetooth-do = Enciéndelo en los ajustes del sistema y deja que LearnBlock lo use. Los dispositivos no se emparejan allí: si están en la lista, quítalos.
page-connect-help-legoed-other = ¿Están libres los dispositivos?
page-connect-help-legoed-other-do = Cierra otros programas que los usen, como Coding Canvas de LEGO, en todos los ordenadores y tabletas cercanos. Solo uno puede usarlos a la vez.
page-connect-help-create3-on = ¿Está encendido Create 3?
page-connect-help-create3-on-do = Ponlo en su base de carga. El anillo de luces de su botón se pone blanco cuando está listo, al cabo de un minuto.
page-connect-help-create3-charged = ¿Tiene batería Create 3?
page-connect-help-create3-charged-do = Si su anillo está rojo, déjalo un rato en su base.
page-connect-help-create3-mode = ¿Está encendido su Bluetooth?
page-connect-help-create3-mode-do = Lo dice su propia página web, a la que llegas por su wifi. El Bluetooth necesita el firmware G.4.1 o posterior.
page-connect-help-create3-bluetooth = ¿Está encendido el Bluetooth de este ordenador?
page-connect-help-create3-bluetooth-do = Enciéndelo en los ajustes del sistema y deja que LearnBlock lo use. Create 3 no se empareja allí: si está en la lista, quítalo.
page-connect-help-create3-other = ¿Está libre Create 3?
page-connect-help-create3-other-do = Cierra otros programas que lo usen, como iRobot Python Web Playground, en todos los ordenadores y tabletas cercanos. Solo uno puede usarlo a la vez.
page-connect-help-root-on = ¿Está encendido Root?
page-connect-help-root-on-do = Mantén pulsada su nariz amarilla cuatro segundos, hasta que se enciendan sus ojos.
page-connect-help-root-charged = ¿Tiene batería Root, y está sin su cable?
page-connect-help-root-charged-do = Si parpadea en rojo, cárgalo con su cable USB. Quita el cable antes de conectar: Root no se conecta mientras se carga.
page-connect-help-root-bluetooth = ¿Está encendido el Bluetooth de este ordenador?
page-connect-help-root-bluetooth-do = Enciéndelo en los ajustes del sistema y deja que LearnBlock lo use. Root no se empareja allí: si está en la lista, quítalo.
page-connect-help-root-other = ¿Está libre Root?
page-connect-help-root-other-do = Cierra otros programas que lo usen, como iRobot Coding, en todos los ordenadores y tabletas cercanos. Solo uno puede usarlo a la vez.
page-connect-help-spike-on = ¿Está encendido el hub?
page-connect-help-spike-on-do = Pulsa su botón redondo. La luz de Bluetooth parpadea hasta que algo se conecta.
page-connect-help-spike-charged = ¿Tiene batería el hub?
page-connect-help-spike-charged-do = Si se apaga solo, cárgalo con su cable USB.
page-connect-help-spike-pybricks = ¿Lleva Pybricks?
page-connect-help-spike-pybricks-do = El programa propio de LEGO hace un baile de luces al arrancar; Pybricks no. Pon Pybricks una vez, desde un navegador: code.pybricks.com, en Tools.
page-connect-help-spike-bluetooth = ¿Está encendido el Bluetooth de este ordenador?
page-connect-help-spike-bluetooth-do = Enciéndelo en los ajustes del sistema y deja que LearnBlock lo use. El hub no se empareja allí: si está en la lista, quítalo.
page-connect-help-spike-other = ¿Está libre el hub?
page-connect-help-spike-other-do = Cierra otros programas que lo usen, como Pybricks Code, en todos los ordenadores y tabletas cercanos. Solo uno puede usarlo a la vez.

page-connect-help-ev3-on = ¿Está encendido el EV3?
page-connect-help-ev3-on-do = Pulsa su botón central. Está listo cuando su luz es verde; con ev3dev tarda hasta dos minutos.
page-connect-help-ev3-charged = ¿Tiene batería el EV3?
page-connect-help-ev3-charged-do = Si su pantalla se apaga, carga su batería o pon pilas nuevas.
page-connect-help-ev3-system = ¿Usa ev3dev o el programa propio de LEGO?
page-connect-help-ev3-system-do = Con ev3dev, su pantalla muestra "File Browser" al principio del menú; si no, es el programa de LEGO. Los dos sirven.
page-connect-help-ev3-network = ¿Está en la misma red que este ordenador?
page-connect-help-ev3-network-do = Si lo está, su pantalla muestra arriba una dirección IP. Si no, conéctalo en su menú: Wireless and Networks, Wi-Fi. También sirve una conexión por USB o Bluetooth.
page-connect-help-ev3-setup = ¿Se preparó el EV3 para LearnBlock?
page-connect-help-ev3-setup-do = Con ev3dev, ejecuta una vez en este ordenador: learnblock robots setup ev3. Después de encenderlo, inicia learnblock-agent.py en su explorador de archivos. El programa de LEGO no necesita nada.

page-connect-help-ebo-on = ¿Está encendido EBO?
page-connect-help-ebo-on-do = Enciéndelo y espera un minuto, hasta que aparezca su cara.
page-connect-help-ebo-charged = ¿Tiene batería EBO?
page-connect-help-ebo-charged-do = Si su pantalla sigue negra, carga su batería.
page-connect-help-ebo-wifi = ¿Está este ordenador en el wifi de EBO?
page-connect-help-ebo-wifi-do = EBO crea su propia red. Elígela en este ordenador. EBO tiene entonces la dirección 192.168.16.1.
page-connect-help-ebo-other = ¿Está libre EBO?
page-connect-help-ebo-other-do = Cierra otros programas que muevan a EBO.
page-connect-help-ebo-again = ¿Lo has apagado y encendido?
page-connect-help-ebo-again-do = Apaga y enciende EBO, y espera a que aparezca su cara.

page-connect-help-rcis-started = ¿Está en marcha RCIS?
page-connect-help-rcis-started-do = Inicia RCIS con el mundo de tu robot y espera a que su ventana muestre el robot.
page-connect-help-rcis-computer = ¿Está en este ordenador?
page-connect-help-rcis-computer-do = Si RCIS está en otro ordenador, escribe la dirección de ese ordenador.

page-connect-help-coppeliasim-started = ¿Está en marcha CoppeliaSim?
page-connect-help-coppeliasim-started-do = Inicia CoppeliaSim 4.6 o posterior y abre tu escena.
page-connect-help-coppeliasim-service = ¿Está activado su control remoto?
page-connect-help-coppeliasim-service-do = En CoppeliaSim, elige Modules, Connectivity, ZMQ remote API server.
page-connect-help-coppeliasim-other = ¿Está en este ordenador?
page-connect-help-coppeliasim-other-do = Si está en otro ordenador, escribe la dirección de ese ordenador.

page-connect-help-own-on = ¿Está encendido el robot?
page-connect-help-own-on-do = Enciéndelo y espera a que haya arrancado.
page-connect-help-own-charged = ¿Tiene batería el robot?
page-connect-help-own-charged-do = Carga su batería o pon pilas nuevas.
page-connect-help-own-network = ¿Está conectado a este ordenador?
page-connect-help-own-network-do = Conéctalo con su cable o su red, como describe su fabricante.
page-connect-help-own-other = ¿Está libre el robot?
page-connect-help-own-other-do = Cierra otros programas que lo usen.
