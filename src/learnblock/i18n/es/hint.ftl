# Pistas para un programa que no cumple las comprobaciones de una lección. De cada una: qué mirar, qué
# parte, cómo en general y, para el profesor, por qué se ha elegido. Ninguna puede decir qué escribir.

hint-where-line = la línea { $line }
hint-where-lines = las líneas { $lines }
hint-a-loop = un bucle
hint-a-sensor = un sensor
hint-a-line-sensor = un sensor que ve líneas
hint-a-distance-sensor = un sensor que ve lo que hay delante
hint-the-other-side = el sensor del otro lado
hint-no-reason = No se cumple una comprobación.

# $message: of the error
hint-error-look = Un error ha terminado tu programa: { $message }
hint-error-part = Ha ocurrido en { $where }. ¿Qué tienen de especial los valores en ese momento?
hint-error-how = Lee el mensaje despacio: dice qué es lo que no se pudo hacer. Después vuelve atrás, paso a paso, hasta donde salió ese valor.
hint-error-because = La ejecución terminó con un error.

hint-empty-look = Tu programa todavía no tiene órdenes, así que el robot no hace nada.
hint-empty-part = Mira { $where }.
hint-empty-how = Cuenta la tarea con tus palabras, una pequeña acción tras otra. Cada acción será un bloque.
hint-empty-because = El programa no tiene ninguna instrucción que haga algo.

hint-empty-body-look = Uno de tus bloques está vacío por dentro.
hint-empty-body-part = Mira { $where }: ¿qué debería pasar ahí?
hint-empty-body-how = Un bucle, una condición o una función solo hace lo que se pone dentro.
hint-empty-body-because = Un bloque con cuerpo no tiene nada dentro.

# $name: of the event
hint-never-started-look = Una parte de tu programa no empieza nunca.
hint-never-started-part = Mira { $where }: ¿qué hace que empiece "{ $name }"?
hint-never-started-how = Un evento sin condición duerme hasta que otra parte del programa lo despierta.
hint-never-started-because = El evento "{ $name }" no tiene condición y nada lo activa.

# $name: of the function
hint-not-called-look = Has hecho una función, pero el robot no la hace nunca.
hint-not-called-part = Mira { $where }: ¿quién usa "{ $name }"?
hint-not-called-how = Definir una función solo le enseña al robot una palabra nueva. Actúa cuando el programa dice esa palabra.
hint-not-called-because = La función "{ $name }" está definida y no se llama nunca.

hint-unreachable-look = El robot no llega nunca a la última parte de tu programa.
hint-unreachable-part = Mira { $where }: ¿cómo pasa el programa de una a otra?
hint-unreachable-how = A lo que viene después de un bucle que se repite siempre no se llega nunca. Un bucle también puede acabar cuando algo se cumple.
hint-unreachable-because = Hay instrucciones después de un bucle del que no se puede salir.

# $name: of the message
hint-message-name-look = Tu robot espera un mensaje que no llega nunca.
hint-message-name-part = Mira { $where }: ¿alguien envía "{ $name }"?
hint-message-name-how = Quien envía y quien recibe tienen que usar exactamente el mismo nombre de mensaje.
hint-message-name-because = El programa preguntó por el mensaje "{ $name }", que ningún robot envió.

hint-text-almost-look = Un texto está casi bien. Compáralo letra a letra con la tarea.
hint-text-almost-part = Sale de { $where }.
hint-text-almost-how = Un ordenador compara los textos exactamente: cuentan cada letra, cada espacio y cada signo.
hint-text-almost-because = Un texto de la ejecución se parece mucho al que pide la comprobación.

hint-no-wait-look = Una orden acaba antes de que puedas verla. Ejecuta el programa despacio y mira.
hint-no-wait-part = Mira { $where }: ¿cuánto tiempo pasa después de esa orden?
hint-no-wait-how = Algunas órdenes solo ponen algo en marcha, y la siguiente toma el relevo enseguida. El robot necesita tiempo entre medias.
hint-no-wait-because = Una orden fue sustituida, o el programa acabó, antes de que pasara tiempo.

