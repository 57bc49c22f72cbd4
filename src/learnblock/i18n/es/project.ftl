# Projects: their files, names and folder, and what a page does with an open project.

## Names and files

project-name-wrong = Un proyecto no puede llamarse '{ $name }'. Usa hasta { $limit } letras, cifras, espacios, '-', '_' y '.', y empieza por una letra o una cifra.
project-name-device = Windows reserva el nombre '{ $name }' para un dispositivo. Elige otro nombre.
project-character = El carácter U+{ $code } no se puede guardar. Quítalo del programa.
project-program-too-long = El programa tiene { $size } caracteres, más de los { $limit } que LearnBlock puede editar. Divídelo en varios programas o en funciones de una biblioteca.
project-too-large = El proyecto tiene { $size } bytes, pero un proyecto puede tener como máximo { $limit }.
# $names es una lista de nombres.
project-code = { $file } trae código que no está instalado aquí: { $names }. Para leerlo e instalarlo, ejecuta: { $command }
project-type = LearnBlock no puede abrir este tipo de archivo. Elige un archivo .bt, .py, .learnblock o .blockProject.
project-none = Este archivo está dañado o no es un proyecto de LearnBlock. Un archivo de proyecto empieza por { $start }.
project-not-utf-8 = Este archivo está dañado o no es un proyecto de LearnBlock: el byte { $byte } no es UTF-8.
project-damaged = Este archivo está dañado o no es un proyecto de LearnBlock: { $reason }. Usa una copia anterior del archivo.
project-too-deep = Este archivo tiene demasiados paréntesis unos dentro de otros para ser un proyecto.
project-version = Este proyecto usa la versión { $version } del formato, pero este LearnBlock lee la versión { $known }. Ábrelo con un LearnBlock más nuevo.
project-path = { $kind ->
        [robot] El robot es { $value }, pero un proyecto solo puede nombrar un robot, como '{ $example }'.
       *[world] El mundo es { $value }, pero un proyecto solo puede nombrar un mundo, como '{ $example }'.
    }
project-value = { $place } es { $value }. { $expected }
project-value-wrong = { $place } no es válido. { $expected }
project-expects-blocktext = Debe ser una lista con las líneas del programa.
project-expects-python = Debe ser una lista con las líneas del programa en Python.
project-expects-robot = Debe ser el nombre de un robot, como 'sim-ebo'.
project-expects-world = Debe ser el nombre de un mundo, como 'line'.
project-expects-breakpoints = Debe ser una lista con los identificadores de { $limit } bloques como máximo.
project-expects-shown = Debe ser el nombre de un conjunto de bloques, como 'first-steps'.
project-expects-block-sets = Debe ser una lista de { $limit } conjuntos de bloques como máximo.
project-expects-libraries = Debe dar la versión de cada biblioteca, como { $example }.
project-expects-workspace = Quita el espacio de trabajo del archivo para colocar los bloques de nuevo.
project-expects-first = Debe ser el nombre del primer robot.
project-expects-count = Debe ser el número de robots que ejecutan el programa: de 1 a { $limit }.
project-expects-others = Debe ser una lista de { $limit } robots como máximo, cada uno con su name, robot y blocktext.
project-robot-name = Los robots de un proyecto necesitan nombres distintos de 40 letras, cifras, espacios y guiones como máximo, no '{ $name }'.

## Folder

project-no-access = { $action ->
        [read] No se puede leer el proyecto en { $folder }: { $reason }
        [save] No se puede guardar el proyecto en { $folder }: { $reason }
        [rename] No se puede cambiar el nombre del proyecto en { $folder }: { $reason }
        [delete] No se puede borrar el proyecto en { $folder }: { $reason }
        [keep-version] No se puede guardar la versión en { $folder }: { $reason }
        [read-version] No se puede leer la versión en { $folder }: { $reason }
        [keep-run] No se puede guardar la ejecución en { $folder }: { $reason }
       *[read-runs] No se puede leer la lista de ejecuciones en { $folder }: { $reason }
    }
project-name-taken = Ya hay un proyecto llamado '{ $name }'. Elige otro nombre.
project-picture-wrong = La imagen de un proyecto debe ser un JPEG de { $limit } bytes y { $side } píxeles por lado como máximo.
project-in-use = El proyecto '{ $name }' está abierto. Cierra antes sus páginas.

## Opening

project-robot-replaced = { $problem } El proyecto usa ahora el robot '{ $robot }'.
project-world-replaced = { $problem } El proyecto usa ahora el mundo '{ $world }'.
project-blocks-replaced = { $problem } El proyecto muestra ahora todos los bloques.
project-library-missing = Este programa se hizo con la versión { $version } de la biblioteca '{ $library }', que no está instalada. Importa la biblioteca.
project-library-older = Este programa se hizo con la versión { $version } de la biblioteca '{ $library }', pero está instalada la versión { $installed }. Importa la versión más nueva.

## Lo que lleva un archivo

# $example es JSON; $last es el número más alto de una etiqueta.
project-expects-tags = Debe dar el número de cada etiqueta, de 0 a { $last }, como { $example }.
project-expects-carried = Quita 'carried' del archivo para abrir solo el programa.
project-world-added = Este proyecto traía su mundo '{ $world }'. Ahora es uno de tus mundos.
project-world-renamed = Ya tienes otro mundo '{ $world }', así que el de este proyecto se llama ahora '{ $here }'.
# $problem es una frase.
project-world-damaged = El mundo '{ $world }' del archivo de este proyecto no se puede usar: { $problem }
# $names es una lista de nombres.
project-tags-added = Este proyecto traía nombres de etiquetas: { $names }. Ahora están entre tus nombres de etiquetas.
project-tag-differs = En este proyecto, la etiqueta '{ $name }' tiene el número { $number }; en tus nombres de etiquetas tiene el { $here }. El proyecto usa el { $number }. Para cambiarlo, edita tus nombres de etiquetas.
# $limit está en bytes.
project-carries-less = Al archivo descargado le falta el mundo del proyecto, o sus bloques y bibliotecas, porque ocuparía más de { $limit } bytes. Expórtalos por separado.
