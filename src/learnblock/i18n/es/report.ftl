# El informe al final de una ejecución en la línea de órdenes y la línea con su estado.

report-label-ended = fin
report-label-time = tiempo
report-label-driven = recorrido
report-label-goal = objetivo
report-label-pose = en
report-label-shown = mostrado
report-label-no-effect = sin efecto
report-label-trace = traza
report-label-picture = dibujo
report-label-page = página

report-ended-finished = terminado
report-ended-stopped = detenido
report-ended-otherwise = acabado
report-ended-time-limit = en el límite de { $seconds } s (cámbialo con --for SEGUNDOS)

# Un número con un decimal.
report-decimal = { $whole },{ $tenths }

report-goal-reached = { $name }: logrado a los { $time } s
report-goal-failed = { $name }: fallado a los { $time } s
report-goal-open = { $name }: no logrado

report-no-device = { $robot } no tiene { $device }
report-emotions-off = La cámara de { $robot } no reconoce emociones. Mira: learnblock perception

report-picture-format = { $file } tiene que ser un archivo .png o .svg.
report-no-picture = No hay nada que dibujar: el programa no ha usado ningún robot.

report-demo = Un EBO simulado busca etiquetas, se acerca a cada una y muestra un sentimiento.
report-connecting = conectando
report-speed = { $factor } x tiempo real

# Ejecuciones con varios robots.
report-team-too-many = { $count } robots son demasiados para una ejecución: pueden participar { $limit } como máximo.
report-team-running = { $count } de { $all } en marcha
report-team-not-deterministic = distinta en cada ejecución, porque participa un robot real

# Ejecuciones en muchas variantes de un mundo. Se alcanzaron $reached de $all objetivos; $time está en segundos.
report-variant = variante { $variant }: { $reached } de { $all } objetivos, { $time } s
report-replay-true = Las posiciones y los objetivos son ciertos: se han repetido { $count }.
report-replay-false = La traza no es cierta: difiere de la ejecución repetida a partir de los { $seconds } s.
report-variants-reached = { $reached } de { $all } variantes: todos los objetivos alcanzados.
report-variants-alone = Con --variants, indica un solo programa para un solo robot y no uses --variant, --trace ni --picture.

# Keys of the keyboard. $keys: their names; the braces belong to JSON.
report-listens = Este programa escucha el teclado: { $keys }. Ctrl-C lo termina.
# $programs: el nombre de cada robot y sus teclas, como «left ↑ ↓; right w s».
report-team-listens = Los programas escuchan el teclado: { $programs }. Ctrl-C los termina todos.
report-why-alone = Con --why, omite --variants.
report-page-alone = Con --page, no uses --variants.
report-name-without-page = Con --name, añade --page ARCHIVO: esa página dice quién la hizo.
report-why-not-a-folder = Los registros de varios robots necesitan una carpeta, y { $folder } no puede serlo.
report-why-not-whole = El registro para preguntas acaba antes de tiempo: { $reason }
report-keys-line = Escribe una línea como {"{"}"t": 1.5, "keys": ["up"]{"}"}.
