"""components_test.py CONFIG FOLDER: what the exported targets of a component refer to is of components that maculaConfig.cmake loads
before it. FOLDER is that of a build, where CMake has left the exports that are installed."""

import pathlib
import re
import sys

config = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")
exports = {file.stem[len("macula-"):]: file.read_text(encoding="utf-8")
           for file in pathlib.Path(sys.argv[2]).glob("CMakeFiles/Export/**/macula-*.cmake")
           if not re.search(r"-(relwithdebinfo|release|debug|minsizerel|noconfig)$", file.stem)}
exports.pop("c", None)
if len(exports) < 10:
    sys.exit(f"components_test: only {sorted(exports)} are exported.")


def words(text, below):
    return [part for word in text.split() for part in (below[word[2:-1]] if word.startswith("${") else [word])]


order = re.search(r"set\(_macula_all ([^)]*)\)", config)[1].split()
below = {}
for verb, name, text in re.findall(r"(set|list)\((?:APPEND )?(_macula_below_\w+) ([^)]*)\)", config):
    below[name] = (below[name] if verb == "list" else []) + words(text, below)

wrong = []
ofTarget = {target: name for name, text in exports.items() for target in re.findall(r"^add_library\((macula::\w+)", text, re.M)}
for name, text in exports.items():
    loaded = set(below.get(f"_macula_below_{name}", []))
    for needed in re.findall(r'"(macula::\w+)"', " ".join(re.findall(r"^foreach\(_target (.*)\)$", text, re.M))):
        if ofTarget.get(needed) not in loaded:
            wrong.append(f"macula::{name} needs {needed}, which find_package(macula COMPONENTS {name}) does not load.")
    for other in loaded:
        if order.index(other) > order.index(name):
            wrong.append(f"{other} is loaded after {name}, which needs it.")
if wrong:
    sys.exit("\n".join(wrong))