hint-repetition-look = Tu programa hace lo mismo varias veces seguidas.
hint-repetition-part = Compara lo que empieza en { $where }.
hint-repetition-how = Lo que se repite una y otra vez se escribe una sola vez, dentro de un bucle.
hint-repetition-because = El programa es demasiado grande y tiene instrucciones iguales seguidas.

hint-too-large-look = Tu programa es más largo de lo necesario.
hint-too-large-part = Mira { $where }.
hint-too-large-how = Busca partes que se parezcan o que no cambien nada: un bucle o una función puede ocupar su lugar.
hint-too-large-because = El programa tiene más bloques de los que permite la comprobación.

# $joined: and, or
hint-impossible-condition-look = Una de tus condiciones da siempre la misma respuesta.
hint-impossible-condition-part = Mira { $where } y prueba algunos números: ¿cuándo es verdad y cuándo no?
hint-impossible-condition-how = Con "y" se tienen que cumplir las dos partes a la vez. Con "o" basta una.
hint-impossible-condition-because = Dos comparaciones unidas por "{ $joined }" no pueden cumplirse a la vez, o una se cumple siempre.

hint-wrong-side-look = Mira qué hace el robot cuando ve algo en un lado.
hint-wrong-side-part = Mira { $where }: ¿hacia qué lado gira ahí el robot y hacia cuál debería?
hint-wrong-side-how = Un robot gira hacia una línea para no salirse, y se aparta de un obstáculo para esquivarlo.
hint-wrong-side-because = A un sensor de un lado se responde con un giro al lado equivocado.

# $name: of the variable
hint-unchanged-variable-look = Un bucle espera un valor que no cambia.
hint-unchanged-variable-part = Mira el bucle de { $where }: ¿dónde cambia "{ $name }"?
hint-unchanged-variable-how = Un bucle con condición solo acaba si algo dentro de él cambia lo que pregunta la condición.
hint-unchanged-variable-because = Nada dentro del bucle cambia la variable "{ $name }" de su condición.

# $what: such as "the skill turn", from the words of checks
hint-used-too-often-look = Tu programa usa algo más veces de lo que permite la tarea: { $what }.
hint-used-too-often-part = Mira { $where }.
hint-used-too-often-how = ¿Podría uno hacer el trabajo de los demás, en un bucle o en una función?
hint-used-too-often-because = La comprobación permite menos: { $what }.

hint-not-used-look = La tarea pide algo que tu programa todavía no tiene: { $what }.
hint-not-used-part = Mira { $where }.
hint-not-used-how = Lee otra vez la tarea: dice para qué sirve esta parte. En la paleta hay un bloque para ella.
hint-not-used-because = La comprobación lo pide y el programa no tiene o tiene demasiado pocos: { $what }.

hint-no-loop-look = ¿Hace tu programa algo una y otra vez? Piensa en: { $what }.
hint-no-loop-part = Compara lo que empieza en { $where }: es lo mismo.
hint-no-loop-how = Lo que pasa más de una vez va en un bucle: un número de veces, mientras algo se cumpla o siempre.
hint-no-loop-because = El programa se repite, o la comprobación pide un bucle, y no hay ninguno.

hint-checked-once-look = El robot mira una sola vez, justo al principio.
hint-checked-once-part = Mira { $where }: ¿cuándo se hace esta pregunta y cuántas veces?
hint-checked-once-how = Una pregunta se responde en el momento en que se hace. Para notar algo más tarde, el robot tiene que preguntar una y otra vez.
hint-checked-once-because = Un "si" pregunta a un sensor fuera de cualquier bucle.

