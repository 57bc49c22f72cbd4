# La ayuda de la página: un bloque, y la búsqueda en bloques, lecciones y documentación.

page-help-title = Ayuda
page-help-search = Buscar bloques, lecciones y documentación
page-help-hint = Escribe una palabra, como «girar», «bucle» o «wifi».
page-help-nothing = No se encontró nada para «{ $words }». Prueba con una palabra más corta o con otra.
page-help-blocks = Bloques
page-help-lessons = Lecciones
page-help-docs = Documentación (en inglés)
page-help-back = Volver a los resultados
page-help-found =
    { $count ->
        [0] No se ha encontrado nada
        [one] 1 resultado
       *[other] { $count } resultados
    }
page-help-example = Ejemplo
page-help-play = Ver otra vez
page-help-open-example = Abrir el ejemplo como proyecto
page-help-elsewhere = También se llama

# Exactamente como se llaman allí los bloques, con sus valores habituales.
page-help-name-start = Scratch: al hacer clic en ⚑ · MakeCode: al iniciar
page-help-name-repeat = Scratch: repetir (10) · MakeCode: repetir (4) veces
page-help-name-forever = Scratch: por siempre · MakeCode: para siempre
page-help-name-if = Scratch: si … entonces · MakeCode: si … entonces
page-help-name-while = Scratch: repetir hasta que, que pregunta lo contrario · MakeCode: mientras
page-help-name-count = MakeCode: para índice de 0 a (4)
page-help-name-each = MakeCode: para elemento valor de lista
page-help-name-wait-until = Scratch: esperar hasta que
page-help-name-wait = Scratch: esperar (1) segundos · MakeCode: pausa (ms) (100)
page-help-name-set = Scratch: dar a [mi variable] el valor (0)
page-help-name-change = Scratch: sumar a [mi variable] (1)
page-help-name-print = Scratch: decir (¡Hola!)
page-help-name-ask = Scratch: preguntar y esperar, y respuesta
page-help-name-define = Scratch: definir, en Mis bloques · MakeCode: función
page-help-name-random = Scratch: número aleatorio entre (1) y (10)
page-help-name-arithmetic = Scratch: ( ) + ( ), ( ) - ( ), ( ) * ( ), ( ) / ( )
page-help-name-remainder = Scratch: ( ) mod ( )
page-help-name-round = Scratch: redondear ( )
page-help-name-compare = Scratch: ( ) > (50), ( ) < (50), ( ) = (50)
page-help-name-and = Scratch: y, o
page-help-name-not = Scratch: no
page-help-name-join = Scratch: unir
page-help-name-list = Scratch: Crear una lista
page-help-name-item = Scratch: elemento (1) de [lista], que cuenta desde 1
page-help-name-replace = Scratch: reemplazar elemento (1) de [lista] con
page-help-name-length = Scratch: longitud de [lista]
page-help-name-contains = Scratch: ¿[lista] contiene?
page-help-name-comment = Scratch: Añadir comentario
page-help-name-move = Scratch: mover (10) pasos
page-help-name-turn = Scratch: girar ↻ (15) grados
page-help-name-point = Scratch: apuntar en dirección (90)
page-help-name-go = Scratch: deslizar en (1) segs a x: (0) y: (0)
page-help-name-key = Scratch: ¿tecla (espacio) presionada?
page-help-name-timer = Scratch: cronómetro
page-help-name-reset-timer = Scratch: reiniciar cronómetro
page-help-name-broadcast = Scratch: enviar (mensaje1)
page-help-name-received = Scratch: al recibir [mensaje1]
page-help-name-pen-down = Scratch: bajar lápiz
page-help-name-pen-up = Scratch: subir lápiz
page-help-name-pen-colour = Scratch: fijar color de lápiz a
page-help-name-pen-size = Scratch: fijar tamaño de lápiz a (1)
page-help-name-erase = Scratch: borrar todo
page-help-name-show-text = MakeCode: mostrar cadena (Hello!)
page-help-name-show-number = MakeCode: mostrar número (0)
page-help-name-clear = MakeCode: borrar la pantalla
page-help-name-note = Scratch: tocar nota, en Música
page-help-name-light = MakeCode: nivel de luz
