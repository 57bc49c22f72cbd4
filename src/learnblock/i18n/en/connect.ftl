# Connecting to a real robot from the page, without a program.

connect-not-connected = No robot is connected. Choose one and connect.
connect-given-up = The robot's driver does not answer, so the connection was given up. The motors may still be running: switch the robot off.
connect-used-by-page = This robot is connected to another page. Disconnect it there first.
connect-used-by-run = A program is running on this robot. Stop the program first.
connect-wheels-stuck = The robot did not get where it should. Is something in its way, and do its wheels touch the floor?
connect-needs-no-correction = This robot measures its wheels itself, so there is nothing to correct.
