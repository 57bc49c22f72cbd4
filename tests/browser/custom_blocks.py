"""The dialogs for custom blocks, as a pupil uses them."""

import re

from playwright.sync_api import expect

#: Ten lines of Python.
ZIGZAG = '''\
from typing import Annotated

from learnblock.fields import Range


def zigzag(robot, corners: Annotated[int, Range(1, 5)] = 2) -> None:
    """Drive in a zigzag."""
    for corner in range(corners):
        robot.set_move(100, 40 if corner % 2 else -40)
        robot.sleep(0.5)
'''
USES_ZIGZAG = "main:\n    function.zigzag()\n    function.stop_bot()\nend\n"


class Bench:
    """The editor of custom blocks.

    Args:
        pupil: the pupil who uses it.
    """

    def __init__(self, pupil):
        self.pupil = pupil
        self.page = pupil.page

    @property
    def dialog(self):
        return self.pupil.dialog()

    @property
    def code(self):
        return self.dialog.get_by_role("textbox", name="Python")

    @property
    def problems(self):
        return self.dialog.get_by_role("status", name="Problems in the block")

    def list(self):
        """Open the list of custom blocks."""
        self.pupil.project("My blocks…")
        return self.dialog

    def new(self):
        """Start a new block."""
        self.list().get_by_role("button", name="New block").click()
        expect(self.code).to_contain_text("my_block")

    def edit(self, name):
        """Open a block from the list."""
        self.list().locator("button", has_text=name).first.click()
        expect(self.code).to_contain_text("def ")

    def write(self, source):
        """Replace the code."""
        self.code.click()
        self.page.keyboard.press("Control+a")
        self.page.keyboard.insert_text(source)

    def tab(self, name):
        self.dialog.get_by_role("tab", name=name).click()
        return self.dialog.get_by_role("tabpanel", name=name)

    def save(self):
        """Save the block, and wait until it is saved."""
        self.dialog.get_by_role("button", name="Save", exact=True).click()
        expect(self.dialog.get_by_text("saved. It is in the palette")).to_be_visible()
        expect(self.dialog.get_by_role("heading", name=re.compile("^Block "))).to_be_visible()

    def close(self):
        self.dialog.get_by_role("button", name="Close").click()
        expect(self.dialog).to_have_count(0)

    def make(self, source):
        """Create a block from Python code, and close the dialog."""
        self.new()
        self.write(source)
        name = source.partition("def ")[2].partition("(")[0]
        expect(self.dialog.get_by_role("textbox", name="File name")).to_have_value(name)
        self.save()
        self.close()

    def export(self, name):
        """Export a block; return the name and the content of the file."""
        with self.page.expect_download() as download:
            self.list().get_by_role("button", name=f"Export {name}", exact=True).click()
        self.close()
        return download.value.suggested_filename, download.value.path().read_bytes()

    def choose_import(self, filename, content):
        """Choose a file to import in the open list."""
        with self.page.expect_file_chooser() as chooser:
            self.dialog.get_by_role("button", name="Import…").click()
        file = {"name": filename, "mimeType": "application/json", "buffer": content}
        chooser.value.set_files([file])

    def uses(self, program, kind):
        """Write a program, and wait until its block appears."""
        self.pupil.begin()
        self.pupil.write("blocktext", program)
        expect(self.pupil.blocks(kind).first).to_be_visible()
