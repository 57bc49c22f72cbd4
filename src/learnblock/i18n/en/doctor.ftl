# The command doctor: what contains programs on this computer.

doctor-title = What contains the programs of robots on this computer:
# $name is what a program tried, $reason what held it.
doctor-contained = {"  "}refused{"  "}{ $name }: { $reason }
# $name is what a program tried, $reason why nothing held it.
doctor-not-contained = {"  "}ALLOWED{"  "}{ $name }: { $reason }
doctor-advice = Run only programs that you trust on this computer.

doctor-read = Read files that are not its own
doctor-write = Write outside its temporary folder
doctor-network = Use the network
doctor-processes = Start other programs
doctor-signals = Stop other programs
doctor-memory = Use all of the memory
doctor-variables = See your environment variables
doctor-driver-write = Write files through a robot's driver
doctor-driver-network = Use the network through a driver that does not need it
doctor-driver-processes = Start other programs through a driver that does not need any

# $version is a number.
doctor-by-landlock = by Landlock (version { $version }) in the Linux kernel
# $kernel is the version of the kernel.
doctor-no-landlock = this Linux kernel ({ $kernel }) offers no Landlock, which needs Linux 5.13 or newer and must be enabled
doctor-by-seccomp = by seccomp in the Linux kernel
# $machine is a kind of processor.
doctor-no-seccomp = seccomp is missing, or this processor ({ $machine }) is not supported
doctor-by-limit = limited by the operating system
doctor-no-limit = this operating system does not limit it
doctor-by-start = programs get a clean environment
# $system is Darwin or Windows.
doctor-other-system = on { $system }, only Python itself refuses it, which a program can get around
doctor-other-system-driver = on { $system }, nothing refuses it to drivers
