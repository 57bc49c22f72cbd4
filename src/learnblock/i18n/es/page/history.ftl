# Versiones y ejecuciones de un proyecto.

page-history-title = Historial
page-history-versions = Versiones
page-history-runs = Ejecuciones
page-history-no-versions = Aún no hay versiones. LearnBlock guarda una en cada ejecución.
page-history-no-runs = El programa aún no se ha ejecutado.
page-history-restore = Restaurar
page-history-restore-of = Restaurar la versión de { $date }
page-history-lines = { $lines ->
    [one] 1 línea
   *[other] { $lines } líneas
    }
page-history-reason-run = Antes de una ejecución
page-history-reason-time = Guardada automáticamente
page-history-reason-restored = Antes de restaurar
page-history-reason-outside = Cambiada por otro programa
page-history-reason-conflict = El otro cambio de la misma línea
