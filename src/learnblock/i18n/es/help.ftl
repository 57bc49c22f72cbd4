# La ayuda de las órdenes: help-ORDEN es el texto de una orden, y help-ORDEN-with-OPCIÓN el de una
# de sus opciones. El inglés está en el código de las órdenes, en learnblock.cli.

help-word-usage = Uso
help-word-options = Opciones
help-word-commands = Órdenes
help-word-options-metavar = [OPCIONES]
help-word-command-metavar = ORDEN [ARGUMENTOS]...
help-word-epilog = Empieza con: learnblock. O mira lo que hace sin la página: learnblock demo
help-word-help = Muestra esta ayuda y termina.

# Lo que dice click de una llamada con errores; los nombres llegan entre comillas.
help-error = Error: { $message }
help-error-try = Prueba { $command } para ver la ayuda.
help-error-aborted = Cancelado.
help-error-did-you-mean = { $message } ¿Quieres decir { $names }?
help-error-did-you-mean-one-of = { $message } ¿Quieres decir una de estas: { $names }?
help-error-value-for = El valor de { $name } no es válido: { $message }
help-error-value = El valor no es válido: { $message }
help-error-missing = Falta { $name }.
help-error-missing-choice = Falta { $name }. Elige entre:{ $choices }
help-error-missing-option = Falta la opción { $name }.
help-error-missing-option-choice = Falta la opción { $name }. Elige entre:{ $choices }
help-error-missing-command = Falta la orden.
help-error-no-option = No hay ninguna opción { $name }.
help-error-no-command = No hay ninguna orden { $name }.
help-error-option-needs-value = La opción { $name } necesita un valor.
help-error-option-takes-no-value = La opción { $name } no lleva ningún valor.
help-error-count = { $name } necesita { $count } valores.
help-error-extra = Sobra un argumento: { $values }.
help-error-extra-several = Sobran argumentos: { $values }.
help-error-not = { $value } no es { $choice }.
help-error-not-one-of = { $value } no es ninguno de estos: { $choices }.
help-error-not-integer = { $value } no es un número entero.
help-error-not-number = { $value } no es un número.
help-error-not-in-range = { $value } está fuera del intervalo { $range }.
help-error-no-file = No existe el archivo { $name }.
help-error-no-folder = No existe la carpeta { $name }.
help-error-no-path = No existe { $name }.
help-error-is-folder = { $name } es una carpeta, no un archivo.
help-error-is-file = { $name } es un archivo, no una carpeta.
help-error-not-readable = No se puede leer { $name }.
help-error-not-writable = No se puede escribir en { $name }.

help-learnblock =
    Programa cualquier robot con bloques, Block-Text o Python, y pruébalo en un mundo simulado.

    Sin ninguna orden abre la página. Su dirección lleva una clave para que no entre nadie más.
help-learnblock-with-language = Idioma de la salida  [por defecto: LEARNBLOCK_LANGUAGE o el idioma del sistema]
help-learnblock-with-version = Muestra la versión y termina.
help-learnblock-with-port = Puerto en el que escucha  [por defecto: 8421, o uno libre si está ocupado]
help-learnblock-with-host = Dirección en la que escucha  [por defecto: 127.0.0.1]
help-learnblock-with-no-browser = Solo muestra la dirección de la página.
help-learnblock-with-window = Muestra la página en una ventana aparte.
help-learnblock-with-base-url = Ruta de la página detrás de un proxy.
help-learnblock-with-take-over = Si otro LearnBlock está usando la carpeta, deja que lo guarde todo y termine.
help-learnblock-with-proxy-sends-token = Un proxy identifica a quien entra y envía el token (LEARNBLOCK_TOKEN) como cookie.
help-learnblock-with-read-only = Abre y ejecuta proyectos, pero no guarda nada, para que otro LearnBlock pueda seguir.
help-learnblock-with-new-token = Cambia la dirección de la página, para que la anterior deje de abrirla.
help-learnblock-with-allow-host = Nombre con el que un proxy o la red llama a este ordenador.
help-learnblock-with-unix-socket = Escucha en este socket, para un proxy.
help-learnblock-with-projects = Carpeta de los proyectos.

