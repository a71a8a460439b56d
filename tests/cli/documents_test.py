#!/usr/bin/env python3
"""What the command says of itself: completion, the manual page, examples, what was probably meant.

usage: documents_test.py SELVAGE
"""
import shutil
import subprocess
import sys
import tempfile
import unittest

SELVAGE = sys.argv.pop(1)


def run(*arguments):
    return subprocess.run([SELVAGE, *arguments], capture_output=True, text=True, timeout=60)


def subcommands():
    words = run("nonsense-that-resembles-nothing").stderr
    return words.partition("the subcommands are: ")[2].splitlines()[0].split()


class Completion(unittest.TestCase):
    def complete(self, *words):
        """What bash offers for the last word."""
        script = run("completion", "bash").stdout
        listed = " ".join(f"'{word}'" for word in words)
        code = f"{script}\nCOMP_WORDS=({listed}); COMP_CWORD={len(words) - 1}; _selvage; echo \"${{COMPREPLY[*]}}\""
        return subprocess.run(["bash", "-c", code], capture_output=True, text=True, check=True).stdout.split()

    def test_bash_completes_subcommands_options_and_values(self):
        self.assertCountEqual(self.complete("selvage", "comp"), ["compact", "compact-exactly", "completion"])
        self.assertEqual(self.complete("selvage", "compact", "--acc"), ["--accuracy"])
        self.assertEqual(self.complete("selvage", "compact", "--accuracy", ""), ["draft", "standard", "fine"])
        self.assertEqual(self.complete("selvage", "compact", "marker.js"), [])  # a file: left to the shell

    def test_every_shell_knows_every_subcommand(self):
        for shell in ("bash", "zsh", "fish"):
            script = run("completion", shell).stdout
            for name in subcommands():
                self.assertRegex(script, rf"\b{name}\b", shell)

    def test_another_shell_is_refused(self):
        ran = run("completion", "tcsh")
        self.assertEqual(ran.returncode, 2)
        self.assertIn("bash", ran.stderr)


class Manual(unittest.TestCase):
    def test_the_page_has_every_subcommand_and_formats_without_complaint(self):
        page = run("manual").stdout
        for name in subcommands():
            self.assertIn("\\fB" + name.replace("-", "\\-") + "\\fR", page)
        if not shutil.which("groff"):
            self.skipTest("groff is not installed")
        with tempfile.NamedTemporaryFile("w", suffix=".1") as file:
            file.write(page)
            file.flush()
            formatted = subprocess.run(["groff", "-man", "-ww", "-Tascii", "-P-cbou", file.name], capture_output=True, text=True)
        self.assertEqual(formatted.stderr, "")
        self.assertIn("--accuracy", formatted.stdout)


    def test_the_page_explains_common_options_once_and_gives_defaults(self):
        page = run("manual").stdout
        self.assertEqual(page.count("Write the resulting marker to this file"), 1)
        self.assertIn("Common options: \\fB\\-\\-out\\fR", page)
        self.assertIn("independent searches, 1 to 64, of which the best counts; they run in parallel.  Default: 1.", page)
        self.assertNotRegex(page, r"[a-z]keepPlaced|Not together with keepPlaced")


class Suggestions(unittest.TestCase):
    def test_misspelt_names_are_recognised(self):
        self.assertIn("did you mean compact?", run("compcat", "x.json").stderr)
        ran = run("compact", "--acuracy", "fine", "x.json")
        self.assertEqual(ran.returncode, 2)
        self.assertIn("--acuracy is not an option of compact; did you mean --accuracy?", ran.stderr)
        self.assertIn("--qqq is not an option of compact\n", run("compact", "x.json", "--qqq").stderr)

    def test_help_gives_examples(self):
        self.assertIn("Examples:\n  selvage compact marker.json", run("compact", "--help").stdout)


if __name__ == "__main__":
    unittest.main()
