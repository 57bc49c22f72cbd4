# El diálogo que crea un robot.

page-newrobot-menu = Robot nuevo…
page-newrobot-title = Robot nuevo
page-newrobot-help = LearnBlock crea un robot a partir de su descripción: un controlador con funciones que te toca escribir, un gemelo simulado que se mueve enseguida y una prueba.
page-newrobot-name = Nombre (minúsculas, cifras y -)
page-newrobot-description = Descripción (TOML)
page-newrobot-file = De un archivo…
page-newrobot-make = Crear el robot
page-newrobot-large = { $name } es demasiado grande para una descripción.
page-newrobot-line = Línea { $line }
page-newrobot-made = { $name } y su gemelo sim-{ $name } están listos. Estos archivos son tuyos:
page-newrobot-next = En el primer archivo, cada función sin terminar dice qué debe hacer.
page-newrobot-use = Usar el gemelo
