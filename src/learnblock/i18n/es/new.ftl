# Robots, habilidades y mundos nuevos: sus nombres, descripciones y archivos.

new-bad-robot-name = Un robot no se puede llamar '{ $name }'. Usa como mucho { $most } minúsculas, cifras y -, por ejemplo { $example }.
new-bad-skill-name = Una habilidad no se puede llamar '{ $name }'. Usa como mucho { $most } minúsculas, cifras y _, por ejemplo { $example }.
new-twin-name = '{ $name }' es el nombre de un robot simulado. Quita sim-: el simulado se crea también.
new-robot-exists = Ya hay un robot '{ $name }'. Elige otro nombre.
new-skill-exists = Todos los robots tienen ya '{ $name }'. Elige otro nombre.
new-world-exists = Ya hay un mundo '{ $name }'. Elige otro nombre.
new-files-exist = Estos archivos ya existen: { $files }. Elige otro nombre, o sustitúyelos con --force.

new-too-wide = El cuerpo llega a { $reach } mm del centro entre las ruedas, pero en los mundos solo caben { $most } mm.
new-gyroscope-key = La clave del giroscopio de un robot tiene que ser Z_AXIS, no { $key }.
new-bad-key = '{ $key }' ({ $field }) no es una palabra. Usa letras, cifras, espacios y _.

new-ask-name = Nombre del robot, por ejemplo path-finder
new-ask-connection = Conexión
new-ask-distance-count = Número de sensores de distancia
new-ask-distance-sensor = Sensor de distancia { $number }, de izquierda a derecha:
new-ask-sides = distance.sides (dónde aparece su medida)
new-ask-ground = Sensores de suelo (left, central, right, o none si no hay)
new-ask-ground-sensor = Sensor de suelo { $side }:
new-ask-gyroscope = ¿Tiene giroscopio?
new-ask-accelerometer = ¿Tiene acelerómetro?
new-ask-face = ¿Tiene una cara que muestra emociones?
new-ask-speaker = ¿Tiene altavoz?
new-ask-camera = ¿Tiene cámara?
new-ask-joints = Articulaciones, por ejemplo CAMERA, ARM (o none si no hay)
new-ask-joint = Articulación { $joint }:
new-ask-range-order = Error: joint.minimum tiene que ser menor que joint.maximum.
new-ask-leds = Posiciones de sus LED, por ejemplo Front, Left (o none si no hay)
new-ask-led-colour = { $position }: ¿puede cambiar de color?
new-ask-wrong-value = { $key } no puede ser '{ $value }'. Se espera { $allowed }.
new-ask-unknown = '{ $value }' no es ninguno de estos: { $known }.
new-ask-bad-key = '{ $key }' no es una palabra. Usa letras, cifras y espacios.
