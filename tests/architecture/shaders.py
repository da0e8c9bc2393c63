"""Shaders get their version and blocks from the program: no #version, no loose uniforms; shaders/lib holds pure functions."""
import re

import tree

OPAQUE = r"(?:[iu]?(?:sampler|image)\w+)"
UNIFORM = re.compile(r"^\s*(?:layout\s*\([^)]*\)\s*)?(?:(?:readonly|writeonly|restrict|coherent|highp|mediump)\s+)*uniform\s+(.*)")
QUALIFIERS = re.compile(r"^(?:(?:readonly|writeonly|restrict|coherent|highp|mediump)\s+)*")
IMPURE = [(re.compile(r"\buniform\b"), "a uniform"), (re.compile(rf"\b{OPAQUE}\b"), "a sampler or image"),
          (re.compile(r"[(,]\s*(?:in)?out\s+\w"), "an out parameter"), (re.compile(r"\bgl_\w+"), "a built-in variable")]


def is_loose(declaration):
    """Whether what follows `uniform` is neither a block (a name and a brace) nor a sampler or an image."""
    declaration = QUALIFIERS.sub("", declaration)
    return not re.match(rf"{OPAQUE}\b", declaration) and not re.match(r"\w+\s*(?:\{|$)", declaration)


def check(root):
    for source in tree.sources(root, tree.SHADERS, ("shaders",)):
        pure = source.path.parts[1] == "lib"
        for number, code in enumerate(source.code_lines, 1):
            if re.match(r"\s*#\s*version\b", code):
                yield source.at(number, "#version: the program puts it in front of every shader")
            uniform = UNIFORM.match(code)
            if uniform and is_loose(uniform[1]):
                yield source.at(number, "a loose uniform: put it in a block of shaders/shared")
            for pattern, what in IMPURE if pure else ():
                if pattern.search(code):
                    yield source.at(number, f"{what} in shaders/lib, which is for pure functions that also compile as C++")
