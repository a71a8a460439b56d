#!/usr/bin/env python3
"""No pipe of a script with pipefail ends in `grep -q`: it ends at the first match, and what still writes to it is killed
by SIGPIPE, so the pipe fails now and then although there is a match.  A here-string (<<<) has no such writer; assign the
output first where the exit code of what writes it matters.

usage: check_pipes.py ROOT        exit 0: none does; 1: some do, each named
       check_pipes.py --self-test
"""
import pathlib
import re
import sys
import tempfile

QUITTING = re.compile(r"[^|]\|&?\s*(?:\\\n\s*)?(?:\w+=\S+\s+)*[ef]?grep\b[^|;\n]*?\s(?:-\w*q\w*|--quiet)(?=\s|$)",
                      re.MULTILINE)
COMMENT = re.compile(r"^\s*#[^\n]*", re.MULTILINE)


def scripts(root):
    outside = ("build", "node_modules", ".git")
    named = [path for path in root.rglob("*.sh") if not set(outside) & set(path.relative_to(root).parts)]
    return sorted(path for path in [*named, root / "dev", root / ".ci" / "run"] if path.is_file())


def faults(root):
    for script in scripts(root):
        text = COMMENT.sub("", script.read_text(encoding="utf-8"))
        if "pipefail" in text:
            for match in QUITTING.finditer(text):
                line = text.count("\n", 0, match.start() + 1) + 1
                yield f"{script.relative_to(root)}:{line}: a pipe ends in grep -q"


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "dev").write_text("set -euo pipefail\nls | grep -qx a\nls ||\n  grep -q a b\nls | grep a\nls | \\\n  grep -E -q b\n"
                                  "# ls | grep -q a\nls |& LC_ALL=C grep a -q\nls | grep --fixed-strings --quiet a\n"
                                  "ls | grep a; grep -q a b\n")
        (root / "a.sh").write_text("ls | grep -q a\n")
        found = list(faults(root))
    assert found == [f"dev:{line}: a pipe ends in grep -q" for line in (2, 6, 9, 10)], found


def main():
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        return 0
    found = list(faults(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(found) or "no pipe ends in grep -q")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
