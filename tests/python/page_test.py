"""page_test.py PAGE.md: runs every Python example of a page, each by itself, and looks at the pictures it wrote."""

import pathlib
import re
import sys
import tempfile
import os

page = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")
examples = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
if len(examples) < 2:
    sys.exit("The page has lost its examples.")
if len(examples[0].splitlines()) > 12:
    sys.exit("The first example is to be some ten lines.")
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for example in examples:
        exec(compile(example, "docs/python.md", "exec"), {})
    pictures = sorted(pathlib.Path(folder).glob("*.png"))
    if len(pictures) != 3:
        sys.exit(f"The first example draws three pictures, and drew {len(pictures)}.")
    sizes = [picture.stat().st_size for picture in pictures]
    if min(sizes) < 4000:
        sys.exit(f"One of the pictures shows nothing: {sizes} bytes.")
    if len({picture.read_bytes() for picture in pictures}) != 3:
        sys.exit("Two of the pictures are the same.")
    os.chdir("/")
