"""bill_test.py SBOM BUILD LIBRARY: the bill of a built library names all that is linked, compiled in and embedded, and its check
sees what is missing and what is too much."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sbom, build, library = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]).resolve()


def demand(condition, what):
    if not condition:
        sys.exit(f"bill_test: {what}")


def run(*words):
    return subprocess.run([sys.executable, sbom, *map(str, words)], capture_output=True, text=True, check=False,
                          env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"})


def write(bill):
    done = run("write", "--build", build, "--name", "libmacula0", "--version", "1.2.3", "--output", bill, library)
    demand(done.returncode == 0, done.stderr)
    return bill.read_bytes()


def properties(part, name):
    return [entry["value"] for entry in part.get("properties", ()) if entry["name"] == name]


with tempfile.TemporaryDirectory() as folder:
    prefix = pathlib.Path(folder)
    bill = prefix / "share" / "doc" / "libmacula0" / "libmacula0.cdx.json"
    (prefix / "lib").mkdir()
    try:
        os.link(library, prefix / "lib" / library.name)
    except OSError:
        shutil.copy(library, prefix / "lib" / library.name)

    first = write(bill)
    content = json.loads(first)
    demand(first == write(bill), "two bills of one library differ")
    demand(content["bomFormat"] == "CycloneDX" and content["specVersion"] == "1.5", "it is no CycloneDX")
    demand(re.fullmatch(r"urn:uuid:[0-9a-f-]{36}", content["serialNumber"]), "the serial number is none")
    demand(content["metadata"]["timestamp"] == "2023-11-14T22:13:20Z", "the time is not that of SOURCE_DATE_EPOCH")
    references = [part["bom-ref"] for part in content["components"]]
    demand(len(references) == len(set(references)), "a part is named twice")
    demand(set(content["dependencies"][0]["dependsOn"]) == set(references), "what it depends on is not what it consists of")
    demand(str(build) not in first.decode() and os.path.dirname(os.path.dirname(sbom)) not in first.decode(),
           "it tells in which folder it was built")

    # What nobody would find by looking at the library: headers, a static library, and files of the sources.
    kinds = {part["name"]: properties(part, "macula:relation") for part in content["components"]}
    for name in ("libglm-dev", "nlohmann-json3-dev", "libsqlitecpp-dev"):
        demand(kinds.get(name) == ["compiled in"], f"{name} is not compiled in")
    demand("libcli11-dev" not in kinds, "the library has the command's parts")
    for name in ("presets/transfer/ct-bone.json", "shaders/trace/path.comp", "src/dicom/rules/split.json"):
        demand(kinds.get(name) == ["embedded"], f"{name} is not embedded")
    demand(all(part["licenses"] and part["purl"].startswith("pkg:") and part["version"] for part in content["components"]),
           "a part has no licence, version or purl")

    done = run("check", prefix)
    demand(done.returncode == 0, done.stderr)

    # One library less, and one more.
    linked = next(part for part in content["components"] if "libdcmdata.so" in " ".join(properties(part, "macula:library")))
    name = next(value for value in properties(linked, "macula:library") if value.startswith("libdcmdata.so"))
    entry = {"name": "macula:library", "value": name}
    linked["properties"].remove(entry)
    bill.write_text(json.dumps(content), encoding="utf-8")
    done = run("check", prefix)
    demand(done.returncode != 0 and f"does not name {name}" in done.stderr, "a missing library is not seen")
    linked["properties"] += [entry, {"name": "macula:library", "value": "libnobody.so.1"}]
    bill.write_text(json.dumps(content), encoding="utf-8")
    done = run("check", prefix)
    demand(done.returncode != 0 and "names libnobody.so.1, which nothing needs" in done.stderr, "a library too many is not seen")
    bill.unlink()
    demand(run("check", prefix).returncode != 0, "a library without a bill is not seen")

    done = run("write", "--build", build, "--name", "x", "--version", "1", "--output", bill, prefix / "lib" / "other.so")
    demand(done.returncode != 0 and "Traceback" not in done.stderr, "what the build did not make is not refused")
