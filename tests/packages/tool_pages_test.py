#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What man pages and completion are made of: help texts as CLI11 prints them, with all that it puts into them, and
those that are refused."""
import sys
import unittest

sys.path.insert(0, sys.argv.pop())
from bash_completion import actions_of, alternatives, defined_words, typed_words  # noqa: E402
from help_text import Entry, parse  # noqa: E402
from man_page import escaped, man_page, value_marked  # noqa: E402

HELP = """\
Does this and that to files. See Fig. 2.
FILE is any file.
Usage: tool [OPTIONS] FILE...

Positionals:
  FILE TEXT ... REQUIRED      What is read

Options:
  -h,--help                   Print this help
  --jobs J:INT in [0 - 1024]  Threads (1)
  --count N Excludes: --seeds number of them
  --seeds FIRST:LAST Excludes: --count --jobs
                              both included
  --k-max FLOAT=2             Gate
  --a-very-long-name-of-an-option WORD
                              one of many


Group of others:
  --kind KIND                 Which: near | far (near) | PRESET | poly:K1,K2 | FILE.json

PRESET is one of red, blue,
green-blue.
EPCC_THING=5 changes a thing.
Exit codes: 0 done, 2 wrong usage (see above), 3 not
read.
"""


class HelpText(unittest.TestCase):
    def setUp(self):
        self.command = parse("tool", HELP)
        self.entries = {entry.names[-1]: entry for entry in self.command.options() + self.command.arguments()}

    def test_entries(self):
        self.assertEqual(self.entries["--help"].names, ["-h", "--help"])
        self.assertEqual(self.entries["--jobs"], Entry(["--jobs"], "J", "Threads (1)", ["0 to 1024."]))
        self.assertEqual(self.entries["--count"], Entry(["--count"], "N", "number of them",
                                                            ["Not together with --seeds."]))
        self.assertEqual(self.entries["--seeds"].text, "both included")
        self.assertEqual(self.entries["--seeds"].notes, ["Not together with --count, --jobs."])
        self.assertEqual(self.entries["--k-max"], Entry(["--k-max"], "F", "Gate", ["Default: 2."]))
        self.assertEqual(self.entries["--a-very-long-name-of-an-option"].text, "one of many")
        self.assertEqual(self.entries["FILE"].notes, ["Required."])
        self.assertEqual(list(self.command.sections), ["Positionals", "Options", "Group of others"])

    def test_texts(self):
        self.assertEqual(self.command.in_one_line(), "Does this and that to files")
        self.assertEqual(self.command.exit_codes(), [("0", "done"), ("2", "wrong usage (see above)"),
                                                     ("3", "not read")])
        self.assertEqual(self.command.remarks(), ["PRESET is one of red, blue,\ngreen-blue.",
                                                  "EPCC_THING=5 changes a thing."])

    def test_what_is_no_help_is_refused(self):
        for text in ("", "tool: broken\n", "Usage: tool\n", "Usage: tool\n  --stray  option\n",
                     HELP + "  an entry after the end\n"):
            with self.assertRaises(ValueError):
                parse("tool", text)


class Words(unittest.TestCase):
    def test_choices(self):
        command = parse("tool", HELP)
        words = defined_words(command)
        self.assertEqual(words, {"PRESET": ["red", "blue", "green-blue"]})
        kind = command.sections["Group of others"][0]
        self.assertEqual(actions_of(kind, words, "tool"),
                         ["_epcc_words near far red blue green-blue poly:", "_epcc_files json"])
        self.assertEqual(alternatives("no choice at all"), [])
        self.assertEqual(typed_words(["white:PRESET", "X", "A,B"], words),
                         ["white:red", "white:blue", "white:green-blue"])

    def test_files_and_folders(self):
        def actions(name, value, text):
            return actions_of(Entry([name], value, text), {}, "tool")

        self.assertEqual(actions("--mesh", "OUT.ply", "Mesh, .ply or .obj"), ["_epcc_files ply obj"])
        self.assertEqual(actions("--out", "DIR", "Folder"), ["_epcc_folders"])
        self.assertEqual(actions("--fx", "F", "Focal length, pixels"), [])
        self.assertEqual(actions("INPUT", "", "Files and folders to segment"), ["_epcc_files"])


class ManPage(unittest.TestCase):
    def test_page(self):
        page = man_page(parse("tool", HELP), "1.2.3", ["tool", "other"])
        for line in (".SH NAME", "tool \\- does this and that to files", ".B tool", ".SS Group of others",
                     "\\fB\\-h\\fR, \\fB\\-\\-help\\fR", ".B EPCC_THING", ".B 3", "Not read.", ".BR other (1)"):
            self.assertIn(line, page.split("\n"))

    def test_roff_is_escaped(self):
        self.assertEqual(escaped(".x 'y\n'z \\"), "\\&.x \\(aqy\n\\&\\(aqz \\e")
        self.assertEqual(value_marked("NAME.json"), "\\fINAME\\fR\\&.\\fBjson\\fR")


if __name__ == "__main__":
    unittest.main()