hint-loop-without-wait-look = Uno de tus bucles acaba en un instante.
hint-loop-without-wait-part = Mira el bucle de { $where }: ¿cuánto dura una vuelta?
hint-loop-without-wait-how = Un bucle que no espera da vueltas tan rápido como puede el ordenador, y el robot solo ve la última orden.
hint-loop-without-wait-because = Un bucle mueve el robot y dentro de él no pasa tiempo.

hint-never-ends-look = Tu programa no acaba nunca por sí mismo.
hint-never-ends-part = Mira el bucle de { $where }: ¿qué lo haría parar?
hint-never-ends-how = Pregúntate cuándo está hecha la tarea y cómo puede notarlo el robot. El bucle solo debería seguir hasta entonces.
hint-never-ends-because = El programa siguió hasta que se acabó su tiempo.

hint-opposite-condition-look = Puede que una de tus preguntas esté al revés.
hint-opposite-condition-part = Mira { $where }: di la frase en voz alta. ¿Qué hace el robot cuando la respuesta es sí?
hint-opposite-condition-how = "Mientras" sigue tanto tiempo como la respuesta sea sí; "esperar hasta" sigue en cuanto es sí. "No" da la vuelta a la respuesta.
hint-opposite-condition-because = Una condición se acaba enseguida, o responde a un obstáculo siguiendo adelante.

hint-motors-on-look = Mira el robot cuando ha acabado su tarea: ¿siguen girando sus ruedas?
hint-motors-on-part = Mira { $where }: ¿qué acaba este movimiento?
hint-motors-on-how = Una orden de avanzar sigue hasta la siguiente. A un robot que debe quedarse quieto hay que decírselo.
hint-motors-on-because = La última orden a las ruedas seguía cuando acabó la ejecución.

hint-other-robot-look = Tu programa funciona en un robot, pero no en este.
hint-other-robot-part = Mira los números de { $where }: ¿valen para todos los robots?
hint-other-robot-how = Los robots se distinguen en tamaño, velocidad y sensores. Un programa que pregunta a los sensores, o que da una distancia en vez de un tiempo, sirve para más robots.
hint-other-robot-because = En el robot habitual se cumplen todas las comprobaciones.

hint-wrong-order-look = Pasa todo, pero no en este orden. Cuenta otra vez la historia de la tarea.
hint-wrong-order-part = Mira { $where }: ¿qué va primero?
hint-wrong-order-how = Un programa hace una cosa tras otra, de arriba abajo.
hint-wrong-order-because = Pasó todo lo que pide la comprobación, en otro orden.

hint-wrong-sign-look = Mira en qué dirección avanza el robot.
hint-wrong-sign-part = El movimiento de { $where } va en sentido contrario.
hint-wrong-sign-how = El signo de un número da la dirección: un número por debajo de cero significa hacia atrás.
hint-wrong-sign-because = Con este movimiento al revés, el robot habría llegado al sitio correcto.

hint-wrong-direction-look = Ponte detrás del robot y mira: ¿hacia qué lado gira?
hint-wrong-direction-part = El giro de { $where } va hacia el otro lado.
hint-wrong-direction-how = La izquierda y la derecha son las del robot, no las tuyas. Con un ángulo, el signo da el lado.
hint-wrong-direction-because = Con este giro hacia el otro lado, el robot habría llegado al sitio correcto.

# $what: what is missing, such as "a sensor"
hint-never-asks-look = ¿Mira el robot por dónde va? Hay algo que no se pregunta nunca: { $what }.
hint-never-asks-part = Mira { $where }: ¿cómo podría saber el robot en ese momento que hay algo ahí?
hint-never-asks-how = Un robot solo nota lo que su programa pregunta a los sensores.
hint-never-asks-because = La ejecución no preguntó nunca lo que necesitaba: { $what }.

