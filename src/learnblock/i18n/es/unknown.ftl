# Nombres que no existen: de robots, mundos, habilidades, ajustes, etc.
# $kind es un nombre corto de lo que se buscaba; $name es el nombre desconocido.

unknown-name =
    No hay { $kind ->
        [behaviour] ningún comportamiento
        [block] ningún bloque propio
        [block-set] ningún conjunto de bloques
        [button] ningún botón
        [camera] ninguna cámara
        [check] ninguna comprobación
        [colour] ningún color
        [component] ningún componente
        [connection] ninguna conexión
        [deleted-block] ningún bloque borrado
        [detector] ningún detector
        [device] ningún dispositivo
        [device-function] ninguna función de dispositivo
        [direction] ninguna dirección
        [emotion] ninguna emoción
        [emulator] ningún emulador
        [event] ningún evento
        [example] ningún ejemplo
        [function] ninguna función
        [goal] ningún objetivo
        [hint] ninguna pista
        [joint] ninguna articulación
        [key] ninguna tecla
        [led] ningún LED
        [lesson] ninguna lección
        [lesson-aim] ningún objetivo
        [lesson-step] ningún paso
        [library] ninguna biblioteca
        [door] ninguna puerta
        [light-object] ningún objeto con masa
        [line] ninguna línea
        [note] ninguna nota
        [project] ningún proyecto
        [robot] ningún robot
        [setting] ningún ajuste
        [simulated-robot] ningún robot simulado
        [skill] ninguna habilidad
        [start-pose] ninguna posición inicial
        [tag] ninguna etiqueta
        [team] ningún equipo
        [thing] ningún objeto
        [variable] ninguna variable
        [version] ninguna versión
        [world] ningún mundo
       *[other] nada llamado
    } '{ $name }'.
# $known es la lista de los nombres que existen.
unknown-name-of =
    { unknown-name } Nombres conocidos: { $known }.
# $suggestion es el nombre existente más parecido.
unknown-name-like =
    { unknown-name } ¿Querías decir '{ $suggestion }'?
