#!/usr/bin/env python3
"""Prints each Text("...") that the window may say, of itself and of the rooms below, as a C++ source for lupdate.

    packaging/translations.py [FOLDER]    FOLDER: of the sources, else that of this file

Context "core" has formats of Text (src/base/text.h), and "titles" those of what is built in.
packaging/translations runs it.
"""
import ast
import pathlib
import re
import sys

# Their texts never appear in the window.
NOT_IN_THE_WINDOW = ["src/cli", "src/bench", "src/evaluate", "src/c"]

# A literal, or several that the compiler joins.
PIECE = r'"(?:[^"\\\n]|\\.)*"'
LITERAL = PIECE + r"(?:\s*" + PIECE + r")*"
SENTENCE = r'"[^"\n]* (?:[^"\\\n]|\\.)*"(?:\s*' + PIECE + r")*"

# Literals that become a text elsewhere: context, files, and a pattern whose groups they are. L is a literal, S one with a
# space.
TABLES = [
    ("core", "src/dicom/messages/messages.cpp", r"(S)"),
    ("core", "src/segment/messages.cpp", r"(S)"),
    ("core", "src/dicom/read/sop_class.cpp", r'\{"[0-9.]+",\s*(L)'),
    ("core", "src/study/open/stack_label_text.cpp", r"Words\{L,\s*(L)\}"),
    ("core", "src/scene/state/parameters.cpp", r"\.(?:label|unit) = (L)"),
    ("core", "src/scene/state/parameters.cpp", r"Stale::matter,\s*\.does = (L)"),
    ("core", "src/viewer/keys/keys.h", r"KeyRow\{[^,]+,\s*(L),\s*L,\s*(L)\}"),
    ("core", "src/viewer/keys/keys.h", r"LayoutRow\{[^,]+,\s*(L),\s*L\}"),
    ("titles", "src/pipeline/trace/look.h", r"\{Look::\w+, LookKind::\w+, L, (L)\}"),
    ("titles", "src/scene/slices/window_presets.cpp", r"\{\d, (L), [-0-9.]+"),
    ("titles", "src/scene/slices/window_presets.cpp", r"\.name = [^\n]*? \? (L) : (L)\}"),
    ("titles", "src/scene/slices/window_presets.cpp", r"\.name = (L)"),
    ("titles", "src/scene/camera/view_directions.cpp", r"\{(L), ViewDirection::(?!oblique|threeQuarter|turned)"),
    ("titles", "src/scene/lights/edited_rig.h", r"kOwnLightsTitle = (L)"),
    ("titles", "src/scene/clip/edit_steps.cpp", r"\.title = (L)"),
    ("titles", "src/scene/clip/clip_of_shape.cpp", r"\.title = (L)"),
    ("titles", "src/scene/presentation/*.cpp", r"\.title = (L)"),
    ("titles", "src/viewer/language/window_language.cpp", r"titleOf\((L)\)"),
    ("titles", "presets/lights/*.json", r'"title": (L)'),
    ("titles", "presets/clip/*.json", r'"title": (L)'),
    ("titles", "presets/quality/*.json", r'"title": (L)'),
    # Those without a space are names that others gave: "CT-Bone".
    ("titles", "presets/transfer/*.json", r'"title": (S)'),
]

TOKEN = re.compile(
    r"//[^\n]*|/\*.*?\*/|R\"(?P<mark>[^()\s\\]*)\((?P<raw>.*?)\)(?P=mark)\"|(?P<piece>" + PIECE + r")|'(?:[^'\\\n]|\\.)+'"
    r"|\d[\w.']*|(?P<name>\w+)|(?P<space>\s+)|(?P<other>.)",
    re.DOTALL,
)


def value(literal):
    """Of adjacent pieces in quotes, without raw ones."""
    return "".join(ast.literal_eval(piece) for piece in re.findall(PIECE, literal))


def texts_in(source):
    """The literals that directly follow `Text(`, `Text name(`, `Text::of(`, or these with `{`, also before arguments."""
    before = []  # tokens that are no space
    literal = None
    for token in TOKEN.finditer(source):
        if token["space"] or token[0].startswith(("//", "/*")):
            continue
        if token["piece"] or token["raw"] is not None:
            part = token["raw"] if token["raw"] is not None else value(token["piece"])
            named = before[-3:-2] == ["Text"] and before[-2].isidentifier() and before[-1] in ("(", "{")
            begins = (before[-2:] in (["Text", "("], ["Text", "{"]) or named
                      or before[-5:] == ["Text", ":", ":", "of", "("])
            if literal is not None:
                literal += part
            elif begins:
                literal = part
        else:
            if literal is not None:
                yield literal
            literal = None
        before = before[-4:] + [token[0]]


def without_comments(source):
    return TOKEN.sub(lambda token: " " if token[0].startswith(("//", "/*")) else token[0], source)


def is_in_the_window(file, root):
    name = file.relative_to(root).as_posix()
    return not any(name.startswith(folder + "/") for folder in NOT_IN_THE_WINDOW)


def all_texts(root):
    found = {"core": {}, "titles": {}}  # in the order of the sources, each once
    for file in sorted((root / "src").rglob("*")):
        if file.suffix in (".cpp", ".h", ".inl") and is_in_the_window(file, root):
            for text in texts_in(file.read_text(encoding="utf-8")):
                found["core"].setdefault(text, file)
    for context, files, pattern in TABLES:
        expression = re.compile(re.sub(r"\b[LS]\b", lambda of: {"L": LITERAL, "S": SENTENCE}[of[0]], pattern))
        count = 0
        for file in sorted(root.glob(files)):
            for match in expression.finditer(without_comments(file.read_text(encoding="utf-8"))):
                for literal in match.groups():
                    found[context].setdefault(value(literal), file)
                    count += 1
        if count == 0:
            sys.exit(f"translations.py: nothing in {files} is like {pattern}. TABLES tells where texts are.")
    return {context: {text: file for text, file in texts.items() if has_letters(text)}
            for context, texts in found.items()}


def has_letters(text):
    """Not so "{}, {}", of which there is nothing to translate."""
    return any(c.isalpha() for c in re.sub(r"\{\w*(:[^{}]*)?\}", "", text))


def in_quotes(text):
    escapes = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\t": "\\t"}
    return '"' + "".join(escapes.get(c, c) for c in text) + '"'


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent
    lines = [
        f"QT_TRANSLATE_NOOP({in_quotes(context)}, {in_quotes(text)}),"
        for context, texts in all_texts(root).items()
        for text in texts
    ]
    print("const char* const kTexts[] = {", *lines, "};", sep="\n")


if __name__ == "__main__":
    main()
