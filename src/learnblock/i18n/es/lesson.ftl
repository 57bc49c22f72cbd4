# Lecciones: sus archivos, sus comprobaciones en palabras y por qué falló una.

# Archivos de las lecciones. $file es una ruta dentro de la lección.
lesson-file-type = Aquí no hay ninguna lección. Indica una carpeta con una lección o un archivo que termine en { $ending }.
lesson-no-main-file = Esto no es una lección: no tiene { $file }.
lesson-newer = Esta lección se hizo con un LearnBlock más nuevo: versión { $version } del formato. Actualiza LearnBlock.
lesson-missing-file = La lección no tiene el archivo '{ $file }'.
lesson-zip-damaged = Este archivo está dañado o no es una lección.
lesson-unknown-file = Una lección no puede tener un archivo '{ $file }'. Quítalo o mira en docs/lessons.md qué archivos tiene una lección.
lesson-too-many-files = Una lección puede tener { $most } archivos como máximo.
lesson-uses-one = Indica exactamente uno de 'construct', 'skill' y 'function'.
lesson-quiz-without-answer = Ninguna respuesta es correcta. Escribe 'right = true' al menos en una.
lesson-text-blocks = El bloque de código 'blocks' de este texto no es Block-Text: { $problem }
lesson-text-braces = Las llaves de este texto no encajan: { $reason }. Para escribir una llave, usa '{ "{{" }'.
lesson-text-values = El texto '{ $name }' tiene otros valores en '{ $language }'.
lesson-partner-name = Otro robot ya se llama '{ $name }'. Elige otro nombre.
lesson-puzzle-program = Este orden no es un programa en Block-Text: { $problem }
lesson-puzzle-pieces = Este orden no tiene las mismas piezas que '{ $file }'. Usa las mismas instrucciones en los dos.

# Cuántas veces ocurre algo.
lesson-times = { $count ->
        [1] una vez
        [2] dos veces
       *[other] { $count } veces
    }

# Sucesos. $form: una frase, que no ocurre nunca, que no ocurrió (missing) o que ocurrió (past), o parte de una frase.
lesson-event-goal = { $form ->
    [sentence] Se alcanza la meta '{ $name }'
    [never] No se alcanza nunca la meta '{ $name }'
    [missing] No se alcanzó la meta '{ $name }'
    [past] Se alcanzó la meta '{ $name }'
   *[clause] se alcanza la meta '{ $name }'
}
lesson-event-shows = { $form ->
    [sentence] El robot muestra '{ $what }'
    [never] El robot no muestra nunca '{ $what }'
    [missing] El robot no mostró '{ $what }'
    [past] El robot mostró '{ $what }'
   *[clause] el robot muestra '{ $what }'
}
lesson-event-shows-any = { $form ->
    [sentence] El robot muestra algo
    [never] El robot no muestra nunca nada
    [missing] El robot no mostró nada
    [past] El robot mostró algo
   *[clause] el robot muestra algo
}
lesson-event-says = { $form ->
    [sentence] El robot dice '{ $what }'
    [never] El robot no dice nunca '{ $what }'
    [missing] El robot no dijo '{ $what }'
    [past] El robot dijo '{ $what }'
   *[clause] el robot dice '{ $what }'
}
lesson-event-says-any = { $form ->
    [sentence] El robot dice algo
    [never] El robot no dice nunca nada
    [missing] El robot no dijo nada
    [past] El robot dijo algo
   *[clause] el robot dice algo
}
lesson-event-prints = { $form ->
    [sentence] El programa escribe '{ $what }'
    [never] El programa no escribe nunca '{ $what }'
    [missing] El programa no escribió '{ $what }'
    [past] El programa escribió '{ $what }'
   *[clause] el programa escribe '{ $what }'
}
lesson-event-prints-any = { $form ->
    [sentence] El programa escribe una línea
    [never] El programa no escribe nunca nada
    [missing] El programa no escribió nada
    [past] El programa escribió una línea
   *[clause] el programa escribe una línea
}
lesson-event-calls = { $form ->
    [sentence] El programa usa { $skill }
    [never] El programa no usa nunca { $skill }
    [missing] El programa no usó { $skill }
    [past] El programa usó { $skill }
   *[clause] el programa usa { $skill }
}
lesson-event-sends = { $form ->
    [sentence] El programa envía el mensaje '{ $message }'
    [never] El programa no envía nunca el mensaje '{ $message }'
    [missing] El programa no envió el mensaje '{ $message }'
    [past] El programa envió el mensaje '{ $message }'
   *[clause] el programa envía el mensaje '{ $message }'
}
lesson-event-collision = { $form ->
    [sentence] El robot choca con algo
    [never] El robot no choca nunca con nada
    [missing] El robot no chocó con nada
    [past] El robot chocó con algo
   *[clause] el robot choca con algo
}
lesson-event-collision-with = { $form ->
    [sentence] El robot choca con '{ $thing }'
    [never] El robot no choca nunca con '{ $thing }'
    [missing] El robot no chocó con '{ $thing }'
    [past] El robot chocó con '{ $thing }'
   *[clause] el robot choca con '{ $thing }'
}
lesson-event-at = { $form ->
    [sentence] El robot llega a menos de { $radius } mm del lugar ({ $x }, { $y })
    [never] El robot no llega nunca a menos de { $radius } mm del lugar ({ $x }, { $y })
    [missing] El robot no llegó a menos de { $radius } mm del lugar ({ $x }, { $y })
    [past] El robot llegó a menos de { $radius } mm del lugar ({ $x }, { $y })
   *[clause] el robot llega a menos de { $radius } mm del lugar ({ $x }, { $y })
}
lesson-event-stands = { $form ->
    [sentence] El robot se queda quieto durante { $seconds } s
    [never] El robot no se queda nunca quieto durante { $seconds } s
    [missing] El robot no se quedó quieto durante { $seconds } s
    [past] El robot se quedó quieto durante { $seconds } s
   *[clause] el robot se queda quieto durante { $seconds } s
}

