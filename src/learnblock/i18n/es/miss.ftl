# Por cuánto y dónde una ejecución no alcanzó una meta, o lo que pide una comprobación de una lección.
# $gap y $turn son mensajes que empiezan por miss-gap.

miss-gap-short = faltan { $mm } mm
miss-gap-past = { $mm } mm de más
miss-gap-left = { $mm } mm demasiado a la izquierda
miss-gap-right = { $mm } mm demasiado a la derecha
miss-gap-away = a { $mm } mm
miss-gap-turned-left = girado { $degrees }° de más a la izquierda
miss-gap-turned-right = girado { $degrees }° de más a la derecha
miss-gap-under = faltan { $degrees }°
miss-gap-over = { $degrees }° de más
miss-near = En el punto más cercano: { $gap }.
miss-stopped = El robot se paró: { $gap }.
miss-stopped-facing = El robot se paró en el lugar correcto, pero { $turn }.
miss-driven = El robot recorrió { $driven } mm: { $gap }.
miss-turned = El robot giró { $turned }°: { $gap }.
miss-goal = La meta '{ $goal }': { $gap }.
miss-corner = { $number ->
    [1] La primera esquina
    [2] La segunda esquina
    [3] La tercera esquina
    [4] La cuarta esquina
    [5] La quinta esquina
    [6] La sexta esquina
   *[other] La esquina { $number }
}: { $gap }.
miss-place = Lugar { $number } de { $count }: { $gap }.
# $thing es el nombre de un objeto que el robot debe llevar.
miss-object = '{ $thing }' todavía no está allí.
miss-not-alone = La meta '{ $goal }': todavía hay otro robot allí.
miss-facing = La meta '{ $goal }': el lugar es correcto, pero está { $turn }.
miss-goal-stood = La meta '{ $goal }': el robot estuvo parado allí { $stood } s en lugar de { $asked } s.
miss-stood = La parada más larga duró { $stood } s en lugar de { $asked } s.
miss-tag-far = Etiqueta { $tag }: sobran { $mm } mm de distancia; acércate a menos de { $most } mm.
miss-tag-behind = Etiqueta { $tag }: el robot estaba detrás, no delante.
miss-tag-facing = Etiqueta { $tag }: el robot estaba cerca, pero { $turn }.
miss-follow = El robot siguió el { $share } % de la línea en lugar del { $asked } %.
miss-left-line = El robot dejó la línea a los { $at } s.
miss-emotion = El robot no mostró nunca '{ $emotion }'.
miss-emotion-away = El robot mostró '{ $emotion }' a { $mm } mm del lugar.
miss-score = Hubo { $score } puntos en lugar de { $asked }.
miss-collect = El robot recogió { $count } de { $asked } cosas.
miss-gates = El robot pasó por { $count } de { $asked } puertas en su orden.
miss-life-lost = El programa quitó una vida a los { $at } s.
# $thing es una cosa del mundo, como bug 2.
miss-life-lost-by = '{ $thing }' quitó una vida a los { $at } s.
miss-bump = El robot chocó con algo después de { $mm } mm.
miss-line-never = El robot no llegó nunca a la línea.
miss-was-there = El robot estuvo allí a los { $at } s.