help-blocks = Muestra, comprueba, exporta o importa bloques propios.
help-blocks-with-json = Muestra JSON, para otras herramientas.
help-blocks-check =
    Comprueba un archivo de Python con bloques propios sin ejecutarlo.

    El código de salida es 1 si hay errores; los avisos no lo cambian.
help-blocks-check-with-configuration = Configuración de sus bloques: JSON como en blocks/.
help-blocks-check-with-json = { help-blocks-with-json }
help-blocks-export = Exporta un bloque propio a un archivo, para compartirlo.
help-blocks-import = Importa un bloque propio de un archivo exportado, sin ejecutarlo.
help-blocks-import-with-replace = Sustituye tu bloque del mismo nombre.

help-calls =
    Muestra qué llamó a qué en una ejecución, y durante cuánto tiempo.

    El registro lo escribe learnblock run --why. Los tiempos son los del robot. Dos registros se muestran uno al lado del otro, por ejemplo los de un programa en dos robots: un asterisco marca lo que solo llamó uno de ellos.
help-calls-with-from = Desde este momento, en s.
help-calls-with-to = Hasta este momento, en s.
help-calls-with-svg = Dibuja el grafo en este archivo.
help-calls-with-json = { help-blocks-with-json }

help-check =
    Busca errores en programas sin ejecutarlos.

    Con --robot comprueba también que ese robot tiene lo que necesita cada programa. El código de salida es 1 si hay errores; los avisos no lo cambian.
help-check-with-all-robots = Muestra qué robots pueden ejecutar cada programa.
help-check-with-robot = El robot: mira learnblock robots.
help-check-with-json = { help-blocks-with-json }

help-compare =
    Muestra dónde se separaron dos ejecuciones, y por qué.

    Por ejemplo después de un cambio, con otra semilla, o en otro robot. El ruido solo no cuenta: cuenta la primera decisión distinta. Después de un cambio solo, también la primera orden al robot. Los registros los escribe learnblock run --why, o se descargan de la página.

    Con --with-twin basta un registro de un robot real: su gemelo obedece las mismas órdenes, y la diferencia muestra cómo calibrar el robot.
help-compare-with-with-twin = Compara la ejecución de un robot real con lo que hace su gemelo con las mismas órdenes.
help-compare-with-world = El mundo en el que estuvo el robot real.
help-compare-with-json = { help-blocks-with-json }

help-component =
    Ofrece nuestro detector a RoboComp.

    Los componentes de RoboComp lo llaman por Ice. Termina con Ctrl-C.
help-component-with-port = Puerto en el que escucha  [por defecto: 25000 para apriltag, 10006 para emotionrecognition]
help-component-with-host = Dirección en la que escucha.
help-component-with-layout = Lo que contiene el ancho de una imagen; los clientes de RoboComp envían las filas.
help-component-with-only-drawn-faces = Confirma que solo verá caras dibujadas y simuladas.

help-convert =
    Convierte un programa entre Block-Text y Python.

    El resultado va a la salida estándar.
help-convert-with-to = Notación a la que se convierte.
help-convert-with-robot = { help-check-with-robot }
help-convert-with-json = { help-blocks-with-json }

help-demo =
    Ejecuta una demostración en el simulador y la dibuja.

    Un EBO simulado busca etiquetas, se acerca a cada una y muestra un sentimiento.
help-demo-with-picture = Archivo del dibujo.

help-dev =
    Sirve la página con recarga automática, para quienes la desarrollan.

    Necesita el código fuente y Node.js.
help-dev-with-port = Puerto del servidor Vite.

