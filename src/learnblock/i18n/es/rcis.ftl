# RCIS, el simulador de RoboComp.

rcis-picture-size = La cámara de RCIS ha enviado una imagen de { $bytes } bytes, que no es una imagen 4:3. Configura la cámara con una imagen RGB como 320 por 240.
