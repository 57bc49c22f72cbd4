# Settings of robots and of camera recognition, on the page and in settings.toml.

settings-simulated = El robot '{ $robot }' es simulado, así que no tiene ajustes.
settings-agree-first = Lee antes el texto sobre las emociones con cámaras reales y acéptalo.
settings-device = '{ $value }' no es un dispositivo. En la página, escribe un dispositivo como /dev/ttyACM0 o COM3.
settings-video = No hay ningún vídeo '{ $name }' en { $folder }. Pon antes el vídeo en esa carpeta.