hint-only-here-look = Tu programa funciona en un mundo y falla cuando el mundo es un poco distinto.
hint-only-here-part = Mira los números de { $where }: ¿y si el camino es más largo o más corto?
hint-only-here-how = Contar el tiempo o la distancia solo vale donde no cambia nada. Un sensor dice lo que hay de verdad.
hint-only-here-because = Se cumplen todas las comprobaciones en el mundo tal como está dibujado, pero no en una variante.

hint-never-runs-look = Una parte de tu programa no se ha ejecutado nunca.
hint-never-runs-part = Es la parte que empieza en { $where }. ¿Qué tiene que cumplirse para que el robot llegue ahí? ¿Se ha cumplido alguna vez?
hint-never-runs-how = Mira los valores que compara una condición mientras se ejecuta el programa. ¿Es el número o el nombre correcto?
hint-never-runs-because = Estas instrucciones no se ejecutaron, aunque el programa sí.

# $thing: what was hit; $time: seconds
hint-collision-look = El robot ha chocado con algo ({ $thing }) a los { $time } s. Mira otra vez ese momento.
hint-collision-part = Se movía por { $where }.
hint-collision-how = Piensa en cuánto necesita el robot para parar o girar: tiene que reaccionar con tiempo.
hint-collision-because = El robot chocó con "{ $thing }" a los { $time } s.

hint-forbidden-look = Pasa algo que la tarea no quiere. Lee otra vez las metas.
hint-forbidden-part = Sale de { $where }.
hint-forbidden-how = Busca el momento de la ejecución en que pasa, y qué hacía el programa justo entonces.
hint-forbidden-because = Pasó algo que no debe pasar nunca.

hint-never-stands-look = El robot debería quedarse quieto un rato. ¿Lo hace?
hint-never-stands-part = Mira { $where }.
hint-never-stands-how = Para quedarse quieto hacen falta dos cosas: ruedas que paran y tiempo que pasa antes de la orden siguiente.
hint-never-stands-because = El robot no estuvo quieto tanto tiempo como pide la comprobación.

# $kind: print, say, show
hint-wrong-text-look = { $kind ->
    [print] Compara lo que escribe tu programa con lo que pide la tarea.
    [say] Compara lo que dice el robot con lo que pide la tarea.
   *[show] Compara lo que muestra el robot con lo que pide la tarea.
}
hint-wrong-text-part = Mira { $where }.
hint-wrong-text-how = Si hay un valor dentro, sigue ese valor hacia atrás: ¿dónde se puso y dónde cambió?
hint-wrong-text-because = Se escribió, dijo o mostró algo, pero no lo que pide la comprobación.

hint-not-shown-look = { $kind ->
    [print] Tu programa no escribe nada, y la tarea pide un texto.
    [say] El robot no dice nada, y la tarea pide palabras.
   *[show] El robot no muestra nada, y la tarea lo pide.
}
hint-not-shown-part = Mira { $where }.
hint-not-shown-how = Solo se ve lo que un programa muestra, dice o escribe. ¿Qué bloque lo hace visible y cuándo debería ejecutarse?
hint-not-shown-because = No se escribió, dijo ni mostró nada.

hint-event-missing-look = Algo que pide la tarea no pasa nunca.
hint-event-missing-part = Mira { $where }.
hint-event-missing-how = Repasa las metas una a una y busca el bloque que hace que se cumpla cada una.
hint-event-missing-because = No se llamó nunca a una habilidad, o no se envió nunca un mensaje.

hint-no-turn-look = Compara el camino del robot con la tarea: ¿hay una esquina donde debería girar?
hint-no-turn-part = Mira antes de { $where }: ¿hacia dónde mira ahí el robot?
hint-no-turn-how = Recorre tú el camino. Cuenta los tramos rectos y los giros que hay entre ellos.
hint-no-turn-because = El robot siguió recto donde su camino tiene una esquina.

