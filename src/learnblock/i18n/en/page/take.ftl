# A page that shows a run without LearnBlock.

page-take-home-made = Made with LearnBlock. Everything is in this file.
page-take-home-by = by { $name }
page-take-home-play = Play
page-take-home-pause = Pause
page-take-home-program = Program
page-take-home-nothing = The program has printed nothing so far.
