# A lesson on paper.

page-worksheet-name = Nombre:
page-worksheet-step = { $number }. { $title }
page-worksheet-goals = Metas:
page-worksheet-cut = Recorta estos bloques y ponlos en orden. Los que van dentro de otro se ponen en su hueco.
page-worksheet-write = Escribe tu programa, un bloque en cada línea:
page-worksheet-notes = Escribe lo que ves y lo que piensas:
page-worksheet-solutions = Soluciones: { $title }
page-worksheet-answer = Respuesta:
