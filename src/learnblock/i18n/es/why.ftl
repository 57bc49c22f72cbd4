# Respuestas a preguntas sobre una ejecución. $line es el número de una línea, $code su texto y $time son segundos.
# En una página que solo muestra bloques, $line e $inner son "block", y $code e $innerCode, las palabras de los bloques.
why-line = { $line ->
    [block] el bloque { $code }
   *[other] la línea { $line }
}
why-first-line = { $line ->
    [block] El bloque { $code }
   *[other] La línea { $line }
}
why-line-code = { $line ->
    [block] el bloque { $code }
   *[other] la línea { $line }, { $code }
}
why-line-does = { $line ->
    [block] el bloque { $code }
   *[other] la línea { $line }, { $code },
}
why-first-line-does = { $line ->
    [block] El bloque { $code }
   *[other] La línea { $line }, { $code },
}
why-line-says = { $line ->
    [block] eso lo hace el bloque { $code }
   *[other] la línea { $line } dice { $code }
}
why-of-line = { $line ->
    [block] del bloque { $code }
   *[other] de la línea { $line }
}
why-of-line-code = { $line ->
    [block] del bloque { $code }
   *[other] de la línea { $line }, { $code }
}
why-of-line-does = { $line ->
    [block] del bloque { $code }
   *[other] de la línea { $line }, { $code },
}
why-first-inner = { $inner ->
    [block] El bloque { $innerCode }
   *[other] La línea { $inner }
}
why-of-inner = { $inner ->
    [block] del bloque { $innerCode }
   *[other] de la línea { $inner }
}
why-to-inner = { $inner ->
    [block] al bloque { $innerCode }
   *[other] a la línea { $inner }
}

why-not-understood = LearnBlock no entiende «{ $question }». Pregunta, por ejemplo: { $first } { $second } { $third }

why-answer-true = sí
why-answer-false = no
why-value-none = nada
why-at = { " " }en el segundo { $time }
why-between = { " " }entre los segundos { $since } y { $time }
why-since = { " " }después del segundo { $time }

why-move-stand = quedarse quieto
why-move-forward = avanzar en línea recta
why-move-back = ir marcha atrás
why-move-spin-left = girar a la izquierda sin avanzar
why-move-spin-right = girar a la derecha sin avanzar
why-move-curve-left = avanzar en curva hacia la izquierda
why-move-turn = girar
why-move-curve-right = avanzar en curva hacia la derecha

why-ask-movement = ¿Por qué el robot empezó a { $subject }{ $time }?
why-ask-not-movement = ¿Por qué el robot no llegó a { $subject }{ $time }?
why-ask-skill = ¿Por qué hizo «{ $subject }»{ $time }?
why-ask-not-skill = ¿Por qué no hizo «{ $subject }»{ $time }?
why-ask-print = ¿Por qué se escribió el texto de la línea { $subject }{ $time }?
why-ask-not-print = ¿Por qué no se escribió el texto de la línea { $subject }{ $time }?
why-ask-printed = ¿Por qué se escribió «{ $subject }»{ $time }?
why-ask-when = ¿Por qué estaba activo «when { $subject }»{ $time }?
why-ask-not-when = ¿Por qué no estaba activo «when { $subject }»{ $time }?
why-ask-line = ¿Por qué se ejecutó la línea { $subject }{ $time }?
why-ask-not-line = ¿Por qué no se ejecutó la línea { $subject }{ $time }?
why-ask-value = ¿Por qué tiene { $subject } este valor{ $time }?
why-ask-goal = ¿Por qué no se alcanzó el objetivo «{ $subject }»?
why-ask-reached = ¿Por qué se alcanzó el objetivo «{ $subject }»?
why-ask-emotion = ¿Por qué mostró el robot { $subject }{ $time }?
why-emotion = { $emotion ->
    [joy] alegría
    [sadness] tristeza
    [anger] enfado
    [fear] miedo
    [disgust] asco
    [surprise] sorpresa
    [neutral] ninguna emoción
   *[other] { $emotion }
}
why-ask-end = ¿Por qué terminó el programa?
why-ask-not-end = ¿Por qué no terminó el programa{ $time }?
why-ask-nothing = ¿Por qué no pasó nada{ $time }?
why-ask-long = ¿Por qué el robot tardó tanto en dejar de { $subject }{ $time }?
why-ask-speed = ¿Por qué iba el robot tan { $subject ->
    [fast] rápido
   *[slow] lento
}{ $time }?
why-ask-lost = ¿Por qué se salió el robot de la línea{ $time }?
why-ask-fall = ¿Por qué se cayó el robot{ $time }?
why-ask-bump = ¿Por qué chocó el robot con { $subject }{ $time }?
why-ask-print-text = ¿Por qué se escribió «{ $subject }»{ $time }?
why-ask-not-print-text = ¿Por qué no se escribió «{ $subject }»{ $time }?
why-ask-print-any = ¿Por qué se escribió un texto{ $time }?
why-ask-not-print-any = ¿Por qué no se escribió ningún texto{ $time }?
why-ask-goal-any = ¿Por qué no se alcanzó el objetivo?
why-ask-reached-any = ¿Por qué se alcanzó el objetivo?
why-ask-bump-any = ¿Por qué chocó el robot con algo{ $time }?
why-ask-score = ¿Por qué hay { $subject } puntos{ $time }?
why-ask-lives = ¿Por qué cambiaron las vidas{ $time }?
why-ask-game = { $subject ->
    [won] ¿Por qué se ganó el juego{ $time }?
   *[lost] ¿Por qué se acabó el juego{ $time }?
}
why-ask-now = ¿Qué estaba haciendo el robot{ $time }?