help-doctor =
    Muestra qué aísla a los programas en este ordenador.

    Ejecuta un programa que intenta escapar, y muestra qué lo ha impedido y qué no.
help-doctor-with-json = { help-blocks-with-json }

help-emulate =
    Emula un robot para probar su controlador.

    El controlador mueve entonces un robot simulado. Termina con Ctrl-C.
help-emulate-with-world = Nombre o archivo del mundo.
help-emulate-with-seed = Semilla de todo el ruido.

help-format =
    Da formato a programas de Block-Text.

    El estilo es fijo: cuatro espacios por nivel, y un espacio donde hace falta.
help-format-with-check = No cambia nada; sale con 1 si cambiaría algo.
help-format-with-stdout = Muestra el resultado sin cambiar nada.
help-format-with-json = { help-blocks-with-json }

help-class =
    Abre una clase: se entra con una palabra, desde cualquier dispositivo del aula.

    Muestra la dirección y la palabra para entrar, y abre el panel de quien enseña. Cada persona tiene
    un nombre y cuatro dibujos en lugar de una cuenta, y un LearnBlock propio en este ordenador. Ctrl-C
    lo guarda todo y cierra la clase; la misma orden la vuelve a abrir.
help-class-with-folder = Dónde se guarda la clase  [por defecto: classes/NAME en tu carpeta]
help-class-with-port = Escucha en este puerto  [por defecto: 8421, o uno libre si está ocupado]
help-class-with-host = Escucha en esta dirección  [por defecto: 0.0.0.0]
help-class-with-allow-host = Un nombre que la red usa para este ordenador.
help-class-with-tls = Usa HTTPS, con un certificado hecho para la clase.
help-class-with-no-browser = Solo muestra las direcciones.
help-class-with-hub = Ser un servicio de JupyterHub, cuyo proxy tiene esta dirección; así solo la abre JupyterHub.
help-class-with-pupils = Con --hub: el grupo del alumnado.
help-class-with-teachers = Con --hub: el grupo de quienes enseñan.
help-class-with-delete = Elimina la clase con todo lo que se ha hecho en ella.

help-grade =
    Evalúa los programas de una clase con las comprobaciones de una lección.

    HANDED_IN son programas (.bt, .py o .learnblock), o carpetas con un programa o una carpeta por alumno; o --class indica una clase de `learnblock class`. Los resultados son results.csv y results.html en la carpeta de --out. La misma orden, repetida, hace solo lo que falta. Ninguna nota es definitiva: decide el profesor.
help-grade-with-class = Evalúa esta clase: de cada persona, lo que ha entregado o el programa más nuevo del paso.
help-grade-with-only-handed-in = De una clase, deja fuera a quien no ha entregado.
help-grade-with-lesson = Nombre, archivo o carpeta de la lección.
help-grade-with-step = El paso  [por defecto: el último con comprobaciones]
help-grade-with-variants = Prueba también en tantas variantes del mundo  [por defecto: las del paso]
help-grade-with-robots = Los robots  [por defecto: los del paso]
help-grade-with-jobs = Ejecuciones a la vez  [por defecto: los procesadores]
help-grade-with-scheduler = Ejecuta en el clúster de Dask con esta dirección.
help-grade-with-out = Carpeta de los resultados.

help-import =
    Importa programas del LearnBlock original.

    Un proyecto (.blockProject, de las versiones 1 a 3) pasa a ser un proyecto .learnblock con sus
    bloques en su sitio, y una biblioteca (NOMBRE.lb) pasa a ser una biblioteca (.lblib). De una
    carpeta se importan todos los proyectos y bibliotecas. No se ejecuta nada de los archivos. Al
    final se muestra lo que cambia y lo que no se ha podido traer; el código de salida es 1 si
    algún archivo no se ha podido importar.
