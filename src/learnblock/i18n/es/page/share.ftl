# Imágenes y películas del mundo.

page-share-picture = Guardar imagen
page-share-film = Filmar una ejecución
page-share-filming = Filmando
page-share-saved = Película guardada.
page-share-no-film = Este navegador no puede hacer películas. Guarda una imagen o usa un navegador más reciente.
