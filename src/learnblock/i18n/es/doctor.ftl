# La orden doctor: qué aísla a los programas en este ordenador.

doctor-title = Qué aísla a los programas de robot en este ordenador:
# $name es lo que ha intentado un programa, $reason lo que lo ha impedido.
doctor-contained = {"  "}impedido{"   "}{ $name }: { $reason }
# $name es lo que ha intentado un programa, $reason por qué nada lo impide.
doctor-not-contained = {"  "}PERMITIDO{"  "}{ $name }: { $reason }
doctor-advice = En este ordenador ejecuta solo programas de confianza.

doctor-read = Leer archivos ajenos
doctor-write = Escribir fuera de su carpeta temporal
doctor-network = Usar la red
doctor-processes = Iniciar otros programas
doctor-signals = Detener otros programas
doctor-memory = Usar toda la memoria
doctor-variables = Ver tus variables de entorno
doctor-driver-write = Escribir archivos por medio del controlador de un robot
doctor-driver-network = Usar la red por medio de un controlador que no la necesita
doctor-driver-processes = Iniciar otros programas por medio de un controlador que no los necesita

# $version es un número.
doctor-by-landlock = por Landlock (versión { $version }) del núcleo de Linux
# $kernel es la versión del núcleo.
doctor-no-landlock = este núcleo de Linux ({ $kernel }) no ofrece Landlock, que necesita Linux 5.13 o posterior y estar activado
doctor-by-seccomp = por seccomp del núcleo de Linux
# $machine es un tipo de procesador.
doctor-no-seccomp = falta seccomp, o este procesador ({ $machine }) no se admite
doctor-by-limit = lo limita el sistema operativo
doctor-no-limit = este sistema operativo no lo limita
doctor-by-start = los programas reciben un entorno limpio
# $system es Darwin o Windows.
doctor-other-system = en { $system } solo lo impide Python, y un programa puede saltárselo
doctor-other-system-driver = en { $system } nada se lo impide a los controladores