why-facts = : { $facts }
why-name-was = { $name } era { $value }
why-when-state = «when { $name }» { $active ->
    [true] estaba activo
   *[other] no estaba activo
}
why-when-time = «when { $name }» llevaba activo { $seconds } s
why-own-gave = { $name } devolvió { $value }
why-answered = «{ $skill }» respondió { $value }
why-never-answers = a este robot le falta esto: { $device }; por eso «{ $skill }» nunca encuentra nada
why-thing = { " " }({ $thing })
why-thing-at = { "" }
why-side = { $side ->
    [front] delantero
    [left] izquierdo
    [right] derecho
    [back] trasero
    [central] central
    [center] central
   *[other] { $side }
}
why-measured = el sensor { $side } midió { $mm } mm{ $thing }
why-measured-limit = el sensor { $side } midió { $mm } mm{ $thing }, { $less ->
    [true] menos
   *[other] no menos
} de { $limit } mm
why-saw-nothing = el sensor { $side } no vio nada
why-ground-side = { $side ->
    [left] a la izquierda
    [right] a la derecha
    [front] delante
    [back] detrás
   *[other] en el centro
}
why-ground = { $dark ->
    [true] oscuro
   *[other] claro
} { $side } ({ $value })
why-ground-saw = el suelo era { $sensors }
why-colour = { $colour ->
    [black] negros
    [red] rojos
    [blue] azules
   *[other] { $colour }
}
why-saw-line = la cámara vio puntos { $colour }: { $left } a la izquierda, { $center } en el centro y { $right } a la derecha
why-saw-no-line = la cámara no vio puntos { $colour }
why-saw-tags = la cámara vio la etiqueta { $tags }
why-saw-no-tag = la cámara no vio ninguna etiqueta
why-time-was = el programa llevaba en marcha { $time } s, no más de { $limit } s
why-time-was-over = el programa llevaba en marcha { $time } s, más de { $limit } s
why-closest = {" "}Lo más cerca que estuvo fue a { $mm } mm, en el segundo { $time }.

