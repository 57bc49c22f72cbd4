# La ejecución de un programa: cómo termina y por qué.

run-finished = El programa ha terminado.
run-stopped = El programa se ha detenido.
run-stopped-by-signal = El sistema operativo ha detenido el programa.
run-time-limit =
    { $seconds ->
        [one] Se acabó el tiempo: el límite era de { $seconds } segundo.
       *[other] Se acabó el tiempo: el límite era de { $seconds } segundos.
    }
run-too-much-output = El programa ha escrito más de { $megabytes } MB y se ha detenido. ¿Hay un bucle que escribe sin esperar?
run-no-robot =
    { $seconds ->
        [one] El programa no ha creado su robot en { $seconds } segundo y se ha detenido. ¿Llega alguna vez a la línea con Robot()?
       *[other] El programa no ha creado su robot en { $seconds } segundos y se ha detenido. ¿Llega alguna vez a la línea con Robot()?
    }
run-no-call =
    { $seconds ->
        [one] El programa no ha enviado órdenes al robot durante { $seconds } segundo y se ha detenido. ¿Falta un sleep en algún bucle?
       *[other] El programa no ha enviado órdenes al robot durante { $seconds } segundos y se ha detenido. ¿Falta un sleep en algún bucle?
    }
run-link-closed = El programa ha cerrado su conexión con el robot y se ha detenido.
# $status es el estado de salida del proceso.
run-process-ended = El proceso del programa ha terminado de forma inesperada con el estado { $status }.
run-processor-time =
    { $seconds ->
        [one] El programa ha usado más de { $seconds } segundo de procesador y se ha detenido.
       *[other] El programa ha usado más de { $seconds } segundos de procesador y se ha detenido.
    }
# $signal es un nombre como SIGKILL.
run-killed = El sistema operativo ha terminado el programa con la señal { $signal }.

# Errores en un programa.

# $error es el mensaje de Python, por ejemplo: NameError: name 'robt' is not defined
run-did-you-mean = { $error }. ¿Querías decir '{ $suggestion }'?
# $type y $failed son nombres de errores de Python.
run-error-without-text = El error { $type } no tiene un mensaje legible: su __str__ ha fallado con { $failed }.
run-second-robot = Un programa solo puede tener un robot a la vez. Quita el segundo Robot().
run-input-ended = El programa ha pedido un texto, pero ya no queda ninguno.
# $event es el nombre que Python da a lo que se intentó, como os.fork.
run-no-processes = Un programa de robot no puede iniciar ni detener otros programas ({ $event }).
run-variable-uses-robot = El __str__ de una variable no puede usar el robot ni escribir.
# $reason es el mensaje de Python.
run-value-not-sendable = No se puede enviar un valor al robot: { $reason }.
# $size y $limit son números de bytes.
run-value-too-large = Un valor de { $size } bytes es demasiado grande para enviarlo al robot: el límite es de { $limit } bytes.
run-no-program-file = LEARNBLOCK_TRACE registra un programa que se ejecuta desde un archivo, pero no se está ejecutando ninguno.

# Fallos del robot. $reason es una frase o el mensaje de un error ajeno.

run-robot-not-created = No se ha podido crear el robot. { $reason }
run-robot-not-stopped = No se ha podido detener el robot. { $reason }
# $function es una función de un dispositivo, como move o read.
run-call-failed = El robot no ha podido hacer '{ $function }'. { $reason }
run-robot-stopped = El robot se ha detenido y ya no acepta órdenes.
# $device es un tipo de dispositivo; $known es la lista de los tipos que hay.
run-unknown-device = El robot tiene un dispositivo de tipo { $device }, que los programas no pueden usar. Tipos conocidos: { $known }.
run-message-too-long = Un mensaje de { $size } bytes entre el robot y el programa es demasiado largo.
run-not-a-message = Un mensaje entre el robot y el programa está dañado: { $reason }.
run-no-debugger = Esta ejecución no se puede pausar porque se inició sin depurador.

# El archivo de un programa.

run-unknown-file-type = LearnBlock solo puede ejecutar archivos .bt (Block-Text) y .py (Python).
# $byte es un número como 0xe9.
run-not-utf-8 = El byte { $byte } no es UTF-8. Guarda el archivo como UTF-8.
