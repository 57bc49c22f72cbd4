# Pages to take home, which show a run without LearnBlock.

take-home-no-world = A page to take home shows a simulated world, and this run had none. Run the program on a simulated robot.
take-home-changed = The program has changed since this run. Run it again, and then save the page.
take-home-too-large = A page to take home has at most { $most } MB, and this run needs more. Save a shorter run.
