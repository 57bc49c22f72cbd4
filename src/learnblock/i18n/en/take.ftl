# Pages to take home, which show a run without LearnBlock.

take-home-no-world = A page to take home shows a simulated world, and this run had none. Run the program on a simulated robot.
take-home-changed = The program has changed since this run. Run it again, and then save the page.
