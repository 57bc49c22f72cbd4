# What this computer lacks. Shown by themselves, or as the reason at the end of another sentence.

system-memory = There is not enough memory. Close other programs or pages, then try again.
system-threads = The computer can't start any more processes or threads. Close other programs or pages, then try again.
system-files = Too many files and connections are open. Close other programs or pages, then try again.
system-disk = The disk is full. Delete something, then try again.
system-quota = You have used all the disk space that you may use. Delete something, then try again.
