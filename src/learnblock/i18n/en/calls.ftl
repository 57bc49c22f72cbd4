# The call graph of a run.

calls-layer-program = Program
calls-layer-functions = Own functions
calls-layer-skills = Skills
calls-layer-client = Generic client
calls-layer-devices = Devices
calls-layer-driver = Robot
# Behind a row of the table.
calls-shared = of all callers
calls-none = Nothing was called in this time.
calls-span = --to { $last } is before --from { $first }.
calls-differ = Only these rows differ: { $layers }.
calls-alike = All rows have the same functions.
calls-too-many = Give one log, or { $most } to see them side by side.
