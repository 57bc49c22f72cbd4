# La búsqueda de la paleta: cómo llaman Scratch, MakeCode y otros a las cosas. Cada línea tiene palabras que se buscan,
# en minúsculas y separadas por comas; la que termina en -say dice qué hay aquí en su lugar, si ningún bloque hace
# justo eso.

# $words: lo que se buscó
page-search-nearest = Ningún bloque dice «{ $words }». Estos son los más parecidos:
# El nombre de una variable para puntos.
page-search-variable = puntos

page-search-score = puntuación, puntos, vidas, récord, contador, marcador
page-search-score-say = Estos bloques cuentan en un juego, y una variable cuenta lo demás:
page-search-game = juego, fin del juego, ganar, perder, jugador, nivel, objeto, enemigo
page-search-game-say = Para hacer un juego, maneja un robot con teclas y cuenta puntos:
page-search-clone = clon, clonar, disfraz, fondo, escenario, personaje, actor
page-search-clone-say = Aquí el actor es el robot, y los escenarios están en el menú Mundo. Puede cambiar de cara:
page-search-hide = esconder, ocultar, invisible, desaparecer
page-search-hide-say = Un robot no puede esconderse, pero puede no mostrar nada:
page-search-say = decir, pensar, bocadillo, contar, hablar, di
page-search-smile = sonreír, sonrisa, reír, feliz, contento, contenta, alegría
page-search-glide = deslizar, desliza, mover, pasos, andar, caminar, ir a
page-search-direction = apuntar en dirección, apuntar hacia, dirección, rumbo, brújula
page-search-position = posición, coordenadas, coordenada, lugar
page-search-edge = borde, rebotar, chocar, choque, tocando, tocar, golpe
page-search-broadcast = enviar, mensaje, radio, señal, recibir
page-search-flag = bandera verde, bandera, al empezar, al iniciar, inicio, principal
page-search-event = evento, eventos, sombrero, cuando, al presionar, al agitar, al hacer clic
page-search-key = tecla, teclas, teclado, flecha, flechas, mando, botón, ratón
page-search-timer = cronómetro, reloj, cuenta atrás, temporizador, tiempo
page-search-ask = preguntar, respuesta, entrada, pregunta
page-search-text = unir, letra, cadena, contiene
page-search-remainder = módulo, mod, resto, residuo
page-search-array = matriz, colección, vector, arreglo
page-search-function = función, procedimiento, definir, método, subrutina, crear un bloque
page-search-pen = dibujar, pintar, sellar, tortuga, pincel
page-search-icon = icono, píxel, corazón, mostrar icono, mostrar leds
page-search-volume = volumen, alto, silencio, bajar sonido
page-search-microphone = micrófono, oír, palmada, nivel de sonido
page-search-microphone-say = Estos robots no tienen micrófono. Notan que los agitan o que chocan:
page-search-temperature = temperatura, imán, magnético, humedad, aceleración
page-search-temperature-say = Estos robots no miden eso. Sí miden la luz y la inclinación:
page-search-servo = servo, brazo, pinza, elevador, garra
page-search-leave = romper, salir, fin, detener todo, terminar, continuar
page-search-animate = animar, animación, bailar, actuar
page-search-dictionary = mapa, registro, json, diccionario
page-search-size = tamaño, crecer, encoger, efecto, capa
page-search-size-say = Un robot no cambia de tamaño. Sus luces y su cara sí:
