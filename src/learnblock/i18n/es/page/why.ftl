# Preguntas sobre una ejecución.

page-why-none = Ejecuta el programa y pregunta después por qué el robot hizo lo que hizo.
page-why-search = Buscar en las preguntas
page-why-happened = Lo que pasó
page-why-did-not = Lo que no pasó
page-why-values = Variables
page-why-lines = Líneas
page-why-back = Todas las preguntas
page-why-more = { $count ->
    [one] Una razón más
   *[other] { $count } razones más
}
page-why-look = Ver { $seconds } s
page-why-block = Mostrar el bloque
page-why-goal = ¿Por qué?
page-why-ask-block = ¿Por qué se ejecutó o no?
page-why-goal-missed = Objetivo no alcanzado. ¿Por qué?
page-why-robot = ¿Por qué hace esto el robot?
page-why-moment = Otras preguntas sobre este momento
page-why-variable = ¿Por qué está así?
page-why-printed = ¿Por qué se escribió esto?
page-why-mark = { $what }: ¿por qué?
# $subject es un bloque con sus propias palabras; $time es, por ejemplo, " a los 2.5 s".
page-why-ask-print-block = ¿Por qué escribió su texto el bloque «{ $subject }»{ $time }?
page-why-ask-not-print-block = ¿Por qué no escribió su texto el bloque «{ $subject }»{ $time }?
page-why-ask-line-block = ¿Por qué se ejecutó el bloque «{ $subject }»{ $time }?
page-why-ask-not-line-block = ¿Por qué no se ejecutó el bloque «{ $subject }»{ $time }?
