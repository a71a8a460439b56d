#!/usr/bin/env python3
"""No lambda uses a name of a structured binding around it.  g++ allows that; clang 14, which compiles the fuzz targets
and runs clang-tidy, does not.  A lambda may use a copy: [first = first].

usage: check_bindings.py ROOT        exit 0: no lambda does; 1: some do, each named
       check_bindings.py --self-test
"""
import pathlib
import re
import sys

from sources import TOPS, code_of, sources

TOKEN = re.compile(r"[A-Za-z_]\w*|\d[\w.']*|::|->|&&|\|\||==|!=|<=|>=|\[\[|\]\]|\S")
CLOSING = {"(": ")", "{": "}", "[": "]"}
# Words after which a name is used, not declared.
USING = {"return", "co_return", "co_yield", "case", "else", "throw", "new", "delete", "not", "and", "or", "do"}


class Code:
    """The tokens of a file with their lines, and for each opening bracket the position of the closing one."""

    def __init__(self, text):
        found = list(TOKEN.finditer(text))
        self.words = [match.group() for match in found]
        self.offsets = [match.start() for match in found]
        self.text = text
        self.closing, open_brackets = {}, []
        for at, word in enumerate(self.words):
            if word in CLOSING:
                open_brackets.append(at)
            elif word in CLOSING.values() and open_brackets:
                self.closing[open_brackets.pop()] = at

    def word(self, at):
        return self.words[at] if 0 <= at < len(self.words) else ""

    def line(self, at):
        return self.text.count("\n", 0, self.offsets[at]) + 1

    def end_of_statement(self, at):
        while at < len(self.words) and self.words[at] not in (";", "}"):
            at = self.closing.get(at, at) + 1
            if self.word(at - 1) == "}":
                break
        return at


def is_binding(code, at):
    """Whether the bracket at this position lists the names of a structured binding."""
    before = at - 1
    while code.word(before) in ("&", "&&", "const"):
        before -= 1
    return code.word(before) == "auto"


def bindings(code):
    """(names, first and last position at which they are known) of every structured binding."""
    blocks = []  # the positions of the brackets around
    for at, word in enumerate(code.words):
        while blocks and code.closing[blocks[-1]] <= at:
            blocks.pop()
        if word == "[" and at in code.closing and is_binding(code, at):
            end = code.closing[at]
            names = [name for name in code.words[at + 1:end] if name != ","]
            if not blocks:
                last = len(code.words)
            elif code.word(blocks[-1]) == "(":  # of a loop or a condition: known in what follows
                last = code.end_of_statement(code.closing[blocks[-1]] + 1)
            else:
                last = code.closing[blocks[-1]]
            yield names, end, last
        if word in CLOSING and at in code.closing:
            blocks.append(at)


def captures(code, start, end):
    """(names used, names made) of the capture list between these positions."""
    used, made, entry = set(), set(), []
    for word in [*code.words[start + 1:end], ","]:
        if word != ",":
            entry.append(word)
            continue
        names = [one for one in entry if one != "&"]
        if "=" in names[1:]:
            made.add(names[0])
        else:
            used.update(names)
        entry = []
    return used, made


def lambdas(code, first, last):
    """(position, names captured, names made or taken as parameters, body's first and last position) of every lambda."""
    for at in range(first, min(last, len(code.words))):
        if code.words[at] != "[" or at not in code.closing or is_binding(code, at):
            continue
        if re.match(r"\w|\)|\]", code.word(at - 1)) and code.word(at - 1) not in USING:
            continue  # an index
        end = code.closing[at]
        used, known = captures(code, at, end)
        body = end + 1
        while body < len(code.words) and code.words[body] not in ("{", ";", ",", ")", "}"):
            if code.words[body] == "(":
                known.update(code.words[body + 1:code.closing[body]])
            body = code.closing.get(body, body) + 1
        if code.word(body) == "{":
            yield at, used, known, body, code.closing[body]


def uses(code, name, first, last):
    """Whether the code between these positions uses the name, before it declares one of its own."""
    for at in range(first, last):
        if code.words[at] != name or code.word(at - 1) in (".", "->", "::"):
            continue
        before = code.word(at - 1)
        declares = (re.match(r"\w", before) and before not in USING) or before == ">" or (
            before in ("&", "*", "&&") and re.match(r"[A-Za-z_]|>", code.word(at - 2)) and code.word(at + 1) in ("=", ":", "{"))
        in_binding = any(name in names and first <= end <= last and end >= at for names, end, _ in bindings(code))
        return not (declares or in_binding)
    return False


def faults_in(name, text):
    code = Code(code_of(text))
    found = set()
    for names, first, last in bindings(code):
        for at, used, known, begin, end in lambdas(code, first, last):
            for one in names:
                if one in used or (one not in known and uses(code, one, begin, end)):
                    found.add((code.line(at), one))
    return [f"{name}:{line}: a lambda uses {one}, a name of a structured binding" for line, one in sorted(found)]


def self_test():
    """Tests that the faults that are planted are found, and nothing else."""
    planted = """
void f(Pairs pairs) {
  auto [first, second] = pairs.front();
  const auto a = [&] { return first; };
  run([second](int x) { return x; });
  const auto b = [first = first](int second) { return first + second; };
  const auto c = [&] { return pairs.first + this->second + whole::first; };
  const auto d = [&](Pair p) { const auto [first, rest] = p; return first; };
  const auto e = [&] { int first = 1; return first; };
  int index = table[first];
  for (const auto& [key, value] : pairs) run([&] { keep(value); });
  run([&] { keep(value); });
  if (const auto [at, fresh] = insert(); fresh) {
    run([&] { keep(at); });
  }
}
void g(int first) { run([&] { return first; }); }
"""
    lines = [int(fault.split(":")[1]) for fault in faults_in("planted.cpp", planted)]
    assert lines == [4, 5, 11, 14], lines


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        sys.exit(0)
    tree = pathlib.Path(sys.argv[1])
    list_of_faults = [fault for name, text in sources(tree, (*TOPS, "tests")) for fault in faults_in(name, text)]
    print("\n".join(list_of_faults) or "no lambda uses a structured binding")
    sys.exit(1 if list_of_faults else 0)
