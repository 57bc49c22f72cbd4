# El registro de una ejecución.

log-not-a-log = Esto no es el registro de una ejecución, o está dañado.
log-not-a-file = { $file } no es el registro de una ejecución. Escribe uno con: learnblock run PROGRAMA --why ARCHIVO
log-too-large = { $file } es demasiado grande: un registro tiene { $most } MiB como máximo.
log-no-world = Esta ejecución no tuvo un mundo simulado: solo se puede mostrar lo que se registró.
log-too-long = Esta ejecución es demasiado larga para volver a mostrarla: el límite es { $most } s.
log-file-too-large = Este registro es demasiado grande para abrirlo: un archivo tiene como máximo { $most } MiB.
log-takes-too-long = Mostrar el mundo de esta ejecución llevaría más de { $most } s.
