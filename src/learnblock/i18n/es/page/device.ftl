# Abrir la página en otro dispositivo.

page-device-title = Abrir en otro dispositivo…
page-device-heading = Abrir en otro dispositivo
page-device-scan = Escanea este código con un móvil o una tableta de la misma red. Abre este proyecto.
page-device-code = Código QR de la dirección de este proyecto
page-device-address = Dirección
page-device-copy = Copiar dirección
page-device-copied = Dirección copiada.
page-device-secret = Quien tenga esta dirección puede abrir y cambiar todos los proyectos.
page-device-alone = Solo este ordenador puede abrir la página. Para abrirla también en otros dispositivos, detén LearnBlock e inícialo con:
