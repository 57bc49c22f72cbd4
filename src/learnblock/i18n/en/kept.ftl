# Kept runs of a project.

kept-no-such = This run is not kept any more.
kept-no-room = A project keeps at most { $most } runs with a name, and { $size } MB of them. Delete one first.
kept-no-project = There is no project { $name }. Open it again.
kept-upload-busy = Other files are still being opened. Wait until they are done and try again.
kept-upload-slow = The file did not arrive in time. Try again.
# What can't be shown of a run that was opened; $robot is a robot's id.
kept-world-missing = The world "{ $world }" of this run, or its robot { $robot }, is not on this computer: only what was recorded is shown.
kept-real-robot = This run was on a real robot ({ $robot }): only what was recorded is shown.
