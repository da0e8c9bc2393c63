"""The files of a source tree as the checks read them: paths below its root, lines, and lines without comments and strings."""
import dataclasses
import functools
import pathlib
import re

CPP = (".h", ".cpp")
SHADERS = (".glsl", ".comp", ".frag", ".vert")
SCRIPTS = (".py", ".js", ".mjs")
FOLDERS = ("server", "client", "shaders", "tests")
NOT_OURS = {"node_modules", "__pycache__", "build"}

# A comment, a string or a character, whichever opens first; raw strings before plain ones.
HIDDEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"([^\s()\\]{0,16})\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.DOTALL)


def blank(match):
    return re.sub(r"[^\n]", " ", match.group())


@dataclasses.dataclass(frozen=True)
class Source:
    root: pathlib.Path
    path: pathlib.PurePosixPath  # below the root

    @functools.cached_property
    def text(self):
        return (self.root / self.path).read_text(encoding="utf-8")

    @property
    def lines(self):
        return self.text.splitlines()

    @functools.cached_property
    def code_lines(self):
        """The lines with comments and strings blanked out, so that a word in prose is no violation."""
        return HIDDEN.sub(blank, self.text).splitlines()

    @property
    def area(self):
        """`gpu` for server/gpu/*, `viewer` for client/viewer/*, `tests` for the rest."""
        parts = self.path.parts
        return parts[1] if parts[0] in ("server", "client") else parts[0]

    def at(self, line, why):
        return f"{self.path}:{line}: {why}"


def sources(root, suffixes, folders=FOLDERS):
    """All files of these kinds below these folders, in order."""
    root = pathlib.Path(root)
    for folder in folders:
        for file in sorted((root / folder).rglob("*")):
            path = file.relative_to(root)
            if file.suffix in suffixes and file.is_file() and not NOT_OURS & set(path.parts):
                yield Source(root, pathlib.PurePosixPath(path))
