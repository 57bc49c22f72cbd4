# El grafo de llamadas de una ejecución.

calls-layer-program = Programa
calls-layer-functions = Funciones propias
calls-layer-skills = Habilidades
calls-layer-client = Cliente genérico
calls-layer-devices = Dispositivos
calls-layer-driver = Robot
# Detrás de una fila de la tabla.
calls-shared = de todos los que llaman
calls-none = En ese tiempo no se llamó a nada.
calls-span = --to { $last } es anterior a --from { $first }.
calls-differ = Solo estas filas son distintas: { $layers }.
calls-alike = Todas las filas tienen las mismas funciones.
calls-too-many = Da un registro, o { $most } para verlos uno al lado del otro.