help-import-with-output = Carpeta de los archivos nuevos  [por defecto: la carpeta actual]
help-import-with-to = Si se escriben proyectos para la página o programas en Block-Text.
help-import-with-replace = Reemplaza los archivos que ya existan.
help-import-with-json = { help-blocks-with-json }

help-lesson =
    Enumera, muestra, comprueba, prueba, empaqueta o imprime lecciones.

    LESSON es el nombre de una lección que viene con LearnBlock, una carpeta o un archivo (.lblesson).
help-lesson-list = Enumera las lecciones que vienen con LearnBlock.
help-lesson-list-with-json = { help-blocks-with-json }
help-lesson-show = Muestra una lección: de qué trata, y las instrucciones y metas de sus pasos.
help-lesson-show-with-solutions = También las notas, las soluciones y los programas incorrectos del docente.
help-lesson-show-with-json = { help-blocks-with-json }
help-lesson-check =
    Comprueba una lección: sus archivos, sus soluciones y sus programas incorrectos.

    Las soluciones tienen que cumplir todas las comprobaciones en cada robot y en cada variante; un programa incorrecto típico tiene que fallar en la comprobación que debe y recibir su pista. El código de salida es 1 si algo está mal.
help-lesson-check-with-robot = Solo en este robot; se puede repetir.
help-lesson-check-with-variants = Tantas variantes del mundo.
help-lesson-check-with-json = { help-blocks-with-json }
help-lesson-try =
    Prueba un programa en un paso de una lección y dice qué comprobaciones cumple.

    El código de salida es 1 si no las cumple en cada variante y en cada robot.
help-lesson-try-with-robot = { help-lesson-check-with-robot }
help-lesson-try-with-variants = { help-lesson-check-with-variants }
help-lesson-try-with-hints = Da pistas si falla, de la primera a la última.
help-lesson-try-with-json = { help-blocks-with-json }
help-lesson-pack = Comprueba los archivos de una lección y los empaqueta en uno (.lblesson).
help-lesson-pack-with-for-pupils = Sin lo que solo recibe el docente.
help-lesson-pack-with-out = El archivo que se escribe.
help-lesson-worksheet =
    Pone una lección en papel.

    La ficha tiene las tareas, los bloques de las soluciones para recortar, líneas para escribir y las
    soluciones en páginas aparte. Imprime el .html con un navegador; para un .pdf se necesita Chrome, Edge o
    Chromium.
help-lesson-worksheet-with-to = La ficha, en .html o .pdf  [por omisión: el nombre de la lección con .html]
help-lesson-worksheet-with-language = Idioma de la ficha  [por omisión: el de la salida]

help-library = Crea, instala o quita bibliotecas de habilidades.
help-library-list = Muestra las bibliotecas instaladas.
help-library-list-with-json = { help-blocks-with-json }
help-library-show = Muestra una biblioteca: instalada, o en un archivo o una carpeta.
help-library-show-with-json = { help-blocks-with-json }
help-library-export =
    Crea una biblioteca con funciones de un programa y bloques propios.

    Se añaden también las funciones que llaman esas funciones. La biblioteca se escribe en la carpeta actual.
help-library-export-with-functions = Funciones del programa en FILE.
help-library-export-with-blocks = Bloques propios.
help-library-export-with-name = Nombre con el que la importan los programas.
help-library-export-with-version = De uno a tres números.
help-library-export-with-title = Nombre de la pestaña de la paleta, en inglés.
help-library-export-with-as = Si se escribe un archivo o una carpeta.
help-library-export-with-replace = Sustituye una biblioteca que ya existe.
help-library-import =
    Instala bibliotecas sin ejecutarlas.

    LIBRARY es un archivo, una carpeta, una dirección file:// o un nombre en la carpeta actual. Si una no se puede instalar, no se instala ninguna.
help-library-import-with-rename = Cambia el nombre de una habilidad si ya está ocupado.
help-library-import-with-replace = { help-library-export-with-replace }
help-library-remove =
    Quita una biblioteca instalada.

    Se mueve a la carpeta libraries/.trash.

