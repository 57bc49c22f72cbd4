# La cámara y la pantalla del robot.

page-camera-camera = Cámara del robot
page-camera-picture = Imagen de la cámara. Lo que reconoce está en la lista de abajo.
page-camera-found = Reconocido en la imagen
page-camera-no-camera = Este robot no tiene cámara.
page-camera-not-kept = La imagen de este momento no se grabó.
page-camera-tag = Etiqueta
page-camera-face = Cara
page-camera-feeling-face = Cara: { $emotion }
page-camera-line = Línea
page-camera-object = { $colour ->
    [red] Objeto rojo
    [orange] Objeto naranja
    [yellow] Objeto amarillo
    [green] Objeto verde
    [blue] Objeto azul
   *[purple] Objeto morado
}
page-camera-lamps = Luces
page-camera-off = apagada
page-camera-fear = miedo
page-camera-surprise = sorpresa
page-camera-anger = enfado
page-camera-sadness = tristeza
page-camera-disgust = asco
page-camera-joy = alegría
page-camera-neutral = calma
page-camera-black = negra
page-camera-red = roja
page-camera-blue = azul
page-camera-left = izquierda
page-camera-center = centro
page-camera-right = derecha
