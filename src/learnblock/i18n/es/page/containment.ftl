# What programs may do: what contains them on the server's computer, and the network.

page-containment-title = Qué pueden hacer los programas
page-containment-menu = Qué pueden hacer los programas…
page-containment-help = En el ordenador que ejecuta LearnBlock, un programa de prueba ha intentado saltarse los límites de todos los programas:
page-containment-trying = Probando qué pueden hacer los programas…
page-containment-attempt = Qué intenta un programa
page-containment-result = Resultado
page-containment-reason = Motivo
page-containment-refused = Impedido
page-containment-allowed = Permitido
page-containment-warning = En este ordenador, los programas pueden saltarse los límites de LearnBlock. Ejecuta solo programas de confianza.
page-containment-details = Ver detalles
page-containment-network = Red
page-containment-network-allow = Los programas del proyecto «{ $name }» pueden usar la red
page-containment-network-help = Se aplica a partir de la próxima ejecución. Quien puede abrir esta página puede cambiar el proyecto: permítelo solo si te fías.
