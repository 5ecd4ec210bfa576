"""Tries every line of docs/python.md: documents.py FILE. It runs where the project's root is."""

import doctest
import sys

failed, tried = doctest.testfile(sys.argv[1], module_relative=False, optionflags=doctest.FAIL_FAST)
sys.exit(failed > 0 or tried < 20)
