#!/usr/bin/env python3
"""tools/api_reference: what it makes of a small tree, and that a name without a comment fails."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIMN = """#pragma once
/// The library.

// Numbers.
#include "limn/number.h"
"""
NUMBER = """#pragma once
/// Numbers, *all* of them. More words.

namespace limn {

/// The number after n.
int next(int n);

namespace detail {
int hidden();
}  // namespace detail

}  // namespace limn
"""


class ApiReference(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.tree = pathlib.Path(self.folder.name)
        for name in ("tools/api_reference", "docs/Doxyfile"):
            (self.tree / name).parent.mkdir()
            shutil.copy(ROOT / name, self.tree / name)
        (self.tree / "cmake").mkdir()
        (self.tree / "cmake/public_headers.txt").write_text("# headers\nlimn/limn.h\nlimn/number.h\n")
        (self.tree / "src/limn").mkdir(parents=True)
        (self.tree / "src/limn/limn.h").write_text(LIMN)

    def run_on(self, number):
        (self.tree / "src/limn/number.h").write_text(number)
        return subprocess.run([sys.executable, self.tree / "tools/api_reference", self.tree / "out"],
                              capture_output=True, text=True)

    def test_first_page_lists_the_headers_by_purpose(self):
        done = self.run_on(NUMBER)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(pathlib.Path(done.stdout.strip()), (self.tree / "out/html/index.html").resolve())
        page = (self.tree / "out/html/index.html").read_text()
        self.assertIn("Numbers", page)
        self.assertIn("limn/number.h", page)
        self.assertNotIn("More words", page)

    def test_a_name_without_a_comment_fails(self):
        done = self.run_on(NUMBER.replace("/// The number after n.\n", ""))
        self.assertEqual(done.returncode, 1)
        self.assertIn("next(int n)", done.stderr)


if __name__ == "__main__":
    if not shutil.which("doxygen"):
        print("skipped: there is no doxygen")
        sys.exit(77)
    unittest.main()
