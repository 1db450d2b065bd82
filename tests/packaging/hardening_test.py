"""What is released has a stack protector, checked lengths, read-only tables of addresses and no fixed place.

hardening_test.py --build CMAKE CXX FOLDER   builds the small project `hardened` as a release there, and looks at it
hardening_test.py FILE...                    looks at programs and libraries that are there
"""

import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent


def readelf(*arguments):
    return subprocess.run(["readelf", "--wide", *arguments], capture_output=True, text=True, check=True).stdout


def what_is_missing(file):
    headers = readelf("--file-header", "--program-headers", file)
    dynamic = readelf("--dynamic", file)
    symbols = readelf("--dyn-syms", file)
    stack = re.search(r"GNU_STACK.*", headers)
    checks = {
        "a place by chance (PIE, or a shared library)": re.search(r"Type:\s+DYN", headers),
        "tables of addresses that are read-only (GNU_RELRO)": "GNU_RELRO" in headers,
        "tables that are full at the start (BIND_NOW)": re.search(r"BIND_NOW|FLAGS_1.*\bNOW\b", dynamic),
        "a stack that is no code (GNU_STACK)": stack and "RWE" not in stack.group(),
        "no path of its own for libraries that is relative": not re.search(r"(RPATH|RUNPATH).*\[(?!\$ORIGIN|/|\])", dynamic),
    }
    if "hardened_program" not in str(file):  # which has no buffer
        checks["cookies in stack frames (__stack_chk_fail)"] = "__stack_chk_fail" in symbols
        checks["checked lengths (_FORTIFY_SOURCE)"] = re.search(r"__\w+_chk\b", symbols.replace("__stack_chk_fail", ""))
    return [what for what, found in checks.items() if not found]


def build(cmake, compiler, folder):
    subprocess.run([cmake, "-S", HERE / "hardened", "-B", folder, "-DCMAKE_BUILD_TYPE=Release",
                    f"-DCMAKE_CXX_COMPILER={compiler}", f"-DMACULA_BUILD={HERE.parents[1] / 'cmake'}"],
                   check=True, stdout=subprocess.DEVNULL)
    subprocess.run([cmake, "--build", folder], check=True, stdout=subprocess.DEVNULL)
    built = sorted(pathlib.Path(folder, "bin").iterdir())
    assert len(built) == 3, built
    return built


def main():
    files = build(*sys.argv[2:]) if sys.argv[1] == "--build" else sys.argv[1:]
    missing = {str(file): lacks for file in files if (lacks := what_is_missing(file))}
    for file, lacks in missing.items():
        print(f"{file} lacks {', '.join(lacks)}.")
    # A test that finds nothing in what is not hardened would find nothing anywhere.
    if sys.argv[1] == "--build":
        soft = pathlib.Path(sys.argv[4], "soft.so")
        subprocess.run([sys.argv[3], "-shared", "-fPIC", "-O0", "-fno-stack-protector", "-U_FORTIFY_SOURCE", "-Wl,-z,norelro",
                        "-Wl,-z,lazy", "-Wl,-z,execstack", "-o", soft, HERE / "hardened/copy.cpp"], check=True)
        assert len(what_is_missing(soft)) == 5, what_is_missing(soft)
    sys.exit(1 if missing else 0)


main()
