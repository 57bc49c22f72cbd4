# La vista del mundo.

page-world-label = El mundo. Las flechas giran la vista, más y menos acercan y alejan, W dice dónde está el robot, V muestra otros robots y P coloca el robot con el teclado.
page-world-image = Mundo: { $title }.
page-world-image-empty = El mundo está vacío.
page-world-no3d = Este navegador no puede mostrar el mundo en 3D. Los programas funcionan igualmente. Para ver el mundo, activa la aceleración por hardware o WebGL en los ajustes del navegador, o usa un navegador más reciente.
page-world-toolbar = Vista del mundo
page-world-eye = Vista y robot
page-world-this = Este mundo
page-world-shown = Se muestra
page-world-values = Valores del robot
page-world-plot = Ver la gráfica de estos valores
page-world-goal = Objetivo: { $goal }
# Un objetivo de un equipo, que tiene un nombre como rojo.
page-world-goal-of-team = { $goal } (equipo { $team })
page-world-team = Equipo { $team }
page-world-goal-of = Objetivo { $number } de { $all }: { $goal }
page-world-free-play = Juego libre
page-world-free-play-help = Este mundo no tiene objetivo: haz con el robot lo que quieras. Los mundos del menú de arriba tienen objetivos.
page-world-bumped = Choque: { $thing }
page-world-real-speed = { $factor }×: lo más rápido que puede este ordenador
page-world-mm = { $mm } mm
page-world-nothing-near = nada cerca
page-world-degrees = { $degrees }°
page-world-tool-eye = Vista desde el robot
page-world-tool-orbit = Mirar alrededor
page-world-tool-follow = Seguir al robot
page-world-tool-top = Ver desde arriba
page-world-tool-split = Siguiente vista de los robots
page-world-players-all = Seguir a todos los robots
# $first and $second are the names of robots.
page-world-players-split = Uno junto a otro: { $first } y { $second }
page-world-players-one = Seguir a { $first }
page-world-tool-nearer = Acercar
page-world-tool-farther = Alejar
page-world-tool-whole = Mostrar todo el mundo
page-world-tool-trail = Mostrar el rastro del robot
page-world-tool-beams = Mostrar los rayos de los sensores de distancia
page-world-tool-place = Colocar el robot con el teclado
page-world-tool-where = ¿Dónde está el robot?
page-world-tool-why = ¿Por qué hace esto el robot?
page-world-hand = Sacudir e inclinar el robot
page-world-tool-shake = Sacudir el robot
page-world-tool-front = Inclinar el robot hacia delante
page-world-tool-back = Inclinar el robot hacia atrás
page-world-tool-left = Inclinar el robot a la izquierda
page-world-tool-right = Inclinar el robot a la derecha
page-world-placing = Las flechas mueven el robot 10 mm (Mayús: 100 mm); la coma y el punto lo giran. Pulsa Escape para terminar.
# $keys: those that programs ask for; $programs: how many do.
page-world-keys-wanted = { $programs ->
    [one] El programa escucha { $keys }. Haz clic en el mundo para pulsarlas.
   *[other] Los programas escuchan { $keys }. Haz clic en el mundo para pulsarlas.
}
page-world-keys-heard = { $programs ->
    [one] El programa escucha { $keys }.
   *[other] Los programas escuchan { $keys }.
}
page-world-keys-all = todas las letras, cifras y flechas, el espacio e intro
page-world-key-space = espacio
page-world-key-enter = intro
page-world-placed = El robot se queda aquí.
page-world-not-now = El robot no se puede mover mientras se ejecuta un programa. Pausa o para antes el programa.
page-world-robot = { $robot } a { $place }
page-world-place = { $x }, { $y }, mirando al { $direction }
page-world-east = { $mm } mm al este
page-world-west = { $mm } mm al oeste
page-world-north = { $mm } mm al norte
page-world-south = { $mm } mm al sur
page-world-direction-e = este
page-world-direction-se = sureste
page-world-direction-s = sur
page-world-direction-sw = suroeste
page-world-direction-w = oeste
page-world-direction-nw = noroeste
page-world-direction-n = norte
page-world-direction-ne = noreste
page-world-nothing-ahead = nada delante en { $mm } mm
page-world-something-ahead = obstáculo a { $mm } mm
page-world-emotion = muestra { $emotion }
page-world-emotion-joy = alegría
page-world-emotion-sadness = tristeza
page-world-emotion-anger = enfado
page-world-emotion-fear = miedo
page-world-emotion-disgust = asco
page-world-emotion-surprise = sorpresa
page-world-emotion-neutral = una cara neutra
page-world-text = muestra «{ $text }»
page-world-goal-reached = Objetivo alcanzado: { $name }.
page-world-goal-failed = Objetivo fallido: { $name }.
page-world-goal-open = Objetivo aún no alcanzado: { $name }.

# The themes of worlds.

page-world-kind-ball = Pelota
page-world-kind-barrel = Barril
page-world-kind-block = Bloque
page-world-kind-cone = Cono de tráfico
page-world-kind-crate = Caja de madera
page-world-kind-flowers = Flores
page-world-kind-house = Casa
page-world-kind-lamp = Farola
page-world-kind-pile = Pila de bloques
page-world-kind-planet = Planeta
page-world-kind-post = Poste
page-world-kind-rocket = Cohete
page-world-kind-tree = Árbol
page-world-kind-anything = Cualquier cosa
page-world-kind-star = Estrella
page-world-kind-coin = Moneda
page-world-kind-gem = Gema
page-world-kind-heart = Corazón
page-world-kind-cherry = Cereza
page-world-kind-battery = Pila
page-world-kind-key = Llave
page-world-kind-flag = Bandera
page-world-kind-bug = Bicho
page-world-kind-ghost = Fantasma
page-world-ends-no = no
page-world-ends-win = ganado
page-world-ends-lose = perdido
page-world-when-entered = se entra
page-world-when-left = se sale
page-world-time-up-lose = se pierde
page-world-time-up-win = se gana
page-world-time-up-program = decide el programa
page-world-theme-playground = Patio de juegos
page-world-theme-city = Ciudad
page-world-theme-space = Espacio
page-world-theme-warehouse = Almacén
page-world-theme-garden = Jardín
page-world-theme-night = Noche
page-world-theme-maze = Laberinto

# Un juego: sus puntos, sus vidas y su tiempo.
page-world-game-label = Juego
page-world-game-score = Puntos: { $score }
page-world-game-lives = Vidas: { $lives }
page-world-game-time = Tiempo que queda: { $seconds } segundos
page-world-game-won = Has ganado
page-world-game-team-wins = Gana el equipo { $team }
page-world-game-robot-wins = Gana { $robot }
# El objetivo que ganó el juego, y el robot del equipo que lo alcanzó.
page-world-game-goal-by = { $goal } ({ $robot })
page-world-game-over = Fin del juego
page-world-game-time-up = Se acabó el tiempo
page-world-game-no-lives = No quedan vidas
page-world-game-again = Jugar otra vez
page-world-game-watch = Ver otra vez
page-world-game-close = Cerrar

# El final de una ejecución, otra vez.
page-world-replay-label = Repetición
page-world-replay-title = Los últimos { $seconds } segundos
page-world-replay-film = Guardar como película
page-world-replay-stop = Parar
