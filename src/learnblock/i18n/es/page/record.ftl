# A pupil over weeks: lessons, stars, hints, hand-ins and aims; for pupil, teacher and parents.

page-record-title = Progreso individual
page-record-own = Mi progreso
page-record-of-pupil = Progreso
page-record-back = Mis proyectos
page-record-print = Imprimir
page-record-print-meeting = Imprimir para la reunión
page-record-delete = Borrar…
page-record-refused = Este progreso solo lo puede ver la persona a la que pertenece y su profe. Vuelve a entrar en la clase o abre antes el panel.
page-record-lost = La clase no responde. ¿Está abierta? Recarga la página para volver a intentarlo.
page-record-none = Todavía no ha empezado ninguna lección.
page-record-finished = Lecciones acabadas
# $count is the number of lessons that were begun.
page-record-of-begun = de { $count } empezadas
page-record-of = de { $count }
page-record-hints = Pistas
page-record-no-hints = ninguna
page-record-in-lessons = { $count ->
        [one] en 1 lección
       *[other] en { $count } lecciones
    }
# How many hand-ins were improved after they were handed back.
page-record-improved = { $count ->
        [one] 1 mejorada
       *[other] { $count } mejoradas
    }
page-record-lessons = Lección a lección
page-record-date = Fecha
page-record-step = paso { $step } de { $steps }
page-record-waits = entregada
page-record-aims = Objetivos
page-record-aims-from = según lo que hicieron los programas
# $lesson is the title of a lesson.
page-record-shown = Demostrado en { $lesson }
page-record-on-the-way = En camino: { $stars } de { $all } estrellas en { $lesson }
# The dates of a term choose what is counted.
page-record-term = Trimestre
page-record-term-help = Cuenta las lecciones en las que se trabajó por última vez entre estas fechas, y lo que se entregó entonces.
page-record-from = Desde
page-record-to = Hasta
page-record-always = Todas las fechas
page-record-none-then = Entre estas fechas no hay nada.
page-record-standards = Estándares
page-record-all-standards = Todos los estándares
