# La salida de la línea de órdenes.

cli-file-error = { $file }: { $reason }
cli-system-error = { $reason }
cli-no-file = No existe el archivo { $file }.
cli-wrote = Escrito: { $file }
cli-stop-with-ctrl-c = Pulsa Ctrl-C para terminar.

cli-default = por defecto: { $value }
cli-default-without-value = --default lleva el nombre de un ajuste, sin ningún valor.
cli-value-or-default = Indica un valor o --default, pero no los dos.

cli-formatted = Con formato: { $file }
cli-would-change = Cambiaría { $file }
cli-format-only-block-text = { $file } no es un archivo de Block-Text (.bt). Para archivos de Python usa un formateador de Python.

cli-devices-by-settings = (depende de sus ajustes)
cli-robot-scan-late = El controlador de '{ $robot }' no deja de buscar robots, así que se ha omitido.
cli-robot-without-settings = El robot '{ $robot }' no tiene ajustes: es simulado.
cli-robot-needs-add-on = necesita un complemento que no está instalado: { $command }
cli-no-robot-found = Ningún robot ha respondido. ¿Está encendido, y este ordenador en su red?
cli-device-works = funciona
cli-device-fails = FALLA
cli-device-skipped = omitido
cli-emulating = Emulando { $robot }. Conecta un programa con:

cli-skill-block = {"  "}Bloque: { $label }
cli-skill-returns = {"  "}Devuelve: { $kind ->
    [value] un valor
   *[nothing] nada
}
cli-skill-needs = {"  "}Necesita: { $devices }
cli-skill-needs-nothing = {"  "}Necesita: ningún dispositivo
cli-one-or-all-robots = Elige '--robot' o '--all-robots'.
# $devices: noun phrases from check-device
cli-served-by = { $devices }
cli-served-by-nothing = no tiene { $devices }
cli-served-by-no-robot = Ningún robot de LearnBlock tiene esto. Uno tuyo puede tenerlo: consulta docs/add-a-robot.md.

cli-blocks-none = Aún no tienes bloques propios. Haz uno en la página, o escribe: learnblock blocks import ARCHIVO

cli-library-broken = dañada: { $problem }
cli-library-none = No hay bibliotecas instaladas. Instala una con: learnblock library import ARCHIVO
cli-library-imported = Importada: { $name } { $version }: { $skills }
cli-library-unchanged = Ya instalada: { $name } { $version }: { $skills }
cli-library-removed = Quitada: { $name }
cli-library-rename-unknown = --rename { $skill }: ninguna de estas bibliotecas tiene esa habilidad.
cli-library-rename-format = --rename { $given }: escribe HABILIDAD=NUEVA, por ejemplo waltz=ball_waltz.
cli-library-exists = { $path } ya existe. Añade --replace o elige otro --name.
cli-library-other-folder = { $path } es una carpeta que no es una biblioteca. Elige otro --name.

cli-tags-imported = { $count ->
    [one] Importado un nombre de etiqueta de { $file }
   *[other] Importados { $count } nombres de etiquetas de { $file }
}
cli-tags-print = Abre { $file } en un navegador e imprímelo al 100 %.

cli-new-next = Ahora:
cli-new-robot-test = La prueba muestra las funciones que aún tienes que escribir y qué debe hacer cada una.
cli-new-skill = Ahora cambia lo que hace la habilidad. En Block-Text es { $call }.

cli-no-problems = { $file }: sin problemas

cli-emotions-question = ¿Activarlo para todas las cámaras reales?

cli-take-over-or-read-only = Usa --take-over o --read-only, pero no las dos.
cli-folder-choices =
    {"  "}1  Tomar el control: el otro LearnBlock lo guarda todo y termina.
    {"  "}2  Solo lectura: aquí se abren y ejecutan proyectos; los cambios no se guardan.
cli-folder-choice = 1 o 2 (Ctrl-C para salir)
