# Valores y gráfica de los sensores.

page-sensors-title = Sensores del robot
page-sensors-readings = Valores en directo (marca para ver la gráfica)
page-sensors-nothing = Aún no hay valores. Ejecuta un programa o conduce el robot.
page-sensors-save = Guardar como CSV
page-sensors-plot = Gráfica del último minuto: { $sensors }
page-sensors-summary = El último minuto en números
page-sensors-sensor = Sensor
page-sensors-lowest = Mínimo
page-sensors-highest = Máximo
page-sensors-mean = Media
page-sensors-time = Tiempo
page-sensors-yes = sí
page-sensors-no = no
page-sensors-name = { $device ->
    [DistanceSensors] Distancia
    [GroundSensors] Suelo
    [Gyroscope] Giroscopio
    [Accelerometer] Acelerómetro
    [Bumper] Parachoques
    [LightSensor] Luz
    [Controller] Botón
    [Infrared] Infrarrojos
    [Heading] Rumbo
    [Driven] Distancia recorrida
   *[other] { $device }
}{ $place ->
    [none] {""}
    [front] {" delante"}
    [back] {" detrás"}
    [left] { $device ->
        [Accelerometer] {" hacia la izquierda"}
       *[other] {" a la izquierda"}
    }
    [right] {" a la derecha"}
    [central] {" en el centro"}
    [forward] {" hacia adelante"}
    [up] {" hacia arriba"}
   *[other] {" "}{ $place }
}{ $number ->
    [0] {""}
   *[other] {" "}{ $number }
}
# $device is the type of the device that measures, $place the side of a distance sensor.
page-sensors-measure = { $device ->
    [DistanceSensors] { $place ->
        [front] Delante
        [left] Izquierda
        [right] Derecha
       *[back] Detrás
    }
    [GroundSensors] Suelo
    [Bumper] Parachoques
    [Accelerometer] Aceleración
    [LightSensor] Luz
    [Controller] Botones
    [Infrared] Infrarrojos
    [Camera] Cámara
    [Heading] Rumbo
    [Driven] Recorrido
   *[other] { $device }
}