why-moved = En el segundo { $time } el robot recibió la orden de { $motion }: { why-line-says }.
why-moved-alone = En el segundo { $time } el robot recibió la orden de { $motion }.
why-after = Antes, { why-line-does } duró desde el segundo { $since } hasta el { $time }.
why-ran = { why-first-line-does } se ejecutó en el segundo { $time }.
why-when-ran = «when { $name }», en { why-line }, estaba activo en el segundo { $time }.
why-condition-was = { $true ->
    [true] Llegó ahí porque { why-line-does } se cumplía en el segundo { $time }{ $facts }.
   *[other] Llegó ahí porque { why-line-does } no se cumplía en el segundo { $time }{ $facts }.
}
why-loop-over = El bucle { why-of-line-does } acabó en el segundo { $time }{ $facts }.
why-when-was = «when { $name }» { $active ->
    [true] estaba activo, porque su condición { why-of-line } se cumplía
   *[other] no estaba activo, porque su condición { why-of-line } no se cumplía
} en el segundo { $time }{ $facts }.
why-switched = { why-first-line-does } { $on ->
    [true] activó
   *[other] desactivó
} «when { $name }» en el segundo { $time }.
why-called = { why-first-line-does } llamó a { $name } en el segundo { $time }.
why-given = { $name } era { $value }: { why-line-does } se lo dio a { $function } en el segundo { $time }.
why-set = { $name } era { $value }: ese valor se lo dio { why-line-does } en el segundo { $time }.
why-set-through = { why-first-line-does } cambió { $other } en el segundo { $time }, y { $other } y { $name } son la misma lista, que ahora es { $value }.
why-returned = { $name } devolvió { $value } en el segundo { $time }: { why-line-says }.
why-no-return = { $name }, en { why-line }, no devolvió nada: no llegó a ningún «return».

