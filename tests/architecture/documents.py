"""The README against the tree: its links lead somewhere, and its table of settings names each key of config/server.json once."""
import pathlib
import re

LINK = re.compile(r"\]\((?!https?://|#)([^)\s]+)\)|<img[^>]*\bsrc=\"(?!https?://)([^\"]+)\"")
KEY = re.compile(r'^\s*"(\w+)"\s*:', re.MULTILINE)


def check_links(root, name, lines):
    for number, line in enumerate(lines, 1):
        for link in LINK.finditer(line):
            target = (link[1] or link[2]).split("#")[0]
            if not (root / target).exists():
                yield f"{name}:{number}: links to {target}, which is not there"


def table_keys(lines):
    """{key: line} of the first column of the table below the heading Configuration."""
    keys, inside = {}, False
    for number, line in enumerate(lines, 1):
        inside = line == "## Configuration" if line.startswith("## ") else inside
        if inside and line.startswith("| `"):
            keys.update({key: number for key in re.findall(r"`(\w+)`", line.split("|")[1])})
    return keys


def check_settings(root, name, lines):
    settings = root / "config/server.json"
    if not settings.exists():
        yield f"{name}:1: there is no config/server.json to compare its table of settings with"
        return
    told, real = table_keys(lines), set(KEY.findall(settings.read_text()))
    for key in sorted(real - set(told)):
        yield f"{name}:1: the table of settings leaves out {key}"
    for key in sorted(set(told) - real):
        yield f"{name}:{told[key]}: the table of settings has {key}, which config/server.json does not know"


def check(root):
    root, name = pathlib.Path(root), "README.md"
    lines = (root / name).read_text().splitlines()
    yield from check_links(root, name, lines)
    yield from check_settings(root, name, lines)
