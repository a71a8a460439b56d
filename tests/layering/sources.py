"""What the checks of this folder use: sources without comments and strings, includes, and the libraries of the build."""
import pathlib
import re

TOPS = ("core", "protocol", "server", "clients")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)
IGNORED = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.DOTALL)


def sources(root, tops=TOPS):
    """The C++ files below the folders, as (path from the root, text)."""
    for top in tops:
        for path in sorted((root / top).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                yield path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")


def code_of(text):
    """The text without comments, string literals and preprocessor lines; line numbers do not change."""
    text = IGNORED.sub(lambda match: "\n" * match.group().count("\n"), text)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", "", text, flags=re.MULTILINE)


class Library:
    """A folder's library: what its headers may use (public) and what only its sources may use (private)."""

    def __init__(self, folder, public, private):
        self.folder, self.public, self.private = folder, public, private


def libraries(root):
    """Every library that a selvage_library() of the build declares, by name.  One folder, one library: core/lp/solver is
    core_lp_solver."""
    found = {}
    for path in sorted(p for top in TOPS for p in (root / top).rglob("CMakeLists.txt")):
        folder = path.parent.relative_to(root).as_posix()
        text = re.sub(r"#[^\n]*", "", path.read_text(encoding="utf-8"))
        for body in re.findall(r"selvage_library\(([^)]*)\)", text):
            name, *words = body.split()
            links = {"SOURCES": [], "PUBLIC": [], "PRIVATE": []}
            kind = None
            for word in words:
                if word in links:
                    kind = word
                elif kind is not None:
                    links[kind].append(re.sub(r"^\$<.*:(\w+)>$", r"\1", word))
            found[name] = Library(folder, links["PUBLIC"], links["PRIVATE"])
    return found


def reachable(libraries, names):
    """The libraries of these names and all that their headers use in turn."""
    seen, ahead = set(), [name for name in names if name in libraries]
    while ahead:
        name = ahead.pop()
        if name in seen:
            continue
        seen.add(name)
        ahead += [link for link in libraries[name].public if link in libraries]
    return seen
