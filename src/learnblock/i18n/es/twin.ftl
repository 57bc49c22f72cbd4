# Un robot real, comparado con su gemelo.

twin-none = Un gemelo solo se puede comparar con un robot real, y solo si ese robot tiene uno. Este registro no tiene una ejecución así.
twin-needs-one = Con --with-twin, compare recibe un solo registro.
twin-needs-two = Indica dos registros, o un registro de un robot real y --with-twin.
twin-together = El robot fue por donde fue su gemelo: nunca estuvo a más de 30 mm ni a más de 10° de él.
twin-parted = A los { $time } s el robot estaba a { $distance } mm de donde fue su gemelo con las mismas órdenes, cerca de x = { $x } mm, y = { $y } mm.
twin-askew = A los { $time } s el robot miraba { $angle }° más a la { $side ->
    [right] derecha
   *[left] izquierda
} que su gemelo con las mismas órdenes.
twin-drives = Avanza un { $percent } % { $much ->
    [more] de más
   *[less] de menos
}, según { $sensor ->
    [distance] su sensor de distancia
   *[odometry] su propia cuenta
}.
twin-turns = Gira un { $percent } % { $much ->
    [more] de más
   *[less] de menos
}, según { $sensor ->
    [gyroscope] su giroscopio
   *[odometry] su propia cuenta
}.
twin-wheels = Sus ruedas giraron un { $percent } % { $much ->
    [more] más
   *[less] menos
} de lo que se les ordenó: busca una batería vacía, una velocidad demasiado alta para sus motores o algo que frene una rueda.
twin-set = En los ajustes del robot, cambia { $setting } de { $now } a { $value }.
twin-no-setting = Este robot no tiene ningún ajuste para eso: controla su velocidad él mismo. Haz que el programa mida, o cambia sus velocidades.
twin-sensor = El robot fue por donde fue su gemelo, pero desde los { $time } s su sensor de distancia midió { $real } mm en lugar de { $twin } mm: el sensor mide mal, o el mundo no es como está dibujado.

## Lo que el registro no tiene.

twin-no-odometry = Este robot no dice dónde está, así que no se conoce su camino.
twin-way-not-measured = Sus ruedas cuentan sus vueltas, no el camino: no se registró cuánto avanzó de verdad. Mídelo con una regla (Calibrar), o ve recto hacia una pared y elige ese mundo.
twin-turn-not-measured = No se registró cuánto giró de verdad: este robot no tiene giroscopio.
twin-empty-floor = Su gemelo condujo por un suelo vacío: no se compararon los choques, las líneas ni lo que vieron los sensores.
