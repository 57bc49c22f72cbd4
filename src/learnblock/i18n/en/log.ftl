# The log of a run.

log-not-a-log = This is not the log of a run, or it is damaged.
log-not-a-file = { $file } is not the log of a run. Write one with: learnblock run PROGRAM --why FILE
log-too-large = { $file } is too large: a log has at most { $most } MiB.
log-no-world = This run had no simulated world: only what was recorded can be shown.
log-too-long = This run is too long to be shown again: the limit is { $most } s.
log-file-too-large = This log is too large to be opened: a file has at most { $most } MiB.
log-takes-too-long = It would take longer than { $most } s to show the world of this run.
