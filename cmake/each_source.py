#!/usr/bin/env python3
"""What the build knows of each source, where it compiles several in one unit (MaculaUnity.cmake).

each_source.py BUILD writes BUILD/each_source/compile_commands.json, which says how to compile each source on its own, for
clang-tidy; and BUILD/each_source/inputs, a line for each: the source and the files of this project that it includes.
each_source.py BUILD --compile SOURCE then compiles one on its own, and keeps nothing."""
import json
import os
import re
import shlex
import subprocess
import sys

build = os.path.abspath(sys.argv[1])
project = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
included_by_text = {}


def quoted(path):
    if path not in included_by_text:
        with open(path, encoding="utf-8", errors="replace") as file:
            included_by_text[path] = INCLUDE.findall(file.read())
    return included_by_text[path]


def includes_of(source, folders):
    """All that `source` includes of the project and of what the build has made, itself first."""
    found = [source]
    for path in found:  # which grows
        for name in quoted(path):
            for folder in (os.path.dirname(path), *folders):
                file = os.path.normpath(os.path.join(folder, name))
                if os.path.isfile(file):
                    if file not in found:
                        found.append(file)
                    break
    return found


def compile_alone(source):
    with open(os.path.join(build, "each_source", "compile_commands.json"), encoding="utf-8") as file:
        unit = next(unit for unit in json.load(file) if unit["file"] == os.path.abspath(source))
    words = shlex.split(unit["command"])
    words[words.index("-o") + 1] = os.devnull
    return subprocess.run([*words, "-fsyntax-only"], cwd=unit["directory"], check=False).returncode


def write_each():
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        units = json.load(file)
    sources = {}
    for unit in units:
        command = unit["command"]
        for unknown_to_clang in (" -Wno-subobject-linkage", " -Wno-maybe-uninitialized"):
            command = command.replace(unknown_to_clang, "")
        holds = quoted(unit["file"]) if unit["file"].endswith("_cxx.cxx") else [unit["file"]]
        for source in holds:
            if source.startswith(project + os.sep) and not source.startswith(build + os.sep):
                sources.setdefault(source, (command.replace(unit["file"], source), unit["directory"]))
    folder = os.path.join(build, "each_source")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "compile_commands.json"), "w", encoding="utf-8") as file:
        json.dump([{"file": s, "command": c, "directory": d} for s, (c, d) in sorted(sources.items())], file, indent=1)
    with open(os.path.join(folder, "inputs"), "w", encoding="utf-8") as file:
        for source, (command, _) in sorted(sources.items()):
            folders = [word[2:] for word in shlex.split(command) if word.startswith("-I" + project)]
            file.write(" ".join(os.path.relpath(path, project) for path in includes_of(source, folders)) + "\n")


sys.exit(compile_alone(sys.argv[3]) if sys.argv[2:3] == ["--compile"] else write_each())
