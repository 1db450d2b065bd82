#!/usr/bin/env python3
"""Which sources of a target the compiler reads as one unit (MaculaUnity.cmake).

units.py OUTPUT <SOURCES: reads a line `directory;target;file` for each source and writes a script for CMake that gives each
source its UNITY_GROUP. In a unit, the unnamed namespace of one source is visible to those behind it, so two sources go into one
unit only if neither uses a name that the other declares for itself. The script compares words as a compiler would not: it may
keep apart what would fit. A source stays in the unit that OUTPUT has it in for as long as it fits there."""
import functools
import os
import re
import sys
from collections import defaultdict

project = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

# A unit costs what its headers cost, once; a source two seconds. Larger ones would leave a core idle at the end of a build.
SOURCES_PER_UNIT = 12
LINES_PER_UNIT = 2200

TOKEN = re.compile(
    r"""(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<text>R"([^( ]*)\(.*?\)\3"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])')"""
    r"""|(?P<directive>^[ \t]*\#(?:[^\n\\]|\\\n|\\.)*)|(?P<word>[A-Za-z_]\w*)|::|->|[0-9][\w.']*|\S""", re.DOTALL | re.MULTILINE)
MACRO = re.compile(r"\s*#\s*define\s+(\w+)")
INCLUDE = re.compile(r'\s*#\s*include\s*"([^"]+)"')
NOT_NAMES = set("auto bool catch char const constexpr decltype default delete double explicit float int long noexcept operator "
                "override requires short signed static template try typename unsigned void volatile".split())
INTRODUCES = {"struct", "class", "union", "concept", "enum"}


def is_word(token):
    return token[0].isalpha() or token[0] == "_"


class Source:
    """The names that a source or header declares, those that it declares for itself alone, and those that it uses."""

    def __init__(self, path):
        with open(path, encoding="utf-8", errors="replace") as file:
            text = file.read()
        self.path, self.lines = path, text.count("\n")
        self.declared, self.functions, self.others, self.aliases, self.includes = set(), set(), set(), {}, []
        self.opens_namespace = False  # to what stands behind it, which then finds other names than alone
        tokens = self._tokens(text)
        before = [""] + tokens
        behind = tokens[1:] + [""]
        free = [(t, b) for p, t, b in zip(before, tokens, behind) if is_word(t) and p not in (".", "->", "::")]
        self.used = {t for t, _ in free}
        self.called = {t for t, b in free if b == "("}
        self._read(tokens)

    def _tokens(self, text):
        tokens = []
        for match in TOKEN.finditer(text):
            if match["directive"]:
                macro = MACRO.match(match["directive"])
                if macro:
                    self.others.add(macro[1])
                include = INCLUDE.match(match["directive"])
                if include:
                    self.includes.append(include[1])
            elif match["text"]:
                tokens.append('""')
            elif not match["comment"]:
                tokens.append(match[0])
        return tokens

    def _read(self, tokens):
        """Goes through what stands in namespaces, and over what stands in other braces and in parentheses."""
        namespaces, declaration, at = [], [], 0
        while at < len(tokens):
            token = tokens[at]
            if token == "namespace" and not declaration:
                end = next(i for i in range(at, len(tokens)) if tokens[i] in "{;=")
                if tokens[end] == "{":
                    namespaces.append(end == at + 1)
                    at = end + 1
                    continue
            if token == "}":
                namespaces.pop()
            elif token == ";":
                self._declare(declaration, any(namespaces))
                declaration = []
            elif token in ("{", "("):
                at = self._over(tokens, at)
                declaration.append(token)
                ends_body = token == "{" and (at + 1 == len(tokens) or tokens[at + 1] not in ";,([.{")
                if ends_body:
                    self._declare(declaration, any(namespaces))
                    declaration = []
            else:
                declaration.append(token)
            at += 1

    @staticmethod
    def _over(tokens, at):
        opens = tokens[at]
        closes, depth = {"{": "}", "(": ")"}[opens], 0
        for end in range(at, len(tokens)):
            depth += (tokens[end] == opens) - (tokens[end] == closes)
            if depth == 0:
                return end
        return len(tokens) - 1

    def _declare(self, words, is_unnamed):
        words = self._without_template(words)
        if not words:
            return
        if words[:2] == ["using", "namespace"]:
            self.opens_namespace = self.opens_namespace or not words[-1].endswith("literals")
            return
        if words[0] in ("using", "namespace"):
            if "=" in words or len(words) > 2:
                name = words[1] if "=" in words else words[-1]
                self.aliases[name] = "".join(words)
            return
        # A constant is its source's own in any namespace; a function is not, unless it says so.
        is_own = is_unnamed or "static" in words or (("const" in words or "constexpr" in words) and "(" not in words)
        name, is_function = self._name_in(words)
        if name and name not in NOT_NAMES and not re.fullmatch("[A-Z_0-9]+", name):  # TEST and such
            self.declared.add(name)
            if is_own:
                (self.functions if is_function else self.others).add(name)

    @staticmethod
    def _name_in(words):
        while words and words[0] in ("inline", "static", "constexpr", "const", "extern"):
            words = words[1:]
        if "operator" in words or not words:
            return None, False
        if words[0] in INTRODUCES:
            return next((w for w in words[1:] if is_word(w) and w not in INTRODUCES and w not in ("final", "alignas")), None), False
        name, angles = None, 0
        for before, word in zip([""] + words, words):
            if word == "<":
                angles += 1
            elif word == ">":
                angles -= 1
            elif angles <= 0 and word in ("(", "=", "{", "[") and name not in ("decltype", "requires", "alignas", "noexcept"):
                return name, word == "("
            elif angles <= 0 and is_word(word):
                name = None if before == "::" else word
        return name, False

    @staticmethod
    def _without_template(words):
        if words[:1] != ["template"]:
            return words
        depth = 0
        for at, word in enumerate(words):
            depth += (word == "<") - (word == ">")
            if word == ">" and depth == 0:
                return words[at + 1:]
        return []

    def clashes_with(self, other):
        return self._is_in_the_way_of(other) or other._is_in_the_way_of(self)

    def _is_in_the_way_of(self, other):
        return bool(
            self.opens_namespace or self.functions & (other.functions | other.called) or self.others & (other.used | declared_for(other.path))
            or any(other.aliases.get(name) != text for name, text in self.aliases.items() if name in other.used))


