"""A watcher of runs that records what it receives."""

from learnblock.runtime.watcher import Watcher


class Listener(Watcher):
    """Records prints, and answers questions from a list."""

    def __init__(self, answers=()):
        self.text, self.numbers, self.answers, self.states = [], [], list(answers), []

    def printed(self, text):
        self.text.append(text)

    def line(self, number):
        self.numbers.append(number)

    def input(self, prompt):
        self.text.append(prompt)
        return self.answers.pop(0) if self.answers else None

    def state(self, state):
        self.states.append(str(state))
