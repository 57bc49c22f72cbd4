# Una página que muestra una ejecución sin LearnBlock.

page-take-home-made = Hecha con LearnBlock. Todo está en este archivo.
page-take-home-by = de { $name }
page-take-home-play = Reproducir
page-take-home-pause = Pausa
page-take-home-program = Programa
page-take-home-nothing = El programa todavía no ha escrito nada.
