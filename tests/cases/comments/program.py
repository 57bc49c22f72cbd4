#!a heading
# The program's purpose.
from learnblock.robots.ebo import Robot

robot = Robot()

# about the first variable
first = 1  # one

# inside
second = [1, 2]  # behind
## main
## end
## # python


# right above the function
def f():  # its header
    # inside it
    pass  # nothing

    # at its end
    # after it


# loose
#
# main
# its header
# top of main
if first:  # a
    # b
    pass
    # c
elif second:  # d
    pass

    # e
else:  # f
    # g
    pass
    # h
# i
while True:
    break  # j
    # k

# l

# end
# after the end

# at the very end