why-no-such-movement = Ninguna línea de tu programa le dice al robot esto: { $motion }.
why-no-such-skill = Ninguna línea de tu programa dice «{ $skill }».
why-no-such-line = { why-first-line } no tiene nada que se pueda ejecutar.
why-it-did = Sí lo hizo: { why-line-does } { $lasted ->
    [over] se ejecutó desde el segundo { $time } hasta el { $until }.
    [still] empezó en el segundo { $time }.
   *[no] se ejecutó en el segundo { $time }.
}
why-overridden-soon = Pero justo después { why-line-does } le dio al robot otra orden: { $motion }.
why-overridden-later = Pero { $seconds } s después { why-line-does } le dio al robot otra orden: { $motion }.
why-no-effect = { why-first-line-does } se ejecutó en el segundo { $time }, pero no tuvo efecto: a este robot le falta esto: { $device }.
why-needs = { why-first-inner } solo se ejecuta si { why-line-does } { $needed ->
    [true] se cumple; en el segundo { $time } no se cumplía
   *[other] no se cumple; en el segundo { $time } se cumplía
}{ $facts }.{ $closest }
why-hidden = { why-first-inner } ni siquiera se comprobó: { why-line-does } va antes y se cumplía en el segundo { $time }{ $facts }.
why-nothing-to-repeat = { why-first-inner } está en el bucle { why-of-line-does } que no tenía nada que recorrer.
why-never-called = { why-first-inner } está en { $name }, y ninguna línea llama a { $name }.
why-not-called = A { $name } solo lo llama { why-line-does } y no se ejecutó.
why-when-never = «when { $name }» no estaba activo: su condición { why-of-line } no se cumplía en el segundo { $time }{ $facts }.{ $closest }
why-never-activated = «when { $name }», en { why-line }, no estaba activo: ninguna línea lo activa.
why-activates-other = { why-first-line-does } activa «when { $name }», no «when { $inner }».
why-activate-not-run = Solo { why-line-does } activa «when { $name }», y no se había ejecutado.
why-left = { why-first-line-does } salió antes de llegar { why-to-inner }, en el segundo { $time }.
why-in-loop = { $endless ->
    [true] { why-first-inner } va después del bucle { why-of-line-does } que nunca acaba por sí solo.
   *[other] { why-first-inner } va después del bucle { why-of-line-does } que seguía en el segundo { $time }{ $facts }.{ $closest }
}
why-break-inner = { why-first-line-does } solo salió del bucle { why-of-inner }, en el segundo { $time }.
why-asked-once = La línea { $line }, { $code }, se comprobó solo una vez, en el segundo { $time }: no está dentro de ningún bucle.
why-busy = Del segundo { $since } al { $until } el programa estuvo ocupado con { why-line-does } y no hizo nada más.
why-waiting = El programa seguía esperando en { why-line-does } en el segundo { $time }{ $facts }.{ $closest }
why-failed = El programa había terminado con un error en { why-line-code }: { $message }
why-finished = El programa acabó en el segundo { $time }: había llegado a su final.
why-time-limit = La ejecución se detuvo en el segundo { $time }, al llegar a su límite de tiempo.
why-stopped = La ejecución se detuvo en el segundo { $time }.
why-not-set = Ninguna línea había dado todavía un valor a { $name }.
why-bumped = El robot chocó con { $name } en el segundo { $time }.
why-no-bump = El robot no chocó con nada.
why-goal = El objetivo «{ $name }» { $state ->
    [reached] se alcanzó
    [failed] falló
   *[other] no se había alcanzado
} en el segundo { $time }.
why-score-changed = A los { $time } s, el programa cambió los puntos a { $value }.
why-score-changed-by = A los { $time } s, "{ $thing }" cambió los puntos a { $value }.
why-lives-changed = A los { $time } s, el programa cambió las vidas a { $value }.
why-lives-changed-by = A los { $time } s, "{ $thing }" cambió las vidas a { $value }.
# $reason es una cosa, una meta o una de estas palabras.
why-game-ended = { $end ->
    [won] El juego se ganó
   *[lost] El juego se acabó
} a los { $time } s: { $reason ->
    [program] lo terminó el programa
    [lives] no quedaban vidas
    [time] se acabó el tiempo
    [goals] se alcanzaron todas las metas
   *[other] por "{ $reason }"
}.
# Un objetivo ganó el juego; $robot es el nombre del robot que lo alcanzó.
why-team-won = El equipo { $team } ganó el juego a los { $time } s: se alcanzó el objetivo "{ $goal }" ({ $robot }).
why-robot-won = { $robot } ganó el juego a los { $time } s: alcanzó el objetivo "{ $goal }".
why-no-goal = Este mundo no tiene ningún objetivo.
why-no-events = El registro no tiene nada de lo que hizo el programa.
why-unknown = El registro no dice por qué.
why-left-loop = { why-first-line-does } salió del bucle en el segundo { $time }.
why-own-name = { why-first-line-does } cambió otra { $name }: la que solo pertenece a { $function }.
why-own-place = { $function }, en { why-line }, tiene su propia { $name }, porque es uno de sus parámetros.
why-camera = La cámara estaba inclinada a { $angle }°: la movió { why-line-does } en el segundo { $time }.
why-meanwhile = Mientras tanto el robot tenía la orden de { $motion }: { why-line-says }.
why-not-happened = Eso no había pasado hasta el segundo { $time }.
why-there-is-more = { $count ->
    [one] Hay una causa más: añade --more.
   *[other] Hay { $count } causas más: añade --more.
}
why-start-over = «when start», en { why-line }, solo se ejecuta una vez; había acabado en el segundo { $time }.
why-turn = Era la vuelta { $count } del bucle { why-of-line-code }.
why-not-then = En el segundo { $time } el robot tenía otra orden.
why-never-told = Ninguna línea { $possible ->
    [true] le había dicho al robot que se moviera hasta el segundo { $time }.
   *[other] de tu programa le dice al robot que se mueva.
}
why-stops-at-end = Cuando un programa termina, su robot se para.
why-turns-over = El bucle { why-of-line-does } acabó en el segundo { $time }{ $count ->
    [0] .
    [one] , después de una vuelta.
   *[other] , después de { $count } vueltas.
}
why-never-read = { why-first-line-does } da un valor a { $name }, pero ninguna línea lo usa.
why-result-lost = { why-first-line-does } dio { $value } en el segundo { $time }, pero nada usa lo que da { $name }.
why-last-line = Lo último de { $name } que se ejecutó fue { why-line-does } que no es un «return».
why-same-list = { why-first-line-does } no copia la lista: { $name } es solo otro nombre para ella.

