# Connecting to a real robot from the page, without a program.

connect-not-connected = No robot is connected. Choose one and connect.
connect-given-up = The robot's driver does not answer, so the connection was given up. The motors may still be running: switch the robot off.
connect-used-by-page = This robot is connected to another page. Disconnect it there first.
connect-used-by-run = A program is running on this robot. Stop the program first.
connect-wheels-stuck = The robot did not get where it should. Is something in its way, and do its wheels touch the floor?
connect-needs-no-correction = This robot measures its wheels itself, so there is nothing to correct.

# Installing what a robot needs besides LearnBlock.
connect-installs-another = The add-on for '{ $robot }' is still being installed. Wait until it is done, or stop it.
connect-not-ours-to-install = Other people use this installation of LearnBlock, too. Ask its administrator to install the add-on for '{ $robot }'.
connect-no-installer = The installer '{ $name }' was not found on this computer. Use the command below in a terminal in which you have installed LearnBlock.
connect-install-offline = This computer can't reach the package index. Connect it to the Internet, then try again.
connect-install-failed = The add-on could not be installed. The installer says: { $reason }
connect-install-too-long = Installing the add-on took over { $minutes } minutes, so it was stopped. Try again on a faster network.
connect-installed-restart = The add-on is installed. Restart LearnBlock to use it.
