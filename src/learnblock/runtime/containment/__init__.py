"""What contains a pupil's program: the child puts itself behind a fence before it runs.

The host's thread gives up what its robot's driver does not need.

- `fence`: everything together, in the child.
- `driver`: the same for the thread that calls a driver, as far as the driver allows.
- `resources`: limits of memory, processor time and files, on every POSIX system.
- `landlock`, `paths`: the files it may read and write, on Linux.
- `seccomp`, `syscalls`: the system calls it may make, on Linux.
- `hook`: the same in Python, with messages that a person understands; on every system.
- `environment`, `scratch`: its variables and its temporary folder, prepared by the host.
- `survey`: which of these work on this computer, found by trying each one.
"""
