# Habilidades que fallan, y archivos de habilidades que no se pueden cargar. $file es como skills/dance.py.

skill-not-function = En { $file }, '{ $name }' ya no es una función cuando el archivo ha terminado. Ponle otro nombre al otro valor.
skill-file-syntax = No se puede cargar { $file } por un error en la línea { $line }: { $reason }.
skill-file-broken = No se puede cargar { $file } ({ $reason }). Corrige el archivo y ejecuta el programa otra vez.
skill-still-driving = El robot solo ha avanzado { $driven } de { $distance } mm en { $seconds } segundos. ¿Está atascado o levantado del suelo?
skill-speed-not-positive = La velocidad es { $value } mm/s. Escribe una velocidad mayor que 0; con una distancia negativa va marcha atrás.
skill-radius-not-positive = El radio es { $value } mm. Escribe un radio mayor que 0; con un ángulo negativo va hacia la izquierda.
skill-turning-speed-not-positive = La velocidad de giro es { $value }°/s. Escribe una velocidad mayor que 0; con un ángulo negativo gira a la izquierda.
skill-still-turning = El robot solo ha girado { $turned } de { $angle } grados en { $seconds } segundos. ¿Está atascado o levantado del suelo?
