#!/usr/bin/env python3
"""Every page can be followed: a relative link in a Markdown page leads to a file of the tree, and its anchor to a
heading there; a page that source code names exists.

usage: check_links.py ROOT        exit 0: all links lead somewhere; 1: some do not, each named
       check_links.py --self-test
"""
import pathlib
import re
import subprocess
import sys
import tempfile

LINK = re.compile(r"\]\(([^)\s]+)\)")
NAMED = re.compile(r"\b(?:docs|bench|tests|core|protocol|server|clients)/[\w/.-]+\.md(?!\.?\w)")
CODE = re.compile(r"```.*?```|`[^`\n]*`", re.DOTALL)
OUTSIDE = ("http://", "https://", "mailto:")


def anchors_of(page):
    """The anchors of a page's headings, as Markdown renderers make them."""
    headings = re.findall(r"^#+ +(.*?)\s*$", re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL), re.MULTILINE)
    plain = [re.sub(r"[^\w\- ]", "", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)) for heading in headings]
    return {heading.lower().replace(" ", "-") for heading in plain}


def fault_of(page, link):
    """What is wrong with a link of a page; None if it is correct."""
    path, _, anchor = link.partition("#")
    target = (page.parent / path).resolve() if path else page
    if not target.exists():
        return "leads to no file"
    if anchor and target.suffix == ".md" and anchor not in anchors_of(target):
        return "leads to no heading"
    return None


def faults(root, files):
    for file in files:
        if file.suffix == ".md":
            for link in LINK.findall(CODE.sub("", file.read_text())):
                fault = None if link.startswith(OUTSIDE) else fault_of(file, link)
                if fault:
                    yield f"{file.relative_to(root)}: the link {link} {fault}"
        elif file.suffix in (".h", ".cpp", ".py", ".ts", ".txt", ".sh") or file.name == "dev":
            for named in NAMED.findall(file.read_text()):
                if not (root / named).exists():
                    yield f"{file.relative_to(root)}: there is no page {named}"


def files_of(root):
    listed = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, text=True)
    if listed.returncode == 0:
        paths = [root / name for name in listed.stdout.split("\0") if name]
    else:
        paths = [path for path in root.rglob("*") if "build" not in path.relative_to(root).parts]
    return sorted(path for path in paths if path.is_file() and path != pathlib.Path(__file__).resolve())


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "docs").mkdir()
        (root / "docs" / "a.md").write_text("# A page: with `code`\n[here](#a-page-with-code) [b](b.md) [x](#no)\n")
        (root / "c.h").write_text("// see docs/a.md and docs/gone.md\n")
        found = list(faults(root, files_of(root)))
    expected = ["c.h: there is no page docs/gone.md", "docs/a.md: the link b.md leads to no file",
                "docs/a.md: the link #no leads to no heading"]
    assert found == expected, found


def main():
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        return 0
    root = pathlib.Path(sys.argv[1]).resolve()
    found = list(faults(root, files_of(root)))
    print("\n".join(found) or "all links lead somewhere")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
