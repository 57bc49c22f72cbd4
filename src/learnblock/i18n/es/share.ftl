# Enlaces que contienen un proyecto, y lo que se dice de su ejecución.

share-too-large = Este programa es demasiado grande para un enlace: { $size } caracteres, y un enlace tiene como máximo { $limit }. Comparte el archivo.
share-too-long = Este enlace es demasiado largo: puede tener como máximo { $limit } caracteres. Pide el archivo.
share-no-link = Esto no es un enlace de LearnBlock. Copia el enlace entero, desde http hasta el final.
share-damaged = Este enlace está dañado o incompleto. Copia el enlace entero, desde http hasta el final.
share-version = Este enlace usa la versión { $version } del formato. Ábrelo con un LearnBlock más reciente.
share-opened = Abierto desde un enlace. Ejecutar compara su ejecución con la que se compartió.
share-opened-no-run = Abierto desde un enlace.
share-differs-program = El programa ha cambiado desde que se compartió.
share-differs-robot = El robot es otro.
share-differs-world = El mundo o su variante es otro.
share-differs-place = El robot se colocó en otro sitio.
share-differs-version = Se compartió desde LearnBlock { $theirs }; este es { $ours }.
share-differs-stopped = La ejecución se detuvo.
share-differs-time = La ejecución compartida duró { $theirs } segundos y esta { $ours }.
share-differs-else = Las respuestas, las teclas o los ajustes de este ordenador son distintos.
share-no-run = Ejecuta el programa hasta el final y el enlace demostrará su ejecución.
share-no-run-changed = El programa, su mundo o su sitio ha cambiado desde la última ejecución. Ejecútalo otra vez y el enlace demostrará su ejecución.
share-no-run-real = Un robot real nunca se mueve dos veces exactamente igual, así que el enlace no tiene huella.
share-no-run-person = Esta ejecución dependió de teclas, de respuestas o del programa de un invitado, así que el enlace no tiene huella.
share-no-run-stopped = La última ejecución se detuvo. Deja que el programa termine solo y el enlace demostrará su ejecución.