why-loop-goes-on = { $endless ->
    [true] El bucle { why-of-line-does } no termina nunca por sí solo.
   *[other] El bucle { why-of-line-does } seguía en el segundo { $time }{ $facts }.{ $closest }
}
why-when-goes-on = Un programa con eventos sigue mientras alguno pueda ejecutarse: «when { $name }», en { why-line }, estaba activo en el segundo { $time }.
why-no-acts = Ninguna línea de tu programa hace que el robot haga algo.
why-paused = { why-first-line-does } esperó { $seconds } s en total.
why-line-not-asked = Ninguna línea de tu programa buscó una línea en el suelo.
why-line-never-seen = { why-first-line-does } no vio nunca la línea.
why-line-seen = { why-first-line-does } vio la línea en el segundo { $time }, y después no en mucho tiempo.
why-no-floor = Bajo un sensor no había suelo en el segundo { $time }.
why-only-each-other = «when { $name }», en { why-line }, no estaba activo: solo lo activan eventos que no se habían ejecutado.
why-decimals = Un ordenador guarda la mayoría de los decimales solo de forma aproximada: 0.1 + 0.2 es 0.30000000000000004. Pregunta por menor o mayor, o redondea antes.
why-never-stopped = «when { $name }», en { why-line }, se repite una y otra vez: ninguna línea lo para.
why-not-between = Eso no pasó entre los segundos { $since } y { $time }.
why-not-yet = { why-first-line-does } también cambia { $name }, pero aún no se había ejecutado.

## Dos ejecuciones de un programa.

why-parted = En el segundo { $time } { why-line-does } { $answer ->
    [true] se cumplía{ $facts }.
   *[other] no se cumplía{ $facts }.
}
why-parted-turn = En el segundo { $time } { why-line-does } empezó otra vuelta.
why-parted-ended = Esta ejecución terminó en el segundo { $time }.
why-parted-acted = En el segundo { $time } { why-line-does } le dijo al robot qué hacer a continuación.
why-parted-because = En el segundo { $time } { why-line-does } { $answer ->
    [true] se cumplió en la primera ejecución, porque { $one }, y no en la segunda, porque { $other }.
   *[other] no se cumplió en la primera ejecución, porque { $one }, y sí en la segunda, porque { $other }.
}
why-same = Las dos ejecuciones tomaron las mismas decisiones.
why-together = Las dos ejecuciones tomaron las mismas decisiones hasta el segundo { $time }.
why-run = { $name }: { $sentence }
why-cause-edit = La línea { $line } se editó: { $before } pasó a ser { $after }.
why-cause-added = La línea { $line } se añadió: { $after }.
why-cause-removed = La línea { $line } se quitó: { $before }.
why-cause-more = { $count ->
    [one] Otra línea es distinta.
   *[other] Otras { $count } líneas son distintas.
}
why-cause-robot = La primera ejecución fue en { $one }, la segunda en { $other }.
why-cause-world = La primera ejecución fue en el mundo { $one }, la segunda en { $other }.
why-cause-variant = El mundo { $world } no era el mismo: era otra variante, o se editó.
why-cause-seed = Las ejecuciones tenían semillas distintas, { $one } y { $other }, así que el ruido de sus sensores y ruedas fue distinto.
why-cause-start = El robot se puso en otro lugar antes de la ejecución.
why-cause-hand = El robot se movió a mano, o se pulsaron teclas, en otros momentos.
why-cause-real = Un robot real nunca hace exactamente lo mismo dos veces.
why-cause-length = Una ejecución se detuvo antes que la otra.

# Cosas de nuestros mundos, por su nombre inglés.

why-name = { $word ->
    [box] una caja
    [block] un bloque
    [crate] un cajón
    [ball] una pelota
    [barrel] un barril
    [cone] un cono
    [house] una casa
    [lamp] una farola
    [pile] un montón de bloques
    [planet] un planeta
    [post] un poste
    [rocket] un cohete
    [tree] un árbol
    [flowers] unas flores
    [cylinder] un cilindro
    [light-box] una caja ligera
    [light-cylinder] un cilindro ligero
    [red-pillar] el pilar rojo
    [blue-pillar] el pilar azul
    [green-pillar] el pilar verde
    [wall] una pared
    [border] el borde del mundo
    [tag] la etiqueta { $rest }
    [face] { $rest ->
        [joy] una cara alegre
        [sadness] una cara triste
        [anger] una cara enfadada
        [fear] una cara asustada
        [disgust] una cara de asco
        [surprise] una cara sorprendida
       *[other] una cara
    }
   *[other] { $name }
}
