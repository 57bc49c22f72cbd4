# learnblock robots test: la prueba de los dispositivos de un robot real.

testing-ask-room = El robot avanzará un segundo, retrocederá y girará. ¿Hay sitio suficiente a su alrededor?
testing-ask-driven = ¿Ha avanzado 5 cm y ha vuelto, y luego ha girado a la derecha y ha vuelto?
testing-ask-joint = ¿Está la articulación un poco por encima del centro (10°)?
testing-ask-joy = ¿Tiene cara de alegría?
testing-ask-light = ¿Está encendida esta luz (en rojo, si puede cambiar de color)?
testing-ask-beep = ¿Ha sonado un pitido?

testing-reading = { $reading }
testing-picture = imagen de { $width } × { $height } píxeles
testing-acceleration = x { $x }, y { $y }, z { $z } m/s²
testing-drives = se mueve; sin odometría
testing-drives-by-odometry = se mueve; odometría: { $distance } mm, { $angle }°
testing-angle = se mueve; lee { $angle }°
testing-no-angle = se mueve; no se puede leer su ángulo
testing-shows-joy = muestra alegría
testing-lights = se enciende
testing-beeps = suena
testing-no-tones = no puede tocar tonos
testing-not-driven = no se ha movido
testing-not-seen = no se ha visto
testing-no-picture = No ha llegado ninguna imagen en 2 segundos.
testing-moved-otherwise = No se ha movido como se describe. En los ajustes del robot, revisa los puertos de sus motores y si algún motor necesita el signo menos porque gira al revés.
