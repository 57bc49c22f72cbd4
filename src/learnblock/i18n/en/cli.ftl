# The output of the command line.

# $reason is the operating system's.
cli-file-error = { $file }: { $reason }
cli-system-error = { $reason }
cli-no-file = There is no file { $file }.
cli-wrote = Wrote { $file }
cli-stop-with-ctrl-c = Press Ctrl-C to stop.

# $value is a setting's default.
cli-default = default: { $value }
cli-default-without-value = --default takes the name of a setting, without a value.
cli-value-or-default = Give either a value or --default.

cli-formatted = Formatted { $file }
cli-would-change = Would change { $file }
cli-format-only-block-text = { $file } is not a Block-Text file (.bt). Use a Python formatter for Python files.

# In the list of robots, instead of devices.
cli-devices-by-settings = (depends on its settings)
cli-robot-scan-late = The driver of '{ $robot }' does not stop looking for robots, so it was left out.
cli-robot-without-settings = The robot '{ $robot }' has no settings: it is simulated.
cli-robot-needs-add-on = needs an add-on that is not installed: { $command }
cli-no-robot-found = No robot answered. Is it switched on, and is this computer on its network?
# Results of a device's test, in a column of nine characters.
cli-device-works = works
cli-device-fails = FAILS
cli-device-skipped = skipped
# Followed by the commands that configure and use the emulated robot.
cli-emulating = Emulating { $robot }. Connect a program to it with:

cli-skill-block = {"  "}Block: { $label }
cli-skill-returns = {"  "}Returns: { $kind ->
    [value] a value
   *[nothing] nothing
}
cli-skill-needs = {"  "}Needs: { $devices }
cli-skill-needs-nothing = {"  "}Needs: no device
cli-one-or-all-robots = Choose one of '--robot' and '--all-robots'.
# $devices: noun phrases from check-device
cli-served-by = { $devices }
cli-served-by-nothing = no { $devices }
cli-served-by-no-robot = None of LearnBlock's robots has this. A robot of your own can: see docs/add-a-robot.md.

cli-blocks-none = You have no custom blocks yet. Make one on the page, or run: learnblock blocks import FILE

cli-library-broken = broken: { $problem }
cli-library-none = No libraries are installed. Install one with: learnblock library import FILE
cli-library-imported = Imported { $name } { $version }: { $skills }
cli-library-unchanged = Already installed: { $name } { $version }: { $skills }
cli-library-removed = Removed { $name }
cli-library-rename-unknown = --rename { $skill }: none of these libraries has this skill.
cli-library-rename-format = --rename { $given }: write SKILL=NEW, such as waltz=ball_waltz.
cli-library-exists = { $path } already exists. Add --replace, or choose another --name.
cli-library-other-folder = { $path } is a folder that is not a library. Choose another --name.

cli-tags-imported = { $count ->
    [one] Imported one tag name from { $file }
   *[other] Imported { $count } tag names from { $file }
}
cli-tags-print = Open { $file } in a browser and print it at 100 %.

# Followed by commands.
cli-new-next = Next:
cli-new-robot-test = The test lists the functions that you still have to write, and what each must do.
cli-new-skill = Next, change what the skill does. In Block-Text, it is { $call }.

cli-no-problems = { $file }: no problems

cli-emotions-question = Turn it on for all real cameras?

cli-take-over-or-read-only = Give either --take-over or --read-only.
cli-folder-choices =
    {"  "}1  Take over: the other LearnBlock saves everything and ends.
    {"  "}2  Read only: open and run projects here; changes are not saved.
cli-folder-choice = 1 or 2 (Ctrl-C to quit)
