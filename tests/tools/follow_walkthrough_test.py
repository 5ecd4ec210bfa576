"""tools/follow_walkthrough does what is written and stops, at its line, at what is not so."""

import importlib.machinery
import importlib.util
import pathlib
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).parents[2]
LOADER = importlib.machinery.SourceFileLoader("follower", str(PROJECT / "tools/follow_walkthrough"))
follower = importlib.util.module_from_spec(importlib.util.spec_from_loader("follower", LOADER))
LOADER.exec_module(follower)

CREATE = "Create `a.txt`:\n\n```text create a.txt\none\ntwo\n```\n"
FIND = "In `a.txt`, find\n\n```text find a.txt\n{}\n```\n\nand make it\n\n```text replace\n{}\n```\n"
RUN = "```sh run\n{}\n```\n"
OUTPUT = "```text output\n{}\n```\n"


class FollowWalkthrough(unittest.TestCase):
    def fault(self, text):
        """(line, words) of the fault, or None; nothing is compiled."""
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text(text)
            copy = pathlib.Path(folder) / "copy"
            copy.mkdir()
            try:
                follower.follow(page, None, copy)
            except follower.Fault as fault:
                return fault.line, str(fault)
        return None

    def assert_fault(self, text, line, words):
        found = self.fault(text)
        self.assertIsNotNone(found)
        self.assertEqual(found[0], line)
        self.assertIn(words, found[1])

    def test_followed(self):
        self.assertIsNone(self.fault(CREATE + FIND.format("two", "three") + RUN.format("cat a.txt")
                                     + OUTPUT.format("one\nthree")))

    def test_blocks_to_be_read(self):
        self.assertIsNone(self.fault("```cpp\nint i;\n```\n\n```\nfree text\n```\n"))

    def test_other_output(self):
        self.assert_fault(CREATE + RUN.format("cat a.txt") + OUTPUT.format("one"), 10, "something else")

    def test_failing_command(self):
        self.assert_fault(RUN.format("true\nfalse"), 1, "`false` exits with 1")

    def test_text_that_is_not_there_once(self):
        self.assert_fault(CREATE + FIND.format("three", "four"), 9, "0 times")
        self.assert_fault(CREATE.replace("two", "one") + FIND.format("one", "four"), 9, "2 times")

    def test_file_that_is_there_or_not(self):
        self.assert_fault(CREATE + CREATE, 9, "exists already")
        self.assert_fault(FIND.format("two", "three"), 3, "there is no a.txt")

    def test_prose_names_the_file(self):
        self.assert_fault("Create `b.txt`:\n\n```text create a.txt\n```\n", 3, "does not name `a.txt`")

    def test_words_and_order(self):
        self.assert_fault("```sh execute\ntrue\n```\n", 1, "nothing that can be done")
        self.assert_fault("```text output\n```\n", 1, "no command")
        self.assert_fault("```text replace\n```\n", 1, "come together")
        self.assert_fault(CREATE + "In `a.txt`\n```text find a.txt\ntwo\n```\n", 8, "come together")
        self.assert_fault("```sh run\ntrue\n", 1, "no end")


if __name__ == "__main__":
    unittest.main()
