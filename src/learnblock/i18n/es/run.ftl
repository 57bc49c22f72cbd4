# La ejecución de un programa: cómo termina y por qué.

run-finished = El programa ha terminado.
run-alone = { $program }: { NUMBER($time, minimumFractionDigits: 2) } s, { $distance } mm recorridos, en el mundo { $world }.
run-alone-with-goals = { run-alone } Alcanzado: { $goals }.
run-stopped = El programa se ha detenido.
run-given-up = El programa se ha terminado a la fuerza, pero su robot o su mundo no se han detenido. Si es un robot real, apágalo.
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
run-blocked =
    { $seconds ->
        [one] El programa ha esperado { $seconds } segundo a algo que no es el robot y se ha detenido. Para dejar pasar el tiempo, usa un sleep del robot.
       *[other] El programa ha esperado { $seconds } segundos a algo que no es el robot y se ha detenido. Para dejar pasar el tiempo, usa un sleep del robot.
    }
run-link-closed = El programa ha cerrado su conexión con el robot y se ha detenido.
run-lost = No se ha podido hacer la ejecución, aunque se ha intentado otra vez: { $reason }. La culpa no es del programa.
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

# What Python's errors mean. $meaning is one of the messages below; $error is Python's own message.

run-means =
    { $meaning }
    Python: { $error }
