#!/usr/bin/env python3
"""The command's own documentation: completion, the manual page, examples, and suggestions for misspelt names.

usage: documents_test.py SELVAGE
"""
import re
import shlex
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
        """The completions that bash offers for the last word."""
        script = run("completion", "bash").stdout
        listed = " ".join(f"'{word}'" for word in words)
        code = f"{script}\nCOMP_WORDS=({listed}); COMP_CWORD={len(words) - 1}; _selvage; echo \"${{COMPREPLY[*]}}\""
        return subprocess.run(["bash", "-c", code], capture_output=True, text=True, check=True).stdout.split()

    def test_bash_completes_subcommands_options_and_values(self):
        self.assertCountEqual(self.complete("selvage", "comp"), ["compact", "compact-exactly", "completion"])
        self.assertEqual(self.complete("selvage", "compact", "--acc"), ["--accuracy"])
        self.assertEqual(self.complete("selvage", "compact", "--accuracy", ""), ["draft", "standard", "fine"])
        self.assertEqual(self.complete("selvage", "compact", "marker.js"), [])  # a file: left to the shell
        self.assertEqual(self.complete("selvage", "--server", "localhost:7171", "compact", "--acc"), ["--accuracy"])

    def test_bash_completes_the_first_words_of_a_command(self):
        self.assertEqual(self.complete("selvage", "call", "motion.com"), ["motion.compact"])
        self.assertEqual(self.complete("selvage", "library", ""), ["add", "list", "search"])
        self.assertEqual(self.complete("selvage", "completion", "f"), ["fish"])

    def test_zsh_and_fish_understand_their_scripts(self):
        for shell in ("zsh", "fish"):
            if not shutil.which(shell):
                continue
            script = run("completion", shell).stdout
            read = subprocess.run([shell, "-n", "/dev/stdin"], input=script, capture_output=True, text=True)
            self.assertEqual((read.returncode, read.stderr), (0, ""), shell)
        self.assertIn("HOST\\:PORT", run("completion", "zsh").stdout)

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
        self.assertIn("searches, 1 to 64, which run in parallel; the best result is used.  When absent, as many", page)
        self.assertIn("The seed of the random choices.  Default: 1.", page)
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

    def test_every_subcommand_has_examples_that_are_command_lines(self):
        for name in subcommands():
            shown = run(name, "--help").stdout
            examples = [line.strip() for line in shown.partition("Examples:\n")[2].partition("\n\n")[0].splitlines()]
            self.assertTrue(examples, name)
            for example in examples:
                words = shlex.split(re.split(r" [>|] ", example.replace("localhost:7171", "127.0.0.1:1"))[0])
                with self.subTest(example), tempfile.TemporaryDirectory() as folder:
                    # Its files do not exist, but there is no other error in it.
                    ran = subprocess.run([SELVAGE, *words[1:]], capture_output=True, text=True, timeout=60, cwd=folder)
                    self.assertNotEqual(ran.returncode, 2, ran.stderr)

    def test_help_fits_into_80_columns(self):
        for name in subcommands():
            shown = run(name, "--help").stdout.partition("Examples:")[0].partition("Exit codes:")[0]
            for line in shown.splitlines():
                self.assertLessEqual(len(line), 80, f"{name}: {line}")

    def test_a_suggestion_is_made_for_an_unknown_choice(self):
        self.assertIn("did you mean engine.info?", run("call", "engin.info").stderr)
        self.assertIn("not one of draft, standard, fine", run("compact", "x.json", "--accuracy", "quick").stderr)
        for wrong in "1", "1,2,3", "1,", "1,a", "":
            self.assertIn("--direction takes X,Y", run("bump", "x.json", "--piece", "a", "--direction", wrong).stderr)
        self.assertIn("y.json is one argument too many for compact", run("compact", "x.json", "y.json").stderr)

    def test_every_error_names_the_program_and_refers_to_the_help(self):
        for arguments in (["compact"], ["compact", "x.json", "--rounds", "many"], ["call", "nothing"], ["fold"]):
            said = run(*arguments).stderr
            self.assertTrue(said.startswith("selvage: "), said)
            self.assertRegex(said, r"\nRun `selvage( \w+)? --help` for more information\.\n$")

    def test_without_arguments_the_help_is_shown(self):
        ran = run()
        self.assertEqual((ran.returncode, ran.stdout), (2, ""))
        self.assertIn("Subcommands:", ran.stderr)


if __name__ == "__main__":
    unittest.main()