help-new = Crea los archivos de un robot, una habilidad o un mundo nuevos.
help-new-robot =
    Crea el cliente de un robot, su gemelo para el simulador y una prueba de los dos.

    El gemelo funciona enseguida. En el cliente rellenas las funciones que hablan con el robot; cada una describe lo que tiene que hacer.
help-new-robot-with-from = Lee la descripción del robot de este archivo TOML (docs/add-a-robot.md) en vez de preguntar.
help-new-robot-with-folder = Escribe ahí un paquete aparte, para instalarlo con pip.
help-new-robot-with-force = Sustituye archivos que ya existen.
help-new-skill =
    Crea una habilidad con una prueba.

    La habilidad es un bloque enseguida.
help-new-skill-with-folder = Escribe en esta carpeta en vez de en tu carpeta de LearnBlock.
help-new-skill-with-force = { help-new-robot-with-force }
help-new-world = Crea un mundo para el simulador, con un objeto de cada tipo o a partir de una plantilla.
help-new-world-with-template = Crea un campo con obstáculos, una pista que seguir o un laberinto.
help-new-world-with-size = Cómo de grande es un mundo de una plantilla.
help-new-world-with-seed = Cuál de los mundos de la plantilla: el mismo número crea el mismo mundo.
help-new-world-with-folder = { help-new-skill-with-folder }
help-new-world-with-force = { help-new-robot-with-force }

help-open =
    Abre un programa (.learnblock, .bt o .py) en la página.

    Un archivo de otro sitio se convierte en un proyecto de la carpeta de proyectos; el archivo no cambia.
    Los proyectos del LearnBlock original (.blockProject) se importan: consulta learnblock import.
help-open-with-port = { help-learnblock-with-port }
help-open-with-host = { help-learnblock-with-host }
help-open-with-no-browser = { help-learnblock-with-no-browser }
help-open-with-window = { help-learnblock-with-window }
help-open-with-base-url = { help-learnblock-with-base-url }
help-open-with-take-over = { help-learnblock-with-take-over }
help-open-with-proxy-sends-token = { help-learnblock-with-proxy-sends-token }
help-open-with-read-only = { help-learnblock-with-read-only }
help-open-with-new-token = { help-learnblock-with-new-token }
help-open-with-allow-host = { help-learnblock-with-allow-host }
help-open-with-unix-socket = { help-learnblock-with-unix-socket }
help-open-with-projects = { help-learnblock-with-projects }

help-perception = Muestra o cambia el reconocimiento con la cámara.
help-perception-with-json = { help-blocks-with-json }
help-perception-set = Cambia un ajuste del reconocimiento con la cámara.
help-perception-set-with-default = Vuelve al valor por defecto.
help-perception-set-with-yes = No pregunta.
help-perception-set-with-json = { help-blocks-with-json }

help-picture =
    Dibuja los bloques de un programa en SVG o PNG.

    La imagen lleva dentro sus letras e iconos, y un SVG, el programa como texto alternativo.
    La dibuja Chrome, Edge o Chromium, sin ventana y sin red.
help-picture-with-to = Imagen, en .svg o .png  [por defecto: el nombre del programa con .svg]
help-picture-with-language = Idioma de los bloques  [por defecto: el de la salida]
help-picture-with-theme = Colores de la imagen.

help-replay =
    Comprueba las posiciones y los objetivos de una traza repitiéndola.

    Las órdenes a las ruedas de los robots simulados se repiten en un mundo limpio.
help-replay-with-world = Nombre o archivo del mundo, en vez del de la traza.

