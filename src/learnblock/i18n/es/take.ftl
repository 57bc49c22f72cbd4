# Páginas para llevar a casa, que muestran una ejecución sin LearnBlock.

take-home-no-world = Una página para llevar a casa muestra un mundo simulado, y esta ejecución no lo tenía. Ejecuta el programa en un robot simulado.
take-home-changed = El programa ha cambiado desde esta ejecución. Ejecútalo otra vez y guarda después la página.
take-home-too-large = Una página para llevar a casa tiene como máximo { $most } MB, y esta ejecución necesita más. Guarda una ejecución más corta.
