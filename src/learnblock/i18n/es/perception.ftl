# Lo que ven las cámaras: detectores, nombres de etiquetas, cámaras web, vídeos y componentes.

# Por qué no se reconocen emociones en cámaras reales: lo muestra "learnblock perception".
perception-emotions-off =
    El reconocimiento de emociones en cámaras reales, cámaras web y vídeos está desactivado. En la
    Unión Europea, el artículo 5, apartado 1, letra f), del Reglamento de IA (Reglamento (UE)
    2024/1689) prohíbe los sistemas que deducen las emociones de las personas en la educación y en
    el trabajo, salvo por motivos médicos o de seguridad. Otras leyes y las normas de tu centro
    también pueden prohibirlo. Las caras dibujadas y simuladas no son personas: con ellas el
    reconocimiento siempre funciona.

    Solo debería activarlo una persona adulta que lo use donde la ley lo permite. Las imágenes nunca
    se guardan, y solo se envían a los componentes que tú configures.
# $why es el texto anterior.
perception-component-not-allowed =
    El componente { $component } no se ha iniciado porque podría ver caras de personas reales.

    { $why }

    Si solo va a ver caras dibujadas y simuladas, inícialo con --only-drawn-faces. Para activar el reconocimiento de emociones: learnblock perception set emotions_on_cameras true
# $address es HOST:PUERTO; $reason es un mensaje del sistema operativo.
perception-component-cannot-listen = El componente { $component } no puede escuchar en { $address } ({ $reason }). Elige otro --port u otro --host.
# $component es apriltag o emotionrecognition; $reason es lo que ha fallado.
perception-component-unreachable = No se puede conectar con el componente { $component } en { $address }: { $reason } Inícialo, o usa el detector de LearnBlock: learnblock perception set { $component } --default
perception-component-refused = El componente { $component } en { $address } ha rechazado la petición: { $reason } Para usar el detector de LearnBlock: learnblock perception set { $component } --default

# Cámaras web y vídeos. $webcam es el número de la cámara web.

perception-webcam-silent = La cámara web { $webcam } no ha enviado ninguna imagen. Comprueba que está conectada y que no la usa otro programa, o desactívala: learnblock perception set webcam --default
perception-webcam-closed = No se puede abrir la cámara web { $webcam }. Comprueba que está conectada y que no la usa otro programa, o desactívala: learnblock perception set webcam --default
perception-webcam-without-pictures = La cámara web { $webcam } no envía imágenes. Comprueba que está conectada y que no la usa otro programa, o desactívala: learnblock perception set webcam --default
perception-webcam-lost = La cámara web { $webcam } ha dejado de enviar imágenes. Comprueba que sigue conectada, o desactívala: learnblock perception set webcam --default
perception-video-missing = No existe el vídeo { $path }. Elige otro o desactívalo: learnblock perception set video --default
perception-video-unreadable = El vídeo { $path } no contiene imágenes que se puedan leer. Elige otro o desactívalo: learnblock perception set video --default

# Imágenes para un detector. $shape es la forma de un array de numpy.

perception-frame-not-array = Una imagen tiene que ser un array de numpy de uint8 con la forma (alto, ancho, 3), no un { $type }.
perception-frame-not-uint8 = Los valores de una imagen tienen que ser uint8, no { $type }.
perception-frame-wrong-shape = Una imagen tiene que tener la forma (alto, ancho, 3), no { $shape }.
perception-frame-empty = La imagen está vacía: su forma es { $shape }.
perception-frame-too-large = La imagen con la forma { $shape } es demasiado grande. Cada lado puede tener como máximo { $limit } píxeles.
# $name es focal o size.
perception-tag-size = '{ $name }' vale { $value }, pero tiene que ser mayor que 0.
perception-no-weights = Faltan los pesos del detector de emociones ({ $path }). Créalos con: { $command }
# Imágenes enviadas a un componente. $depth es el número de bytes de cada píxel.
perception-picture-not-rgb = Se ha enviado una imagen de { $width } por { $height } píxeles con { $depth } bytes por píxel. Envía RGB con 3 bytes por píxel.
perception-picture-too-large = Una imagen de { $width } por { $height } píxeles es demasiado grande. Se permiten como máximo 1920 por 1200 píxeles.
perception-picture-wrong-size = Una imagen de { $width } por { $height } píxeles tiene { $expected } bytes, pero se han enviado { $size }.

# Los nombres de las etiquetas, en tags.toml.

perception-tags-too-large = El archivo es demasiado grande para nombres de etiquetas: tiene { $size } caracteres y el límite es { $limit }.
perception-tags-too-many = El archivo tiene { $count } nombres de etiquetas. Se permiten como máximo { $limit }.
perception-tags-not-toml = Los nombres de etiquetas son líneas como: ball = 3 ({ $reason })
perception-tags-bad-name = '{ $name }' no puede ser el nombre de una etiqueta. Usa de 1 a { $limit } caracteres visibles.
perception-tags-number-as-name = '{ $name }' es un número, así que no puede ser el nombre de una etiqueta. Usa al menos una letra.
perception-tags-bad-number = '{ $name }' tiene el valor { $value }. El número de una etiqueta es un número entero de 0 a { $last }.

# Los ajustes del reconocimiento con cámaras.
perception-setting-component = SERVIDOR:PUERTO de un componente; vacío para el detector propio de LearnBlock
perception-setting-emotions = reconocer emociones en cámaras reales; la ley puede prohibirlo
perception-setting-layout = qué es el ancho de una imagen para los componentes: rows (RoboComp), columns o auto
perception-setting-video = un vídeo que se usa en lugar de la cámara web; vacío para ninguno
perception-setting-webcam = la cámara web de este ordenador como cámara adicional: 0 es la primera
