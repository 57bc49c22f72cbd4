# Imágenes de programas que la línea de órdenes dibuja con un navegador.

picture-no-browser = Dibujar bloques necesita Chrome, Edge o Chromium, y no hay ninguno instalado. Instala uno, o guarda la imagen en la página: Compartir, Imagen del programa.
picture-browser-failed = { $browser } no ha dibujado la imagen. Inténtalo de nuevo, o guarda la imagen en la página: Compartir, Imagen del programa.
picture-unknown-type = { $file } no es el nombre de una imagen. Termínalo en .svg o .png.
picture-unknown-sheet = { $file } no es un nombre de ficha. Termínalo en .html o .pdf.
