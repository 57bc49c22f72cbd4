# CoppeliaSim. $place es su dirección con su puerto.

coppeliasim-no-answer = CoppeliaSim no responde en { $place }. ¿Está en marcha, con su servidor de la API remota de ZeroMQ?
coppeliasim-not-coppeliasim = No se puede leer la respuesta de { $place }. ¿Está en marcha ahí CoppeliaSim 4.6 o posterior?
coppeliasim-too-old = CoppeliaSim en { $place } no tiene { $name }. Usa CoppeliaSim 4.6 o posterior.
coppeliasim-closed = La conexión con CoppeliaSim en { $place } está cerrada. Ejecuta el programa otra vez.
coppeliasim-refused = CoppeliaSim en { $place } ha informado de un error: { $reason }
coppeliasim-bad-answer = CoppeliaSim en { $place } ha dado una respuesta inesperada a { $name }: { $answer }
coppeliasim-not-started = La simulación de CoppeliaSim en { $place } no ha arrancado. ¿Muestra CoppeliaSim un error?
coppeliasim-stopped = Se ha parado la simulación de CoppeliaSim en { $place }. Ejecuta el programa otra vez.
coppeliasim-no-object = La escena no tiene ningún objeto { $path }. Cambia el ajuste '{ $setting }' por un objeto de la escena.
coppeliasim-no-script = La escena de CoppeliaSim no tiene ningún objeto { $path } con el script de LearnBlock. Para añadirlo, ejecuta: learnblock robots setup coppeliasim
coppeliasim-no-paper-script = La escena de CoppeliaSim no tiene ningún objeto { $path } con el script del artículo. Abre la escena del artículo, o cambia el ajuste 'scene' a script o names.
coppeliasim-script-failed = El script de { $path } no ha podido ejecutar '{ $function }' ({ $reason }). ¿Se ha parado la simulación?
coppeliasim-setup-done =
    El script está en { $path }
    En CoppeliaSim, con una escena que tenga suelo:
      1. Elige Add > Dummy, y cambia el nombre del dummy a LearnBlock.
      2. Selecciónalo y elige Add > Script > Simulation script > Non threaded > Lua
         (antes de la versión 4.7: Add > Associated child script > Non threaded > Lua).
      3. Haz doble clic en el icono del script, cambia todo su texto por el del archivo y ciérralo.
      4. Pulsa play: aparece un robot donde está el dummy. Guarda la escena.
    Después ejecuta: learnblock robots test coppeliasim
