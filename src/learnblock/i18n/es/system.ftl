# Lo que le falta a este ordenador.

system-memory = No hay suficiente memoria. Cierra otros programas o páginas y vuelve a intentarlo.
system-threads = El ordenador no puede iniciar más procesos ni hilos. Cierra otros programas o páginas y vuelve a intentarlo.
system-files = Hay demasiados archivos y conexiones abiertos. Cierra otros programas o páginas y vuelve a intentarlo.
system-disk = El disco está lleno. Borra algo y vuelve a intentarlo.
system-quota = Has gastado todo el espacio de disco que puedes usar. Borra algo y vuelve a intentarlo.
