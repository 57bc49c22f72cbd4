# La cámara de EBO. $place es su dirección con su puerto.

ebo-camera-unreachable = La cámara de EBO no responde en { $place }. Pon en marcha la cámara de EBO, o pon 'camera_port' a 0 en los ajustes del robot para trabajar sin ella.
ebo-camera-silent = La cámara de EBO no ha enviado ninguna imagen desde { $place } en { $seconds } segundos. Pon en marcha la cámara de EBO, o pon 'camera_port' a 0 en los ajustes del robot para trabajar sin ella.
