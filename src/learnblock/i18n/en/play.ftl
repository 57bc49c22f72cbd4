# Running a program from the page, and moving its robot by hand.

play-robot-moves = The robot is moving. Pause or stop the program before you place it.
play-program-running = A program is running. Stop it first.
play-no-question = The program is not waiting for an answer.
play-no-robot = No robot is ready. Choose a robot in the bar.
play-nothing-to-look-back-at = There is nothing to look back at. Run the program first.
# $reason is the text of an unexpected error of a driver, or what the computer lacks.
play-not-started = The program could not be run: { $reason }
# It did not stop, was killed, and something in LearnBlock still hangs.
play-given-up = The program was killed, because it did not stop. You can run it again.
play-given-up-real = The program was killed, but its robot does not answer. Its motors may still be running: switch it off.
play-lost = The run ended unexpectedly. There may not be enough memory: close other programs or pages, then run the program again.

# A custom block that is tried; $function is its name.
play-no-function = This block has no function that takes the robot. Write one first.
play-wrong-count =
    { $most ->
        [0] The function '{ $function }' takes no values, but got { $count }.
       *[other]
            { $least ->
                [one] The function '{ $function }' takes at least 1 value and at most { $most }, but got { $count }.
               *[other] The function '{ $function }' takes { $least } to { $most } values, but got { $count }.
            }
    }
play-bad-number = { $value } is not a number that a block can use.
play-bad-value = A block can only use numbers, text, lists, true and false.