hint-too-few-times-look = Cuenta: ¿cuántas veces pasa y cuántas debería pasar?
hint-too-few-times-part = Mira el bucle de { $where }: ¿cuántas vueltas da?
hint-too-few-times-how = Cuenta las vueltas con los dedos, con la primera y la última.
hint-too-few-times-because = Pasó menos veces de las debidas.

hint-too-many-times-look = Cuenta: ¿cuántas veces pasa y cuántas debería pasar?
hint-too-many-times-part = Mira el bucle de { $where }: ¿cuántas vueltas da?
hint-too-many-times-how = Cuenta las vueltas con los dedos, con la primera y la última.
hint-too-many-times-because = Pasó más veces de las debidas.

hint-value-too-small-look = Compara dónde está el robot con dónde debería estar: algo se queda corto.
hint-value-too-small-part = Mira el número de { $where }.
hint-value-too-small-how = Un número en un bloque es una medida: cuánto, cuánto tiempo, cómo de rápido o cómo de cerca. Cambia un número cada vez y mira qué pasa.
hint-value-too-small-because = Con un número mayor ahí, el robot habría llegado al sitio correcto.

hint-value-too-large-look = Compara dónde está el robot con dónde debería estar: algo es demasiado.
hint-value-too-large-part = Mira el número de { $where }.
hint-value-too-large-how = Un número en un bloque es una medida: cuánto, cuánto tiempo, cómo de rápido o cómo de cerca. Cambia un número cada vez y mira qué pasa.
hint-value-too-large-because = Con un número menor ahí, el robot habría llegado al sitio correcto.

hint-lost-line-look = Mira el sitio donde el robot se sale de la línea. ¿Qué vio justo antes?
hint-lost-line-part = Mira { $where }.
hint-lost-line-how = Para cada manera en que la línea puede estar bajo el robot, decide qué debe hacer, también cuando no ve ninguna línea.
hint-lost-line-because = El programa pregunta por la línea y el robot la pierde.

hint-never-moved-look = El robot no se mueve nada.
hint-never-moved-part = Mira { $where }.
hint-never-moved-how = ¿Qué bloque hace girar las ruedas? ¿Llega ahí el programa y dura algún tiempo?
hint-never-moved-because = El robot se quedó donde estaba.

hint-too-early-look = Tu programa acaba antes de que esté todo hecho.
hint-too-early-part = Mira { $where }.
hint-too-early-how = Compara tu programa con la tarea, frase a frase: ¿qué parte falta todavía al final?
hint-too-early-because = El programa acabó por sí mismo antes de cumplir la comprobación.

hint-too-late-look = Tarda demasiado. ¿Dónde pierde tiempo el robot?
hint-too-late-part = Mira { $where }.
hint-too-late-how = Busca esperas largas, velocidades lentas y caminos más largos de lo necesario.
hint-too-late-because = No pasó en el tiempo que permite la comprobación.

# $reason: what the check says
hint-look-again-look = { $reason }
hint-look-again-part = Mira { $where }.
hint-look-again-how = Ejecuta el programa despacio y para en el primer momento en que el robot haga algo distinto de lo que esperabas.
hint-look-again-because = Ninguna otra regla encaja.

# $number: of the rule in the lesson; $sign: one of the texts below
hint-teacher-because = Encaja la regla { $number } de la lección: { $sign }.
hint-sign-none = no se cumple su comprobación
hint-sign-never-asks = algo no se pregunta nunca
hint-sign-never-runs = algo no se ejecuta nunca
hint-sign-loop-without-wait = una orden no tiene tiempo
hint-sign-wrong-sign = una dirección es la contraria
hint-sign-value-too-small = un valor es demasiado pequeño
hint-sign-value-too-large = un valor es demasiado grande
hint-sign-no-loop = falta un bucle
hint-sign-too-early = el programa acaba demasiado pronto
hint-sign-too-late = tarda demasiado
hint-sign-collision = el robot choca con algo
hint-sign-error = un error termina el programa
hint-sign-empty = algo está vacío