# $type is Python's name of a type.
run-type = { $type ->
    [str] un texto
    [int] un número
    [float] un número
    [bool] True o False
    [list] una lista
    [tuple] varios valores
    [dict] un diccionario
    [function] una función
    [method] una función
    [builtin_function_or_method] una función
    [NoneType] nada (None)
   *[other] { $type }
}
run-means-zero-division = Se ha dividido un número entre 0. Asegúrate de que el número que sigue a '{ $operator }' no sea 0.
run-means-recursion = '{ $function }' se llama a sí misma una y otra vez y no para nunca. Pon la llamada dentro de un 'if' que alguna vez sea falso. Para repetir algo, usa un bucle.
run-means-memory = El programa ha gastado toda su memoria. ¿Crece una lista o un texto en un bucle sin fin?
run-means-overflow = Un número se ha hecho demasiado grande. Revisa la cuenta de esta línea.
run-means-empty = La lista está vacía, así que no se puede sacar nada de ella. Comprueba antes 'len({ $list }) > 0'.
run-means-empty-without = { $function ->
    [max] La lista está vacía, así que no tiene un elemento mayor. Comprueba antes 'len({ $list }) > 0'.
    [min] La lista está vacía, así que no tiene un elemento menor. Comprueba antes 'len({ $list }) > 0'.
    [median] La lista está vacía, así que no tiene mediana. Comprueba antes 'len({ $list }) > 0'.
    [mode] La lista está vacía, así que no tiene moda. Comprueba antes 'len({ $list }) > 0'.
   *[other] La lista está vacía, así que no tiene media. Comprueba antes 'len({ $list }) > 0'.
}
run-means-two-items = La lista tiene menos de 2 elementos, y para esto son muy pocos. Comprueba antes 'len({ $list }) > 1'.
run-means-index = No hay ningún elemento en esa posición. Las posiciones van de 0 a la longitud menos uno; '[-1]' es el último elemento.
run-means-picture = Una imagen no es ni verdadera ni falsa: no puede ser una condición ni compararse con '==' o '!='. Pregunta qué hay en ella, como 'is_any_tag()'. En Python, 'is not None' dice si hay una imagen.
run-means-key = No hay ninguna entrada { $key }. Revisa cómo se escribe, o añádela antes.
run-means-module = No hay ningún módulo '{ $module }'. Revisa su nombre, o pon su archivo junto al programa.
run-means-file = No hay ningún archivo { $file }. Revisa su nombre y su carpeta.
run-means-local = '{ $name }' se usa en esta función antes de darle un valor. Dale uno más arriba.
run-means-global = Dentro de '{ $function }', Python cree que '{ $name }' es una variable nueva. Escribe 'global { $name }' en la primera línea de '{ $function }'.
run-means-name = '{ $name }' no tiene valor todavía. Dale uno más arriba, o revisa cómo se escribe.
run-means-name-near = '{ $name }' no tiene valor. ¿Querías decir '{ $near }'?
run-means-attribute-of-nothing = Delante de '.{ $name }' no hay ningún valor, solo None. Guárdalo en una variable y comprueba antes de esta línea que no sea None.
run-means-attribute-of-nothing-in-variable = '{ $variable }' no tiene valor (None), así que no tiene '.{ $name }'. Compruébalo antes: 'if { $variable } != None:'.
run-means-attribute-of-text = Un texto no tiene '{ $name }', solo las listas. Une los textos con '+': '"a" + "b"'.
run-means-skill = El robot no tiene la habilidad '{ $name }'. Revisa cómo se escribe.
run-means-attribute = '{ $name }' no existe para { $type }. Revisa cómo se escribe y el valor que hay delante del punto.
run-means-attribute-near = Después de este punto no hay ningún '{ $name }'. ¿Querías decir '{ $near }'?
run-means-attribute-of-module = El módulo '{ $module }' no tiene '{ $name }'. Revisa cómo se escribe.
run-means-join = A un texto solo se le puede sumar otro texto, no { $type }. Pon 'str(...)' alrededor del otro valor.
run-means-join-number = A un texto solo se le puede sumar otro texto, no un número. Pon 'str(...)' alrededor del número.
run-means-join-list = A una lista solo se le puede sumar otra lista, no { $type }. Usa 'append' para añadir un elemento.
run-means-nothing = Un lado de '{ $operator }' no tiene valor (None): un sensor no ha respondido, o a una función le falta 'return'. Guárdalo en una variable y comprueba antes de esta línea que no sea None.
run-means-nothing-in-variable = '{ $variable }' no tiene valor (None): un sensor no ha respondido, o a una función le falta 'return'. Compruébalo antes: 'if { $variable } != None:'.
run-means-operands = '{ $operator }' no funciona con { $type } y { $other_type }. Usa un número a cada lado.
run-means-calculation = '{ $operator }' no puede calcular con un texto. Pon 'int(...)' alrededor del texto, o 'float(...)' si lleva un punto decimal.
run-means-comparison = '{ $operator }' no puede comparar { $type } con { $other_type }. Compara dos números o dos textos.
run-means-comparison-with-text = '{ $operator }' no puede comparar un texto con un número. Pon 'int(...)' alrededor del texto, o 'float(...)' si lleva un punto decimal.
run-means-multiply = Un texto o una lista solo se puede multiplicar por un número entero. Pon 'int(...)' alrededor del otro valor.
run-means-multiply-by-other = Un texto o una lista no se puede multiplicar por { $type }. Un lado de '*' tiene que ser un número entero, como en '"a" * 3'.
run-means-whole-number = Aquí hace falta un número entero, no { $type }. Pon 'int(...)' alrededor.
run-means-number = Aquí hace falta un número, no { $type }. Pon 'float(...)' alrededor.
run-means-call = Esto es { $type }, no una función a la que llamar. Quita los paréntesis que siguen, o cambia el nombre de la variable.
run-means-items = Esto es { $type }, así que no tiene elementos. Usa una lista o un texto antes de '['.
run-means-iteration = Un bucle necesita una lista o un texto, no { $type }. Pon 'range(...)' alrededor de un número.
run-means-length = 'len' necesita una lista o un texto, no { $type }. Pon uno de los dos entre los paréntesis.
run-means-length-of-number = 'len' necesita una lista o un texto, no un número. Escribe 'len(str(...))' para contar sus cifras.
run-means-position = Una posición es un número entero que se cuenta desde 0. Pon 'int(...)' alrededor.
run-means-position-in-quotes = La posición entre '[...]' es un texto. Escríbela sin comillas, o pon 'int(...)' alrededor.
run-means-item-assignment = No se puede cambiar una parte de { $type }. Crea un valor nuevo.
run-means-letter-assignment = No se puede cambiar una letra de un texto. Crea un texto nuevo, como 'name = "a" + "na"'.
run-means-missing-argument = A '{ $function }' le faltan valores: { $names }. Escríbelos entre los paréntesis.
run-means-too-many-arguments = { $excess ->
    [one] '{ $function }' ha recibido 1 valor de más. Quita 1 de los paréntesis.
   *[other] '{ $function }' ha recibido { $excess } valores de más. Quita { $excess } de los paréntesis.
}
run-means-unknown-argument = '{ $function }' no tiene ningún argumento '{ $name }'. Revisa cómo se escribe.
run-means-unknown-argument-of = '{ $function }' no tiene ningún argumento '{ $name }'. Sus argumentos son: { $known }.
run-means-no-arguments = '{ $function }' no tiene argumentos. Escribe '{ $function }()', sin nada entre los paréntesis.
run-means-int = { $text } no es un número entero, y 'int' no puede leerlo. Revisa el texto, o lo que se ha escrito al preguntar.
run-means-int-of-decimal = { $text } no es un número entero, y 'int' no puede leerlo. Escribe 'float(...)' para los números con punto decimal.
run-means-float = { $text } no es un número, y 'float' no puede leerlo. Revisa el texto, y usa un punto en lugar de una coma.
run-means-domain = Esto no se puede calcular con el número que hay entre los paréntesis. Míralo con un 'print' encima de esta línea.
run-means-root = Un número negativo no tiene raíz cuadrada. Asegúrate de que el número entre los paréntesis sea 0 o más.
run-means-logarithm = Ni 0 ni los números negativos tienen logaritmo. Asegúrate de que el número entre los paréntesis sea mayor que 0.
run-means-range = El primer número es mayor que el último. Cámbialos de orden.
run-means-not-in-list = La lista no contiene ese valor. Compruébalo antes con 'in'.
run-means-not-in-this-list = La lista no contiene ese valor. Compruébalo antes: 'if { $value } in { $list }:'.
run-means-separator = 'split' necesita el texto por el que cortar, como ",". Pon 'list(...)' alrededor de un texto para sacar sus letras.
run-means-unpack = No hay tantas variables como valores para ellas.
run-means-unpack-few = { $after ->
    [one] Hay { $before } variables, pero solo 1 valor para ellas. Escribe un valor para cada variable.
   *[other] Hay { $before } variables, pero solo { $after } valores para ellas. Escribe un valor para cada variable.
}
run-means-unpack-many = Hay solo { $before } variables, pero más valores para ellas. Escribe una variable para cada valor.
run-means-unpack-single = Esto es { $type }, que no se puede repartir entre varias variables. Usa una lista con un valor para cada una.

