# Mundos y robots simulados: sus archivos, sus imágenes y las opciones de una ejecución en ellos.

# Archivos de mundos. $place es el lugar de un valor en el archivo, como box[2].

world-off-floor = '{ $place }' está en ({ $x }, { $y }), fuera del suelo. En este suelo, x va de { $west } a { $east } e y va de { $south } a { $north }.
# $group es la lista del archivo.
world-name-taken =
    { $group ->
        [line] Dos líneas se llaman '{ $name }'. Dale a cada una su propio nombre.
        [start] Dos salidas se llaman '{ $name }'. Dale a cada una su propio nombre.
        [team] Dos equipos se llaman '{ $name }'. Dale a cada uno su propio nombre.
       *[goal] Dos objetivos se llaman '{ $name }'. Dale a cada uno su propio nombre.
    }
# $after es el objetivo que hay que alcanzar antes.
world-goal-circle = El objetivo '{ $name }' va después de '{ $after }', que va después de '{ $name }'. Quita uno de los 'after'.
# Un objetivo que un robot no puede alcanzar; $name es el del objetivo.
world-goal-off-floor = El objetivo '{ $name }' no se puede alcanzar: está fuera del suelo.
world-goal-behind-wall = El objetivo '{ $name }' no se puede alcanzar: hay una pared en medio.
world-goal-behind-box = El objetivo '{ $name }' no se puede alcanzar: hay una caja en medio.
world-goal-behind-cylinder = El objetivo '{ $name }' no se puede alcanzar: hay un cilindro en medio.
world-goal-behind-board = El objetivo '{ $name }' no se puede alcanzar: hay una etiqueta o una cara en medio.
world-goal-behind-prop = El objetivo '{ $name }' no se puede alcanzar: hay un adorno sólido en medio.
world-goal-behind-border = El objetivo '{ $name }' no se puede alcanzar: está demasiado cerca de la pared que rodea el suelo.
world-goal-behind-things = El objetivo '{ $name }' no se puede alcanzar: hay varias cosas en medio.
world-path-part = Escribe cada parte de un camino como {"{"} forward = 300 {"}"} o como {"{"} turn = 90, radius = 300 {"}"}.
world-path-or-wander = Una cosa se mueve por un camino («path») o al azar («wander»), no las dos. Quita «path» o «wander».
# $kind es lo que hay que recoger.
world-nothing-to-collect = El objetivo «{ $name }» pide recoger «{ $kind }», pero el mundo no tiene ningún [[collectable]] así. Añade uno o quita el objetivo.
world-no-gates = El objetivo «{ $name }» pide pasar por puertas, pero el mundo no tiene ninguna [[gate]]. Añade una o quita el objetivo.
# $robot es el nombre de una salida, $team y $other son equipos.
world-robot-in-two-teams = El robot '{ $robot }' está en los equipos '{ $other }' y '{ $team }'. Déjalo en uno de ellos.
world-robot-twice = El equipo '{ $team }' tiene dos veces el robot '{ $robot }'. Quita uno de ellos.
world-reach-choice = Un objetivo tiene como mucho uno de 'robot', 'object', 'together' y 'alone'.
world-line-shape = Una línea necesita 'points' (dos o más) o bien 'start' y 'path'.
world-line-empty = Una línea necesita una longitud, pero esta termina donde empieza.
world-line-open = La línea cerrada '{ $name }' tiene que terminar donde empieza, en ({ $start_x }, { $start_y }). Termina en ({ $x }, { $y }).
world-group-missing = Un mundo del grupo '{ $group }' tiene que contener aquello de lo que trata el grupo.
world-picture-outside = La imagen del suelo '{ $picture }' tiene que estar en la misma carpeta que el archivo del mundo.
world-picture-missing = No hay ninguna imagen del suelo '{ $picture }' en la carpeta del archivo del mundo.
world-picture-too-large = La imagen del suelo '{ $picture }' ocupa más de { $limit } MB.
world-picture-not-png = La imagen del suelo '{ $picture }' no es una imagen PNG. Guárdala como PNG.
world-picture-too-many-pixels = La imagen del suelo '{ $picture }' tiene { $width } por { $height } píxeles. Cada lado puede tener como máximo { $limit } píxeles.
world-picture-damaged = La imagen del suelo '{ $picture }' está dañada.
world-bad-name = Un mundo no puede llamarse '{ $name }'. Usa hasta 40 letras, cifras, guiones, guiones bajos y espacios.

# Worlds as files to share. $limit is in MB.
world-file-type = LearnBlock no puede abrir este tipo de archivo como mundo. Elige un archivo .toml o .zip.
world-file-too-large = Un mundo puede ocupar como máximo { $limit } MB, incluida la imagen del suelo.
world-zip-damaged = Este archivo .zip está dañado. Vuelve a exportar el mundo.
world-zip-too-many = Este archivo .zip tiene más de { $most } archivos. Vuelve a exportar el mundo o elige otro archivo.
world-zip-contents =
    { $count ->
        [0] En este archivo .zip no hay ningún mundo. Un mundo es un archivo .toml.
       *[other] En este archivo .zip hay { $count } archivos .toml. Importa los mundos de uno en uno.
    }

# Archivos de robots simulados.

world-disc-without-radius = Un disco necesita un 'radius'.
world-box-without-size = Una caja necesita 'length' y 'width'.
# $place es el lugar de un sensor o una articulación en el archivo, como joint[1].
world-range-reversed = El 'minimum' de '{ $place }' es { $minimum }. Tiene que ser menor que su 'maximum', { $maximum }.
# $group es la lista del archivo.
world-key-taken =
    { $group ->
        [camera] Dos cámaras tienen la clave '{ $key }'. Dale a cada una su propia clave.
        [joint] Dos articulaciones tienen la clave '{ $key }'. Dale a cada una su propia clave.
        [led] Dos LED tienen el lugar '{ $key }'. Dale a cada uno su propio lugar.
       *[ground] Dos sensores de suelo tienen el lado '{ $key }'. Dale a cada uno su propio lado.
    }

# Una ejecución en un mundo.

world-no-room = En el mundo '{ $world }' no queda suelo libre para otro robot.
world-no-variants = El mundo '{ $world }' no tiene variantes. Añade [vary] a su archivo, con al menos un límite.
# $name es un objeto o una salida.
world-no-room-to-vary = En la variante { $variant } del mundo '{ $world }' no hay sitio para '{ $name }'. Reduce los límites en [vary] de su archivo.
world-bad-variant = La variante tiene que ser un número entero desde 0, no '{ $variant }'.
world-robot-taken = En el mundo ya hay un robot llamado '{ $name }'. Elige otro nombre.
world-bad-pace = El ritmo tiene que ser free, real o un número positivo como 5, no '{ $pace }'.
world-bad-seed = La semilla tiene que ser un número entero, no '{ $seed }'.
world-bad-start = La salida tiene que ser tres números (x, y, orientación), no '{ $start }'.
world-not-drawable = LearnBlock solo puede dibujar una ejecución si su robot es simulado.
# AprilTags.
world-no-tag = No hay ninguna etiqueta { $number }. Las etiquetas de la familia 36h11 tienen los números del 0 al { $last }.
# El título de una página con etiquetas para imprimir.
world-tag-sheet = Etiquetas de LearnBlock