# El título del conjunto de bloques de un paso.
lesson-blocks = Esta lección

# Lo que pide una comprobación; $event es un suceso de arriba, $check otra de estas frases, $within nada o lesson-within.
lesson-check-robot = { $robot }: { $check }
lesson-within = { " " }en menos de { $seconds } s
lesson-check-all-goals = Alcanza todas las metas{ $within }.
lesson-check-goals = { $count ->
        [1] Alcanza la meta '{ $goals }'{ $within }.
       *[other] Alcanza las metas { $goals }{ $within }.
    }
lesson-check-happens = { $event }{ $within }.
lesson-check-at-least = { $event } al menos { $least }{ $within }.
lesson-check-exactly = { $event } exactamente { $times }{ $within }.
lesson-check-at-most = { $event } como máximo { $most }{ $within }.
lesson-check-between = { $event } al menos { $least } y como máximo { $most }{ $within }.
lesson-check-never = { $event }.
lesson-check-order = Esto ocurre en este orden: { $events }.
lesson-check-order-within = Esto ocurre en este orden, con { $seconds } s como máximo entre una cosa y la siguiente: { $events }.
lesson-check-line = Quédate sobre la línea '{ $line }' durante el { $share } % del tiempo.
lesson-check-drives = Recorre al menos { $least } mm.
lesson-check-drives-most = Recorre { $most } mm como máximo.
lesson-check-drives-between = Recorre al menos { $least } mm y como máximo { $most } mm.
lesson-check-ends-at = Párate a menos de { $radius } mm del lugar ({ $x }, { $y }).
lesson-check-ends-facing = Párate a menos de { $radius } mm del lugar ({ $x }, { $y }), con el rumbo { $heading }°.
lesson-check-turns = Gira { $by }° en total.
lesson-check-ends = El programa llega a su final{ $within }.
lesson-check-prints = Escribe estas líneas en este orden: { $lines }.
lesson-check-uses = Usa { $what }.
lesson-check-uses-least = Usa { $what } al menos { $least }.
lesson-check-uses-most = Usa { $what } { $most } como máximo.
lesson-check-uses-no = No uses { $what }.
lesson-check-size = Usa { $blocks } bloques como máximo.
lesson-check-python = La comprobación propia de la lección '{ $function }'.

# Partes de los programas; $what arriba.
lesson-uses-skill = el bloque { $skill }
lesson-uses-function = tu función { $function }
lesson-construct = { $construct ->
        [repeat] 'repeat'
        [forever] 'forever'
        [if] 'if'
        [else] 'else'
        [when] 'when'
        [function] una función propia
        [parameter] una función con un parámetro
        [return] 'return' con un valor
        [variable] una variable
        [list] una lista
        [print] 'print'
        [input] 'input'
       *[loop] un bucle
    }

