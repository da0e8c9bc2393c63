"""How long files and functions may be, and that a file opens with what it does."""
import re
import shutil
import statistics
import subprocess

import tree

LONGEST_FILE, LONGEST_SHADER, LONGEST_MAIN = 400, 200, 100
LONG_FUNCTION, LONG_FUNCTION_SHARE = 60, 0.02
OPENING = {"//", "/*", '""', "#!"}


def check_files(root):
    for source in tree.sources(root, tree.CPP + tree.SHADERS + tree.SCRIPTS):
        limit = LONGEST_SHADER if source.path.suffix in tree.SHADERS else LONGEST_FILE
        limit = LONGEST_MAIN if source.path.name == "main.cpp" else limit
        if len(source.lines) > limit:
            yield source.at(limit + 1, f"has {len(source.lines)} lines, {limit} at most: cut it by idea")
        described_by_header = source.path.suffix == ".cpp" and (root / source.path.with_suffix(".h")).exists()
        if source.text[:2] not in OPENING and not described_by_header:
            yield source.at(1, "does not open with a comment that says what the file does")


def function_lengths(root):
    """(path, line, name, lines) of each C++ function, by universal-ctags."""
    files = [str(source.path) for source in tree.sources(root, tree.CPP, ("server", "client"))]
    if not files:
        return
    tags = subprocess.run(["ctags", "-f", "-", "--languages=C++", "--langmap=C++:+.h", "--kinds-C++=f", "--fields=+ne",
                           *files], cwd=root, capture_output=True, text=True, check=True).stdout
    for tag in tags.splitlines():
        place = re.search(r"\tline:(\d+)\b.*\tend:(\d+)", tag)
        if place:
            name, path = tag.split("\t")[:2]
            first, last = map(int, place.groups())
            yield path, first, name, last - first + 1


def check_functions(root):
    if not shutil.which("ctags"):
        yield "tests/architecture/proportions.py:1: universal-ctags is missing, so that no function's length is known"
        return
    functions = list(function_lengths(root))
    long = [function for function in functions if function[3] > LONG_FUNCTION]
    if len(long) > LONG_FUNCTION_SHARE * len(functions):
        for path, line, name, lines in long:
            yield (f"{path}:{line}: {name} has {lines} lines; more than {LONG_FUNCTION} is for {LONG_FUNCTION_SHARE:.0%} "
                   f"of the functions at most, and this tree has {len(long)} of {len(functions)}")


def summary(root):
    files = [len(source.lines) for source in tree.sources(root, tree.CPP, ("server", "client"))]
    functions = [function[3] for function in function_lengths(root)] if shutil.which("ctags") else []
    if not files or not functions:
        return "nothing to measure"
    return (f"{len(files)} C++ files, median {statistics.median(files):.0f} lines, longest {max(files)}; "
            f"{len(functions)} functions, median {statistics.median(functions):.0f} lines, longest {max(functions)}")


def check(root):
    yield from check_files(root)
    yield from check_functions(root)
