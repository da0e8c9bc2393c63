"""Who may include whom, who may call GL, EGL and other libraries, and whether CMake links exactly so."""
import re

import tree

# The floors of the server: what each folder may include beside itself. `wire` reads its messages with the reader of `settings`.
FLOORS = {
    "core": set(),
    "settings": {"core"},
    "stream": {"core"},
    "encode": {"core"},
    "wire": {"core", "settings"},
    "gpu": {"core"},
    "vdb": {"core"},
    "bake": {"core", "gpu", "vdb"},
    "net": {"core", "stream", "wire", "settings"},
    "render": {"core", "gpu", "bake"},
    "bench": {"core", "settings", "stream", "encode", "wire", "gpu", "bake", "render"},
    "app": {"core", "settings", "stream", "encode", "wire", "gpu", "vdb", "bake", "net", "render", "bench"},
    "viewer": {"core", "settings", "wire"},
}
# A library's headers and calls, and the folders that own it.
LIBRARIES = [
    ("OpenGL and EGL", r"(GL|GLES\d?|EGL|KHR)/", r"\b(?:gl|egl)[A-Z]\w*\s*\(|\b(?:GL|EGL)_[A-Z]\w*", {"gpu"}),
    ("libwebsockets", r"libwebsockets", r"\blws_\w+\s*\(|\bLWS_[A-Z]\w*", {"net", "viewer"}),
    ("SDL", r"SDL", r"\bSDL_[A-Z]\w*", {"viewer"}),
    ("TurboJPEG", r"turbojpeg\.h", r"\btj[A-Z]\w*\s*\(", {"encode", "viewer"}),
    ("libpng", r"png\.h", r"\bpng_\w+\s*\(", {"encode", "bake", "viewer"}),
    ("OpenEXR", r"(OpenEXR/|Imf|Imath)", r"\bOPENEXR_IMF_NAMESPACE\b", {"encode", "bake"}),
    ("OpenVDB", r"openvdb/", r"\bopenvdb::", {"vdb"}),
    ("libarchive", r"archive(_entry)?\.h", r"\barchive_\w+\s*\(", {"encode"}),
    ("CLI11", r"CLI/", r"\bCLI::", {"app", "viewer"}),
    ("spdlog", r"spdlog/", r"\bspdlog::", {"core"}),
]
INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^">]+)[">]')
SHADER_FOLDERS = {"shared", "lib", "bake", "render", "gpu", "shaders"}


def check_include(source, line, quote, name):
    for library, header, _, owners in LIBRARIES:
        if re.match(header, name) and source.area not in owners:
            yield source.at(line, f"{source.area} includes {name}, but {library} belongs to {' and '.join(sorted(owners))}")
    if quote == "<" or "/" not in name:
        return
    folder = name.split("/")[0]
    if folder == "..":
        yield source.at(line, f"includes {name}: a path starts at the include root, not beside the file")
    elif folder not in FLOORS:
        if folder not in SHADER_FOLDERS and source.area in FLOORS:
            yield source.at(line, f"includes {name}, and no floor is called {folder}")
    elif source.area != folder and folder not in FLOORS[source.area]:
        allowed = ", ".join(sorted(FLOORS[source.area])) or "no other folder"
        yield source.at(line, f"{source.area} includes {name}, but it may include only: {allowed}")


def check_calls(source):
    for number, code in enumerate(source.code_lines, 1):
        for library, _, call, owners in LIBRARIES:
            found = re.search(call, code) if source.area not in owners else None
            if found:
                yield source.at(number, f"{source.area} uses {found.group().rstrip('( ')}, but {library} belongs to "
                                        f"{' and '.join(sorted(owners))}")


def check_sources(root):
    for source in tree.sources(root, tree.CPP, ("server", "client")):
        if source.area not in FLOORS:
            yield source.at(1, f"{source.area} is no floor of the design")
            continue
        for number, line in enumerate(source.lines, 1):
            include = INCLUDE.match(line)
            if include:
                yield from check_include(source, number, *include.groups())
        yield from check_calls(source)


LINK = re.compile(r"^\s*(cloudscape_library|target_link_libraries)\((?P<words>[^)]*)\)", re.MULTILINE)


def check_links(root):
    """A folder's library, and the server, link exactly the folders of their row; other programs no more than that."""
    for folder, allowed in FLOORS.items():
        file = root / ("client" if folder == "viewer" else "server") / folder / "CMakeLists.txt"
        text = file.read_text() if file.exists() else ""
        for link in LINK.finditer(text):
            target, *words = link["words"].split()
            linked = set(words) & set(FLOORS) - {folder}
            exactly = link[1] == "cloudscape_library" or target in ("cloudscape", "viewer")
            if linked != allowed if exactly else linked - allowed:
                line = text.count("\n", 0, link.start("words")) + 1
                yield (f"{file.relative_to(root)}:{line}: {target} links {sorted(linked)}, but the floors say "
                       f"{sorted(allowed)}")


def check(root):
    yield from check_sources(root)
    yield from check_links(root)
