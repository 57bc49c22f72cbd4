# Mundos y robots simulados: sus archivos, sus imágenes y las opciones de una ejecución en ellos.

# Archivos de mundos. $place es el lugar de un valor en el archivo, como box[2].

world-off-floor = '{ $place }' está en ({ $x }, { $y }), fuera del suelo. En este suelo, x va de { $west } a { $east } e y va de { $south } a { $north }.
# $group es la lista del archivo.
world-name-taken =
    { $group ->
        [line] Dos líneas se llaman '{ $name }'. Dale a cada una su propio nombre.
        [start] Dos salidas se llaman '{ $name }'. Dale a cada una su propio nombre.
       *[goal] Dos objetivos se llaman '{ $name }'. Dale a cada uno su propio nombre.
    }
world-path-part = Escribe cada parte de un camino como {"{"} forward = 300 {"}"} o como {"{"} turn = 90, radius = 300 {"}"}.
world-line-shape = Una línea necesita 'points' (dos o más) o bien 'start' y 'path'.
world-line-empty = Una línea necesita una longitud, pero esta termina donde empieza.
world-line-open = La línea cerrada '{ $name }' tiene que terminar donde empieza, en ({ $start_x }, { $start_y }). Termina en ({ $x }, { $y }).
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
world-robot-taken = En el mundo ya hay un robot llamado '{ $name }'. Elige otro nombre.
world-bad-pace = El ritmo tiene que ser free, real o un número positivo como 5, no '{ $pace }'.
world-bad-seed = La semilla tiene que ser un número entero, no '{ $seed }'.
world-bad-start = La salida tiene que ser tres números (x, y, orientación), no '{ $start }'.
world-not-drawable = LearnBlock solo puede dibujar una ejecución si su robot es simulado.
# AprilTags.
world-no-tag = No hay ninguna etiqueta { $number }. Las etiquetas de la familia 36h11 tienen los números del 0 al { $last }.
# El título de una página con etiquetas para imprimir.
world-tag-sheet = Etiquetas de LearnBlock
