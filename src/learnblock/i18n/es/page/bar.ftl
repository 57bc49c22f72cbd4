# La barra superior de la página.

page-bar-run = Ejecutar
page-bar-stop = Parar
page-bar-pause = Pausar
page-bar-resume = Continuar
page-bar-pause-or-resume = Pausar o continuar
page-bar-step = Paso
page-bar-step-over = Paso sin entrar en funciones
page-bar-restart = Reiniciar
page-bar-running = Controles de ejecución
page-bar-undo = Deshacer
page-bar-redo = Rehacer
page-bar-speed = Velocidad
page-bar-slow = Cámara lenta { $factor }×
page-bar-times = { $factor }×
page-bar-free = Máxima
page-bar-robot = Robot
page-bar-robots-simulated = Simulados
page-bar-robots-real = Reales
# A robot that is not simulated. $robot: its name
page-bar-real-robot = { $robot } (real)
page-bar-world = Mundo
page-bar-worlds = Mundos
page-bar-own-worlds = Mis mundos
page-bar-edit-world = Editar el mundo
page-bar-language = Idioma
page-bar-theme = Tema
page-bar-help = Ayuda y ajustes
page-bar-more = Velocidad, robot y mundo
page-bar-state-idle = Listo
page-bar-state-starting = Iniciando
page-bar-state-running = En marcha
page-bar-state-paused = En pausa
page-bar-state-held = En pausa en un punto de interrupción
page-bar-state-input = Esperando tu respuesta
page-bar-state-ended = Terminado
