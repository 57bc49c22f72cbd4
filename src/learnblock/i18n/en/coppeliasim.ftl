# CoppeliaSim. $place is its address with its port.

coppeliasim-no-answer = Can't reach CoppeliaSim at { $place }. Is it running, with its ZeroMQ remote API server?
coppeliasim-not-coppeliasim = The answer from { $place } can't be read. Is CoppeliaSim 4.6 or later running there?
coppeliasim-too-old = CoppeliaSim at { $place } has no { $name }. Use CoppeliaSim 4.6 or later.
coppeliasim-closed = The connection to CoppeliaSim at { $place } is closed. Run the program again.
# $reason is CoppeliaSim's own message, in English.
coppeliasim-refused = CoppeliaSim at { $place } reported an error: { $reason }
# $answer is what CoppeliaSim answered to the function $name, shortened.
coppeliasim-bad-answer = CoppeliaSim at { $place } gave an unexpected answer to { $name }: { $answer }
coppeliasim-not-started = The simulation in CoppeliaSim at { $place } did not start. Does CoppeliaSim show an error?
coppeliasim-stopped = The simulation in CoppeliaSim at { $place } was stopped. Run the program again.
coppeliasim-no-object = The scene has no object { $path }. Change the setting '{ $setting }' to an object of the scene.
coppeliasim-no-script = The scene in CoppeliaSim has no object { $path } with LearnBlock's script. To add it, run: learnblock robots setup coppeliasim
coppeliasim-no-paper-script = The scene in CoppeliaSim has no object { $path } with the paper's script. Open the paper's scene, or change the setting 'scene' to script or names.
coppeliasim-script-failed = The script of { $path } could not run '{ $function }' ({ $reason }). Was the simulation stopped?
# Printed by learnblock robots setup coppeliasim, after the script was copied to $path.
coppeliasim-setup-done =
    The script is in { $path }
    In CoppeliaSim, with a scene that has a floor:
      1. Choose Add > Dummy, and rename the dummy to LearnBlock.
      2. Select it, then choose Add > Script > Simulation script > Non threaded > Lua
         (before version 4.7: Add > Associated child script > Non threaded > Lua).
      3. Double-click the script's icon, replace all of its text with the text of the file, and close it.
      4. Press play: a robot appears at the dummy. Save the scene.
    Then run: learnblock robots test coppeliasim