# $type y $failed son nombres de errores de Python.
run-error-without-text = El error { $type } no tiene un mensaje legible: su __str__ ha fallado con { $failed }.
run-second-robot = Un programa solo puede tener un robot a la vez. Quita el segundo Robot().
run-inline-thread = Un hilo del programa ha usado el robot. Aquí solo puede hacerlo el propio programa: llama a las funciones del robot fuera del hilo.
run-input-ended = El programa ha pedido un texto, pero ya no queda ninguno.
# $event es el nombre que Python da a lo que se intentó, como os.fork.
run-no-processes = Un programa de robot no puede iniciar ni detener otros programas ({ $event }).
# $event es el nombre que Python da a lo que se intentó, como socket.connect.
run-no-network = Un programa de robot no puede usar la red ({ $event }). Si la necesita, ejecútalo con learnblock run --allow-network.
# $file es el nombre del archivo.
run-no-access = Sin acceso a { $file }. Un programa de robot puede leer los archivos de su proyecto y escribir solo en su carpeta temporal.
# $reason es el mensaje del sistema operativo.
run-not-contained = El programa no se ha iniciado porque no se ha podido aislar: { $reason }. Ejecuta learnblock doctor.
# $megabytes es un número.
run-too-much-disk = El programa ha escrito más de { $megabytes } MB en su carpeta temporal.
# $limit es un número.
run-too-many-files = El programa ha creado más de { $limit } archivos.
# $limit es un número.
run-too-many-threads = El programa ha iniciado más de { $limit } hilos.
run-variable-uses-robot = El __str__ de una variable no puede usar el robot ni escribir.
# $reason es el mensaje de Python.
run-value-not-sendable = No se puede enviar un valor al robot: { $reason }.
# $size y $limit son números de bytes.
run-value-too-large = Un valor de { $size } bytes es demasiado grande para enviarlo al robot: el límite es de { $limit } bytes.
run-not-a-trace = Esto no es la traza de una ejecución con robots simulados.
run-no-program-file = LEARNBLOCK_TRACE solo puede registrar un programa que se ejecuta desde un archivo, y este no es el caso.

# Fallos del robot. $reason es una frase o el mensaje de un error ajeno.

run-robot-not-created = No se ha podido crear el robot. { $reason }
run-driver-refused = El ordenador lo ha impedido ({ $reason }). Si el controlador del robot lo necesita, su autor lo añade a sus 'rights'.
run-robot-not-stopped = No se ha podido detener el robot. { $reason }
# $function es una función de un dispositivo, como move o read.
run-call-failed = El robot no ha podido hacer '{ $function }'. { $reason }
run-robot-stopped = El robot se ha detenido y ya no acepta órdenes.
# $device es un tipo de dispositivo; $known es la lista de los tipos que hay.
run-unknown-device = El robot tiene un dispositivo de tipo { $device }, que los programas no pueden usar. Tipos conocidos: { $known }.
run-not-a-message = Un mensaje entre el programa y el robot no tiene sentido: { $reason }. Usa el robot solo con sus habilidades y dispositivos.
run-no-debugger = Esta ejecución no se puede pausar porque se inició sin depurador.

# El archivo de un programa.

run-unknown-file-type = LearnBlock solo puede ejecutar archivos .bt (Block-Text), .py (Python) y .learnblock (proyectos).
# $byte es un número como 0xe9.
run-not-utf-8 = El byte { $byte } no es UTF-8. Guarda el archivo como UTF-8.