@functools.lru_cache(maxsize=None)
def read(path):
    return Source(path)


@functools.lru_cache(maxsize=None)
def header(name, beside):
    folders = (beside, os.path.join(project, "src"), os.path.join(project, "tests"), os.path.join(project, "shaders"))
    return next((path for path in (os.path.join(folder, name) for folder in folders) if os.path.isfile(path)), None)


@functools.lru_cache(maxsize=None)
def declared_for(path):
    """What the headers that `path` includes declare."""
    found, names = [path], set()
    for each in found:  # which grows
        beside = os.path.dirname(each)
        for include in read(each).includes:
            below = header(include, beside)
            if below and below not in found:
                found.append(below)
                names |= read(below).declared
    return names


def units_of(sources, unit_before):
    """Lists of sources. Those that were in a unit find their place first, then those that clash with most, each where least is."""
    clashes = defaultdict(set)
    for at, one in enumerate(sources):
        for other in sources[:at]:
            if one.clashes_with(other):
                clashes[one].add(other)
                clashes[other].add(one)
    lines = sum(source.lines for source in sources)
    fewest = max(1, -(-len(sources) // SOURCES_PER_UNIT), -(-lines // LINES_PER_UNIT))
    units = [[] for _ in range(max([fewest, *(unit_before.get(each.path, 0) + 1 for each in sources)]))]
    for source in sorted(sources, key=lambda each: (each.path not in unit_before, -len(clashes[each]), each.path)):
        fits = [unit for unit in units if not clashes[source] & set(unit)]
        before = units[unit_before[source.path]] if source.path in unit_before else None
        if before is not None and before in fits and len(before) < 2 * SOURCES_PER_UNIT:
            before.append(source)
            continue
        if not fits:
            units.append([])
            fits = units[-1:]
        min(fits, key=lambda unit: sum(each.lines for each in unit)).append(source)
    return units


def units_before(output):
    """By target: the number of each source's unit."""
    found = defaultdict(dict)
    if os.path.exists(output):
        with open(output, encoding="utf-8") as script:
            for line in script:
                target, number = re.search(r"(\S+)_([0-9]+)\)$", line).groups()
                for path in re.findall(r'"([^"]+)"', line)[:-1]:
                    found[target][path] = int(number)
    return found


def main(output):
    targets_of, sources_of, before = defaultdict(set), defaultdict(list), units_before(output)
    for line in sys.stdin.read().split():
        directory, target, path = line.split(";")
        targets_of[directory, path].add(target)
        sources_of[directory, target].append(path)
    with open(output, "w", encoding="utf-8") as script:
        for (directory, target), paths in sources_of.items():
            own = [read(path) for path in sorted(paths) if len(targets_of[directory, path]) == 1]
            for number, unit in enumerate(units_of(own, before[target])):
                if unit:
                    names = " ".join(f'"{source.path}"' for source in sorted(unit, key=lambda each: each.path))
                    script.write(f'set_property(SOURCE {names} DIRECTORY "{directory}" PROPERTY UNITY_GROUP {target}_{number})\n')


main(sys.argv[1])
