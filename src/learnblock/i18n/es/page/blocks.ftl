# La vista del programa en bloques.

page-blocks-label = Programa en bloques
page-blocks-more = { $count ->
    [one] 1 bloque más
   *[other] { $count } bloques más
}
page-blocks-fewer = Menos bloques
# $robot: a robot's name. $device: what it lacks, such as: screen
page-blocks-missing = { $robot } no tiene { $device }
page-blocks-stand-in = { $robot } no tiene { $device }: lo oyes en este ordenador
page-blocks-from-stage = A partir de la etapa { $stage }
page-blocks-inserted = Añadido: { $block }
page-blocks-sheet = Bloques: { $group }
page-blocks-drop-to-delete = Suelta aquí para eliminar
page-blocks-other = Otro…
page-blocks-other-prompt = ¿Cuál?
page-blocks-piano = Piano
page-blocks-pin = Mantener abierta la paleta
page-blocks-unpin = Cerrar la paleta después de usarla
page-blocks-help = Ayuda
# $block: the words of the block
page-blocks-help-on = Ayuda: { $block }
page-blocks-help-key = Explicar el bloque
page-blocks-help-values = Valores
page-blocks-help-insert = Insertar este bloque
page-blocks-help-range = un número de { $min } a { $max }
page-blocks-help-unit = { $range }, en { $unit }
page-blocks-help-robots = Funciona en: { $robots }.
page-blocks-help-all-robots = Funciona en todos los robots.
page-blocks-help-choice = uno de: { $choices }
page-blocks-help-float = un número
page-blocks-help-int = un número entero
page-blocks-help-string = un texto
page-blocks-help-boolean = verdadero o falso
page-blocks-help-list = una lista
page-blocks-help-apriltext = el número o el nombre de una etiqueta
page-blocks-help-colour = un color
page-blocks-help-angle = un ángulo en grados, hacia la derecha
page-blocks-search = Buscar
page-blocks-search-blocks = Buscar bloques
page-blocks-search-program = Buscar en el programa
page-blocks-previous = Anterior
page-blocks-next = Siguiente
page-blocks-close = Cerrar
page-blocks-empty = Arrastra un bloque dentro del amarillo y pulsa Ejecutar.
page-blocks-empty-keys = Arrastra un bloque dentro del amarillo y pulsa Ejecutar. Con el teclado: Intro sobre un bloque, y F1 para la ayuda.
page-blocks-loading = Cargando los bloques…
page-blocks-rest = { $count ->
    [one] 1 bloque más
   *[other] { $count } bloques más
    }
page-blocks-open-rest = Mostrar estos bloques
page-blocks-failed = No se han podido cargar los bloques. Comprueba que LearnBlock está en marcha y recarga la página.
page-blocks-new-when = Nuevo evento…
page-blocks-when-name = mi_evento
# Los nombres de los eventos preparados: solo letras sin tilde, cifras y _.
page-blocks-name-lb-when-is-key-pressed = tecla_pulsada
page-blocks-name-lb-when-is-bumped = choque
page-blocks-name-lb-when-is-front-obstacle = obstaculo_cerca
page-blocks-name-lb-when-received = mensaje_recibido
page-blocks-name-lb-when-collected = cosa_recogida
page-blocks-name-lb-when-is-time-up = se_acabo_el_tiempo
# The heading of events such as "when I collect a star".
page-blocks-in-a-game = En un juego
page-blocks-when-prompt = Nombre del nuevo evento:
page-blocks-zoom = Tamaño de los bloques
page-blocks-zoom-in = Acercar
page-blocks-zoom-out = Alejar
page-blocks-zoom-reset = Tamaño normal
page-blocks-breakpoint = Punto de interrupción: el programa se pausa antes de este bloque
page-blocks-add-breakpoint = Añadir un punto de interrupción
page-blocks-remove-breakpoint = Quitar el punto de interrupción
page-blocks-show-in-texts = Mostrar en el código
page-blocks-search-hint = Escribe para buscar bloques
page-blocks-search-nothing = No hay bloques que coincidan
page-blocks-search-found = { $count ->
    [one] 1 bloque encontrado
   *[other] { $count } bloques encontrados
    }
page-blocks-slider = deslizador
page-blocks-more-values = Mostrar más valores
page-blocks-angle = ángulo en grados, en el sentido de las agujas del reloj
page-blocks-colour = color
page-blocks-other-colour = otro color
page-blocks-tag = número o nombre de una etiqueta
page-blocks-colour-red = rojo
page-blocks-colour-orange = naranja
page-blocks-colour-yellow = amarillo
page-blocks-colour-green = verde
page-blocks-colour-cyan = cian
page-blocks-colour-blue = azul
page-blocks-colour-purple = morado
page-blocks-colour-pink = rosa
page-blocks-colour-white = blanco
page-blocks-colour-black = negro
page-blocks-own = Mis bloques
page-blocks-new-own = Bloque nuevo…
page-blocks-all-own = Gestionar mis bloques…
page-blocks-edit-own = Editar el código de este bloque…
page-blocks-call = llamada a una función
page-blocks-call-value = resultado de una función

# Cómo llaman los niños a lo que los bloques llaman de otro modo: palabras en minúsculas; las que
# llevan tilde, también sin ella.
page-blocks-meaning-loop = bucle, ciclo, otra vez, repetición, repeticion
page-blocks-meaning-condition = condición, condicion, elegir, decidir
page-blocks-meaning-pause = pausa, dormir, retraso
page-blocks-meaning-speed = velocidad, rápido, rapido, despacio, lento
page-blocks-meaning-go = ir, mover, adelante, motor, ruedas
page-blocks-meaning-rotate = rotar, giro, esquina
page-blocks-meaning-halt = detener, frenar
page-blocks-meaning-lamp = lámpara, lampara, luz, bombilla, color
page-blocks-meaning-sensor = sensor, sonar, ultrasonidos, pared, distancia
page-blocks-meaning-face = cara, sentimiento, emoción, emocion, sonrisa
page-blocks-meaning-sound = sonido, música, musica, hablar, tono, pitido
page-blocks-meaning-photo = foto, imagen
page-blocks-meaning-random = dado, azar, suerte
page-blocks-meaning-show = escribir, pantalla, texto
page-blocks-meaning-module = módulo, biblioteca, paquete
page-blocks-meaning-exception = excepción, error, capturar, tratar
page-blocks-meaning-object = objeto, método, atributo, propiedad, orientada a objetos
page-blocks-meaning-switch = switch, patrón, elegir entre casos
page-blocks-meaning-comprehension = comprensión de listas, lista por comprensión
page-blocks-meaning-anonymous = función anónima, lambda
page-blocks-meaning-file = abrir un archivo, leer, contexto
page-blocks-meaning-slice = rebanada, subcadena, trozo
page-blocks-meaning-tuple = tupla, par, intercambiar, desempaquetar
