"""The system calls that a program needs, with their numbers on each architecture.

Every other call is refused. The numbers are from <asm/unistd_64.h> and <asm-generic/unistd.h>, and
never change; "-" means that an architecture does not have the call.
"""

#: The name of each architecture, as reported by `os.uname`, and the kernel's number for it.
PROCESSORS = {"x86_64": 0xC000003E, "aarch64": 0xC00000B7}
#: The last call that was known when the lists were made. Later calls are reported to a program as
#: missing, so that its C library uses older ones.
LAST_KNOWN = 462

_ALLOWED = """
# calls to the host, and the clock
futex 202 98, sendto 44 206, recvfrom 45 207, read 0 63, write 1 64, poll 7 -, ppoll 271 73,
clock_gettime 228 113, clock_nanosleep 230 115, nanosleep 35 101, sched_yield 24 124
# reading and writing open files
close 3 57, close_range 436 436, lseek 8 62, pread64 17 67, pwrite64 18 68, readv 19 65,
writev 20 66, preadv 295 69, pwritev 296 70, preadv2 327 286, pwritev2 328 287, fsync 74 82,
fdatasync 75 83, sync_file_range 277 84, fadvise64 221 223, readahead 187 213,
sendfile 40 71, copy_file_range 326 285, dup 32 23, dup2 33 -, dup3 292 24, fcntl 72 25,
ioctl 16 29, pipe 22 -, pipe2 293 59, getdents 78 -, getdents64 217 61, ftruncate 77 46,
fallocate 285 47
# files by name: Landlock decides which
open 2 -, openat 257 56, creat 85 -, stat 4 -, fstat 5 80, lstat 6 -, newfstatat 262 79,
statx 332 291, access 21 -, faccessat 269 48, faccessat2 439 439, readlink 89 -,
readlinkat 267 78, getcwd 79 17, chdir 80 49, fchdir 81 50, umask 95 166, statfs 137 43,
fstatfs 138 44, mkdir 83 -, mkdirat 258 34, rmdir 84 -, unlink 87 -, unlinkat 263 35,
rename 82 -, renameat 264 38, renameat2 316 276
# waiting for several things
select 23 -, pselect6 270 72, epoll_create 213 -, epoll_create1 291 20, epoll_ctl 233 21,
epoll_wait 232 -, epoll_pwait 281 22, epoll_pwait2 441 441, eventfd 284 -, eventfd2 290 19,
timerfd_create 283 85, timerfd_settime 286 86, timerfd_gettime 287 87, signalfd 282 -,
signalfd4 289 74
# memory
brk 12 214, mmap 9 222, munmap 11 215, mremap 25 216, mprotect 10 226, madvise 28 233,
mincore 27 232, msync 26 227, mlock 149 228, munlock 150 229, mlock2 325 284, mseal 462 462
# threads
membarrier 324 283, rseq 334 293, set_robust_list 273 99, get_robust_list 274 100,
set_tid_address 218 96, futex_waitv 449 449, futex_wake 454 454, futex_wait 455 455,
futex_requeue 456 456, arch_prctl 158 -, clone 56 220, clone3 435 435, exit 60 93,
exit_group 231 94
# its own signals and alarms
rt_sigaction 13 134, rt_sigprocmask 14 135, rt_sigreturn 15 139, rt_sigsuspend 130 133,
rt_sigtimedwait 128 137, rt_sigpending 127 136, sigaltstack 131 132, kill 62 129,
tgkill 234 131, rt_tgsigqueueinfo 297 240, restart_syscall 219 128, alarm 37 -, pause 34 -,
getitimer 36 102, setitimer 38 103, wait4 61 260, waitid 247 95
# what it may ask
time 201 -, gettimeofday 96 169, clock_getres 229 114, times 100 153, getrusage 98 165,
sysinfo 99 179, uname 63 160, getcpu 309 168, getrandom 318 278, getpid 39 172,
getppid 110 173, gettid 186 178, getuid 102 174, geteuid 107 175, getgid 104 176,
getegid 108 177, getresuid 118 148, getresgid 120 150, getgroups 115 158, getrlimit 97 163,
prlimit64 302 261, prctl 157 167, getpriority 140 141, sched_getaffinity 204 123,
sched_getparam 143 121, sched_getscheduler 145 120, sched_get_priority_max 146 125,
sched_get_priority_min 147 126
# a pair of connected sockets, such as asyncio's
socketpair 53 199, getsockopt 55 209, getsockname 51 204, getpeername 52 205,
shutdown 48 210
"""

# Only if the user has allowed the network.
_NETWORK = """
socket 41 198, connect 42 203, bind 49 200, listen 50 201, accept 43 202, accept4 288 242,
sendmsg 46 211, sendmmsg 307 269, recvmsg 47 212, recvmmsg 299 243, setsockopt 54 208
"""


# What a driver does not need. Starting programs, with the calls that also start threads:
_PROGRAMS = """
execve 59 221, execveat 322 281, fork 57 -, vfork 58 -, clone 56 220, clone3 435 435
"""
_SOCKETS = "socket 41 198"
# Landlock does not look at these, and at `truncate` only since Linux 6.2.
_ATTRIBUTES = """
truncate 76 45, chmod 90 -, fchmod 91 52, fchmodat 268 53, fchmodat2 452 452, chown 92 -,
fchown 93 55, lchown 94 -, fchownat 260 54, utime 132 -, utimes 235 -, futimesat 261 -,
utimensat 280 88, setxattr 188 5, lsetxattr 189 6, fsetxattr 190 7, removexattr 197 14,
lremovexattr 198 15, fremovexattr 199 16
"""
# Ways around the others: calls that the kernel makes itself, and other processes' memory.
_DETOURS = "io_uring_setup 425 425, ptrace 101 117, process_vm_writev 311 271"


def numbers(processor: str, *, network: bool) -> dict[str, int]:
    """The numbers of all calls allowed to a program on this architecture, most frequent first."""
    return _numbers(processor, _ALLOWED + _NETWORK * network)


def refused(processor: str, *, network: bool, programs: bool, files: bool) -> dict[str, int]:
    """The numbers of the calls refused to a driver on this architecture.

    Args:
        processor: the architecture.
        network: whether it may open sockets.
        programs: whether it may start programs.
        files: whether it may change files.
    """
    groups = [_DETOURS]
    groups += [] if network else [_SOCKETS]
    groups += [] if programs else [_PROGRAMS]
    groups += [] if files else [_ATTRIBUTES]
    return _numbers(processor, ",\n".join(groups))


def _numbers(processor: str, listing: str) -> dict[str, int]:
    column = 1 + list(PROCESSORS).index(processor)
    lines = listing.splitlines()
    listed = ",".join(line for line in lines if line and not line.startswith("#"))
    rows = [row.split() for row in listed.split(",") if row.strip()]
    return {row[0]: int(row[column]) for row in rows if row[column] != "-"}
