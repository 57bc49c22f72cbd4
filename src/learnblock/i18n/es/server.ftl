# The server: where it listens, who may use it, and messages from pages that it can't carry out.

## Starting

server-started =
    LearnBlock está en marcha en { $address }
    Pulsa Ctrl-C para pararlo.
server-running =
    LearnBlock ya está en marcha. Su página está en { $address }
    Para terminarlo y empezar uno nuevo, usa --take-over.
server-silent = El LearnBlock de { $address } no responde. Usa --take-over para terminarlo y empezar uno nuevo.
server-cannot-listen = LearnBlock no puede escuchar en { $host }, puerto { $port }: { $reason }. Elige otro con --port.
server-cannot-listen-socket = LearnBlock no puede escuchar en { $path }: { $reason }.
server-already-listening = Otro LearnBlock está escuchando en { $path }.
server-token-wrong = { $variable } solo puede contener letras, cifras, '-', '_', '.' y '~'.
server-no-window = Una ventana necesita un complemento que no está instalado. Quita --window para usar el navegador, o instálalo con: { $command }

server-not-contained =
    Otros ordenadores pueden usar esta página, y en este ordenador nada aísla del todo sus programas: { $free }.
    Ejecuta solo programas de confianza. Los motivos: learnblock doctor, o "Qué pueden hacer los programas" en el menú de ayuda de la página.

## One writer per folder

server-owner = el proceso { $process }, desde { $since }, en { $address }
server-owner-elsewhere = el proceso { $process } en { $computer }, desde { $since }, en { $address }
server-owner-unknown = un proceso que acaba de empezar o que es de otro usuario
server-folder-used = Otro LearnBlock está usando la carpeta { $folder }: { $owner }.
server-folder-refused = { $used } Usa --take-over para que lo guarde todo y termine, --read-only para abrir y ejecutar proyectos sin guardar nada, o --projects para elegir otra carpeta.
server-folder-waiting = Esperando hasta { $seconds } segundos a que el otro LearnBlock lo guarde todo y termine: { $owner }
server-folder-kept = El otro LearnBlock no ha terminado: { $owner }. Sigue usando la carpeta { $folder }. Termina tú ese proceso y vuelve a iniciar LearnBlock, o usa --read-only.
server-folder-unlocked = LearnBlock no puede bloquear la carpeta { $folder } ({ $reason }), así que no sabe si otro LearnBlock la está usando. Abre estos proyectos en un solo LearnBlock a la vez.
server-taken-over = Otro LearnBlock se hace cargo de esta carpeta. Guardando todo...
server-ends-late = Algo se ha bloqueado en LearnBlock. Se guarda todo y se termina ahora.
server-ends-at-once = Se guarda todo y se termina enseguida.
server-reading = Solo lectura: puedes abrir y ejecutar proyectos, pero los cambios no se guardan.
server-reading-beside = Solo lectura: otro LearnBlock está usando estos proyectos ({ $owner }). Puedes abrirlos y ejecutarlos, pero no cambiarlos aquí.
server-read-only = Aquí no se puede cambiar nada: este LearnBlock solo lee. Para hacer cambios, inicia LearnBlock sin --read-only.
server-open-read-only = Abrir '{ $name }' lo copiaría en la carpeta de proyectos. Quita --read-only.

## Answers to a browser

server-incomplete-address-title = Esta dirección está incompleta
server-incomplete-address = La dirección de esta página termina en ?token= y una palabra larga. Para abrirla, ejecuta learnblock otra vez, o usa la dirección completa que LearnBlock mostró al empezar.
server-wrong-address = LearnBlock no acepta esta dirección o esta página. Abre la dirección que LearnBlock mostró; detrás de un proxy, inicia LearnBlock con --allow-host NOMBRE.
server-not-built-title = La página no está construida
server-not-built = Este LearnBlock se ejecuta desde su código fuente, sin una página construida. Construye la página con Node.js y vuelve a cargar:
server-no-picture = No hay ninguna imagen así.

## Messages from a page

server-mistake = Algo ha fallado en LearnBlock: { $reason }
server-no-project = No hay ningún proyecto abierto. Abre antes un proyecto.
server-only-in-class = Esto solo puede enviarlo el servidor de una clase.
server-no-class = Esta página no está en una clase, así que no puedes entregar tu trabajo.
server-too-deep = Esto tiene demasiados niveles, unos dentro de otros.
server-message-too-long = Un mensaje de { $count } caracteres es demasiado largo.
server-message-unknown = LearnBlock no conoce este mensaje: { $reason }
server-text-too-long = Este programa es demasiado largo: el límite es de { $limit } caracteres.
server-too-many-projects = Acabas de crear { $count } proyectos. Espera { $seconds } segundos antes de crear otro.
server-too-many-runs = Se están ejecutando los programas de { $most } proyectos. Detén uno antes.
server-message-broken = Este mensaje tiene demasiados niveles, o no es texto.
server-block-set-file = El archivo '{ $name }' no es un conjunto de bloques. { $problem }
server-world-exists = Ya tienes un mundo '{ $name }'. Elige otro nombre, o guarda otra vez para sustituirlo.

## Programs that may use the network

server-classes-only-here = Las clases están en el ordenador que ejecuta LearnBlock: abre la página allí.
server-network-only-here = Solo se puede cambiar desde una página abierta en el ordenador que ejecuta LearnBlock. Detrás de un proxy, usa settings.toml.
server-network-by-folder = settings.toml permite usar la red a todos los programas de { $folder }.
server-network-in-use = Está en marcha un programa que puede usar la red. Páralo primero.
server-network-ask-again = Esta página no puede cambiar qué programas usan la red. Vuelve a abrir el diálogo.

## Problems in a program

server-more-problems = { $count ->
    [one] Hay un problema más. Aparecerá cuando hayas corregido algunos de estos.
   *[other] Hay { $count } problemas más. Aparecerán cuando hayas corregido algunos de estos.
}

## For contributors: learnblock dev

server-dev-no-watchfiles = learnblock dev necesita un complemento que no está instalado. Instálalo con: { $command }
server-dev-no-checkout = learnblock dev necesita el código fuente de LearnBlock, incluida la carpeta frontend. Para usar la página, ejecuta learnblock.
server-dev-no-node = learnblock dev necesita Node.js { $version } o más nuevo.
server-dev-started = La página, que se recarga sola: { $address }

## Lecciones

server-lesson-file = No se puede leer la lección «{ $name }». { $problem }
server-lesson-name = Una lección no puede llamarse «{ $name }». Cambia el nombre del archivo, con letras, cifras y guiones.
server-lesson-missing = No se puede abrir la lección «{ $name }» de este proyecto. { $problem }
server-lesson-none = Este proyecto no tiene lección.
server-lesson-no-checks = En este paso no hay nada que entregar. Ve a un paso en el que se escriba un programa.
server-lesson-other-robot = Este paso no es para el robot «{ $robot }».
server-lesson-no-hint = No hay más pistas para esta ejecución. Cambia el programa y ejecútalo otra vez.
server-lesson-no-question = Este paso no tiene esa pregunta.
server-lesson-checking = El programa ya se está comprobando. Espera o detén la comprobación.
server-lesson-not-met = No se alcanzó una meta.
server-lesson-too-many = Ya tienes { $limit } lecciones propias. Elimina una antes.
server-lesson-only-here = Solo alguien sentado ante el ordenador que ejecuta LearnBlock puede añadir, cambiar o eliminar lecciones, o ver sus soluciones.