# Por qué falló una comprobación.
lesson-goal-failed = La meta '{ $goal }' ya no se puede alcanzar.
lesson-goal-late = La meta '{ $goal }' se alcanzó a los { $at } s, pero hay que alcanzarla en { $within } s.
lesson-goal-open = La meta '{ $goal }' no se alcanzó.
lesson-goal-open-within = La meta '{ $goal }' no se alcanzó en { $within } s.
lesson-no-goals = Este mundo no tiene metas.
lesson-not-happened = { $event }.
lesson-happened = { $event } a los { $at } s.
lesson-too-often = { $event } más de { $most }.
lesson-too-seldom = { $event } solo { $times }; tiene que ocurrir al menos { $least }.
lesson-too-late = { $event } a los { $at } s; tiene que ocurrir en { $within } s.
lesson-order-late = Pasaron { $waited } s y se permiten { $within } s como máximo: primero { $before }, después { $event }.
lesson-order-before = El orden no es correcto: primero { $before } y solo después { $event }.
lesson-order-missing = { $event }; tiene que venir después de otra cosa: { $before }.
lesson-no-line = Este mundo no tiene la línea '{ $line }'.
lesson-line-share = Te quedaste sobre la línea durante el { $share } % del tiempo; se pide el { $asked } %.
lesson-line-lost = De momento te has quedado sobre la línea durante el { $share } % del tiempo; se pide el { $asked } % y queda muy poco tiempo.
lesson-line-short = Recorriste { $driven } mm; se piden al menos { $least } mm.
lesson-drove-short = Recorriste { $driven } mm; se piden al menos { $least } mm.
lesson-drove-far = Recorriste { $driven } mm; se permiten { $most } mm como máximo.
lesson-no-pose = No se sabe dónde está el robot.
lesson-ended-away = El robot se paró a { $away } mm del lugar; se permiten { $radius } mm como máximo.
lesson-ended-facing = El robot se paró en el lugar correcto, pero desviado { $off }° de su rumbo; se permiten { $angle }° como máximo.
lesson-turned = El robot giró { $turned }° en total; se piden { $by }°.
lesson-still-running = El programa seguía en marcha a los { $within } s.
lesson-ended-late = El programa terminó a los { $at } s; tiene que terminar en { $within } s.
lesson-ended-error = El programa terminó con un error.
lesson-ended-time = El programa no terminó antes de que se acabara el tiempo.
lesson-ended-otherwise = El programa no terminó por sí mismo.
lesson-not-printed = El programa no escribió '{ $line }'.
lesson-printed-order = El programa no escribió '{ $line }' después de '{ $before }'.
lesson-uses-none = Tu programa no usa { $what }.
lesson-uses-few = Tu programa usa { $what } solo { $times }; se pide al menos { $least }.
lesson-uses-many = Tu programa usa { $what } { $times }; se permite { $most } como máximo.
lesson-uses-not = Tu programa usa { $what }, que aquí no se permite.
lesson-too-large = Tu programa tiene { $blocks } bloques; se permiten { $most } como máximo.

# El Python propio de la lección; $error es el texto de Python, $reason el de la lección.
lesson-expert-silent = La comprobación propia de la lección no dio ninguna respuesta.
lesson-expert-no-verdict = La comprobación propia de la lección no ha respondido en { $seconds } segundos, porque este ordenador está demasiado ocupado. La culpa no es del programa. Prueba otra vez.
lesson-expert-error = La comprobación propia de la lección tiene un error: { $error }
lesson-expert-no = La comprobación propia de la lección no se cumplió.
lesson-expert-says = { $reason }

# La orden learnblock lesson: $mark es ✓ o ✗, $right y $all cuentan intentos.
lesson-cli-solution = { $mark } Paso { $step }: la solución { $file } pasa en { $right } de { $all } intentos.
lesson-cli-wrong-program = { $mark } Paso { $step }: el programa incorrecto { $file } no cumple su comprobación en { $right } de { $all } intentos.
lesson-cli-none = · El paso { $step } tiene comprobaciones, pero ninguna solución.
lesson-cli-not-met = { $robot }, variante { $variant }: { $check } { $reason }
lesson-cli-not-caught = Cumple la comprobación '{ $check }', que no debería cumplir.
lesson-cli-other-hint = Debería recibir primero la pista { $wanted }, pero recibe: { $found }.
lesson-cli-no-hint = ninguna
lesson-cli-wrong = { $wrong } de { $all } programas no hacen lo que deben.
lesson-cli-right = La lección está bien: { $all } programas hacen lo que deben.
lesson-cli-attempt = { $robot }, variante { $variant }:
lesson-cli-hint = Pista ({ $rule }):
lesson-cli-packed = Escrito: { $file }

# learnblock lesson show: $number y $title son los de un paso, $phase su parte en PRIMM.
lesson-show-head = Nivel { $level } · { $minutes } min · { $robots }
lesson-show-step = Paso { $number } ({ $phase }): { $title }
lesson-show-notes = Notas
lesson-show-solution = Solución
lesson-show-wrong = Programa incorrecto típico; no cumple esta comprobación: { $check }
lesson-show-hint = Pista
lesson-show-no-part = Esta copia de la lección no tiene notas ni soluciones.
# $title: el de la lección
lesson-copy-title = { $title } (copia)

# Una lección que se edita en la página.
lesson-edit-no-text = Escribe este texto, al menos en un idioma.
lesson-edit-line = Línea { $line }: { $problem }
lesson-edit-too-long = Los programas de esta lección tienen { $length } caracteres en total; se permiten { $limit } como máximo.
