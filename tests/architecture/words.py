"""Names that say nothing, and marks of unfinished work."""
import re

import tree

EMPTY_NAME = re.compile(r"\b(?:class|struct|enum|enum class|union|concept|using|namespace|interface)\s+"
                        r"(?:\w+::)*(\w*(?:Manager|Helpers?|Utils?|Impl))\b", re.IGNORECASE)
EMPTY_FILE = re.compile(r"(?:^|_)(?:managers?|helpers?|utils?|impl|misc|common)$")
UNFINISHED = re.compile(r"\b(?:TODO|FIXME|XXX|HACK)\b")


def check(root):
    this_folder = "tests/architecture"  # speaks of these words
    for source in tree.sources(root, tree.CPP + tree.SHADERS + tree.SCRIPTS):
        if str(source.path.parent) == this_folder:
            continue
        if EMPTY_FILE.search(source.path.stem):
            yield source.at(1, f"the file's name, {source.path.stem}, does not say what is in it")
        for number, (line, code) in enumerate(zip(source.lines, source.code_lines), 1):
            name = EMPTY_NAME.search(code)
            if name:
                yield source.at(number, f"the name {name[1]} does not say what it is")
            mark = UNFINISHED.search(line)
            if mark:
                yield source.at(number, f"{mark.group()}: finish it or leave it out")