help-robots = Muestra los robots; configura, busca o prueba los reales.
help-robots-with-json = { help-blocks-with-json }
help-robots-set = Muestra o cambia los ajustes de un robot real.
help-robots-set-with-default = { help-perception-set-with-default }
help-robots-set-with-json = { help-blocks-with-json }
help-robots-scan = Busca robots reales en puertos serie, en la red y en este ordenador.
help-robots-scan-with-seconds = Cuánto tiempo busca cada tipo de robot.
help-robots-scan-with-json = { help-blocks-with-json }
help-robots-test = Prueba todos los dispositivos de un robot, uno tras otro.
help-robots-test-with-yes = No pregunta; el robot se mueve enseguida.
help-robots-setup = Prepara un robot: copia nuestro agente a un EV3 o nuestros scripts a una escena.

help-run = Ejecuta programas (.bt, .py o .learnblock) en robots.
help-run-with-robot = { help-check-with-robot }
help-run-with-world = { help-emulate-with-world }
help-run-with-seed = Semilla de todo el ruido; la misma semilla da la misma ejecución.
help-run-with-variant = Una variante del mundo; 0 es el mundo tal como está dibujado.
help-run-with-variants = Ejecuta en las variantes de la 1 a este número.
help-run-with-pace = Velocidad: la máxima (por defecto), tiempo real o este número de veces más rápido.
help-run-with-for = Para tras estos segundos del tiempo del robot  [por defecto: 300 a velocidad free]
help-run-with-trace = Escribe la traza como JSON Lines.
help-run-with-why = Escribe un registro para preguntas: mira learnblock why.
help-run-with-picture = Dibuja el mundo y el recorrido como .png o .svg.
help-run-with-page = Escribe una página para llevar a casa, que muestra la ejecución.
help-run-with-name = Dice en esa página quién la hizo.
help-run-with-keys = Pulsa las teclas de este archivo: consulta docs/games.md.
help-run-with-anyway = Ejecuta aunque al robot le falte un dispositivo que necesita.
help-run-with-allow-network = Permite al programa usar la red.
help-run-with-json = { help-blocks-with-json }

help-sets =
    Muestra los conjuntos de bloques.

    Son los incluidos y los tuyos.
help-sets-with-json = { help-blocks-with-json }

help-skills =
    Muestra las habilidades, o describe una.

    Dice qué hace cada una y qué dispositivos necesita.
help-skills-with-json = { help-blocks-with-json }

help-stubs =
    Da a conocer tus robots y habilidades a los editores.

    Escribe sus tipos y su ayuda en archivos de tipos, también para los verificadores de tipos.

    FOLDER es la carpeta de tus programas: si falta, la carpeta actual.

help-tags = Muestra, cambia, importa, exporta o imprime nombres de etiquetas.
help-tags-with-json = { help-blocks-with-json }
help-tags-set = Da un nombre (NAME) a la etiqueta con este número (NUMBER).
help-tags-remove = Quita un nombre (NAME).
help-tags-import =
    Importa los nombres de un archivo (FILE).

    El archivo es TOML con líneas como ball = 3, o CSV con un nombre y un número por línea.
help-tags-import-with-replace = Quita todos los demás nombres.
help-tags-export = Exporta los nombres a un archivo (FILE): CSV si acaba en .csv, y si no TOML.
help-tags-print =
    Crea una página de etiquetas para imprimir con un navegador: todas las que tienen nombre, o las indicadas.

    Imprime la página al 100 % y deja el margen blanco de cada etiqueta.
help-tags-print-with-side = Lado del cuadrado negro en mm.
help-tags-print-with-output = Archivo que se escribe.

help-why =
    Responde a una pregunta sobre una ejecución.

    Por ejemplo, por qué giró el robot, o por qué no. El registro lo escribe learnblock run --why. Sin pregunta, la orden muestra lo que puedes preguntar. El tiempo va en segundos.
help-why-with-more = Muestra también las causas de menos importancia.
help-why-with-json = { help-blocks-with-json }

help-worlds = Muestra los mundos del simulador.
help-worlds-with-json = { help-blocks-with-json }
