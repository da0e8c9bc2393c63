"""Each check on small trees made for it: it names the place of the fault, and says nothing of a tree without one."""
import pathlib
import tempfile
import unittest

import documents
import floors
import proportions
import shaders
import words


class SelfTest(unittest.TestCase):
    def violations(self, check, files):
        """What `check` says of a tree of these files ({path: text}), as the `file:line` of each."""
        with tempfile.TemporaryDirectory() as folder:
            for path, text in files.items():
                file = pathlib.Path(folder) / path
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text)
            return [":".join(line.split(":")[:2]) for line in check(pathlib.Path(folder))]

    def assert_found(self, check, path, text, line):
        self.assertEqual(self.violations(check, {path: text}), [f"{path}:{line}"], text)

    def assert_clean(self, check, path, text):
        self.assertEqual(self.violations(check, {path: text}), [], text)

    def test_includes_go_down_the_floors(self):
        self.assert_found(floors.check, "server/core/a.h", '// A.\n#include "settings/b.h"\n', 2)
        self.assert_found(floors.check, "server/stream/a.cpp", '#include "net/server.h"\n', 1)
        self.assert_found(floors.check, "server/net/a.cpp", '#include <vector>\n\n#include "gpu/pass.h"\n', 3)
        self.assert_found(floors.check, "client/viewer/a.cpp", '#include "stream/frame_scheduler.h"\n', 1)
        self.assert_found(floors.check, "server/encode/a.cpp", '#include "../core/frame.h"\n', 1)
        self.assert_found(floors.check, "server/encode/a.cpp", '#include "codec/frame.h"\n', 1)
        self.assert_clean(floors.check, "server/render/a.cpp", '#include "bake/b.h"\n#include "render/c.h"\n#include "core/d.h"\n')
        self.assert_found(floors.check, "server/app/a.cpp", '#include "viewer/sight.h"\n', 1)
        self.assert_clean(floors.check, "client/viewer/a.cpp", '#include "viewer/b.h"\n#include "wire/messages.h"\n')
        self.assert_clean(floors.check, "server/wire/a.cpp", '#include "settings/described_json.h"\n')

    def test_a_new_folder_needs_a_floor(self):
        self.assert_found(floors.check, "server/misc/a.h", "// A.\n", 1)

    def test_libraries_stay_with_their_owner(self):
        self.assert_found(floors.check, "server/render/a.cpp", "void f() {\n  glClear(0);\n}\n", 2)
        self.assert_found(floors.check, "server/bake/a.cpp", "auto d = eglGetDisplay(0);\n", 1)
        self.assert_found(floors.check, "server/bake/a.h", "int format = GL_RGBA8;\n", 1)
        self.assert_found(floors.check, "server/app/a.cpp", "#include <GL/gl.h>\n", 1)
        self.assert_found(floors.check, "server/stream/a.cpp", "int n = lws_service(c, 0);\n", 1)
        self.assert_found(floors.check, "server/app/a.cpp", "#include <libwebsockets.h>\n", 1)
        self.assert_clean(floors.check, "server/gpu/a.cpp", "#include <EGL/egl.h>\nvoid f() { glClear(0); }\n")
        self.assert_clean(floors.check, "server/net/a.cpp", "#include <libwebsockets.h>\nint n = lws_service(c, 0);\n")

    def test_prose_is_no_call(self):
        self.assert_clean(floors.check, "server/core/a.h", '// As glClear() does.\n/* GL_RGBA\n lws_write( */ auto s = "eglInit()";\n')
        self.assert_clean(floors.check, "server/core/a.h", 'auto s = R"(glClear(0))";\n')
        self.assert_found(floors.check, "server/core/a.h", "char c = '\"'; int i = glGetError(); char d = '\"';\n", 1)
        self.assert_found(floors.check, "server/core/a.h", 'auto s = "// no comment"; int i = glGetError();\n', 1)

    def test_cmake_links_as_the_floors_say(self):
        path = "server/bake/CMakeLists.txt"
        self.assert_clean(floors.check, path, "cloudscape_library(bake core gpu vdb PRIVATE Threads::Threads)\n")
        self.assert_found(floors.check, path, "\ncloudscape_library(bake core gpu settings)\n", 2)
        self.assert_found(floors.check, path, "cloudscape_library(bake core)\n", 1)
        self.assert_clean(floors.check, path, "target_link_libraries(bake_check PRIVATE bake gpu)\n")
        self.assert_found(floors.check, path, "target_link_libraries(bake_check PRIVATE bake net)\n", 1)
        self.assert_found(floors.check, "server/app/CMakeLists.txt", "target_link_libraries(cloudscape PRIVATE core net)\n", 1)

    def test_files_keep_their_length(self):
        self.assert_clean(proportions.check, "server/core/a.cpp", "// A.\n" * 400)
        self.assert_found(proportions.check, "server/core/a.cpp", "// A.\n" * 401, 401)
        self.assert_found(proportions.check, "shaders/lib/a.glsl", "// A.\n" * 201, 201)
        self.assert_found(proportions.check, "server/app/main.cpp", "// A.\n" * 101, 101)

    def test_files_say_what_they_do(self):
        self.assert_found(proportions.check, "server/core/a.h", "#pragma once\n", 1)
        self.assert_found(proportions.check, "server/core/a.cpp", '#include "core/b.h"\n', 1)
        pair = {"server/core/a.h": "// What a is.\n", "server/core/a.cpp": '#include "core/a.h"\n'}
        self.assertEqual(self.violations(proportions.check, pair), [])

    def test_few_functions_are_long(self):
        short = "// A.\n" + "".join(f"int f{i}() {{ return {i}; }}\n" for i in range(49))
        long = "int g() {\n" + "  g();\n" * 60 + "  return 1;\n}\n"
        self.assert_clean(proportions.check, "server/core/a.cpp", short + long)
        self.assert_found(proportions.check, "server/core/a.cpp", "// A.\n" + long, 2)

    def test_names_say_something(self):
        self.assert_found(words.check, "server/net/a.h", "// A.\nclass SessionManager {\n", 2)
        self.assert_found(words.check, "server/net/a.h", "struct Server::Impl {\n", 1)
        self.assert_found(words.check, "client/web/a.js", "class PoseHelper {}\n", 1)
        self.assert_found(words.check, "server/net/string_utils.h", "// A.\n", 1)
        self.assert_found(words.check, "server/net/a.h", "// A.\n// TODO: more\n", 2)
        self.assert_clean(words.check, "server/net/a.h", "// No class Manager here.\nstruct Implication;\n")

    def test_shaders_have_blocks_only(self):
        self.assert_found(shaders.check, "shaders/render/a.comp", "// A.\n#version 450\n", 2)
        self.assert_found(shaders.check, "shaders/render/a.comp", "uniform float density;\n", 1)
        self.assert_found(shaders.check, "shaders/render/a.comp", "layout(location = 0) uniform vec4 sun;\n", 1)
        self.assert_clean(shaders.check, "shaders/render/a.comp",
                          "layout(binding = 0) uniform sampler3D shape;\nlayout(rgba16f) writeonly uniform image2D hdr;\n"
                          "layout(binding = 1) uniform writeonly image2D depth;\n"
                          "layout(std140) uniform Frame {\n  vec4 sun;\n} frame;\n// uniform float prose;\n")

    def test_shader_libraries_are_pure(self):
        self.assert_found(shaders.check, "shaders/lib/a.glsl", "float f(float x, out float y) {\n", 1)
        self.assert_found(shaders.check, "shaders/lib/a.glsl", "float f(sampler2D s) {\n", 1)
        self.assert_clean(shaders.check, "shaders/lib/a.glsl", "float about(float outside) { return outside; }\n")

    def test_the_readme_agrees_with_the_tree(self):
        settings = {"config/server.json": '{\n  // Where.\n  "listen": "127.0.0.1:8080",\n  "drain_s": 10\n}\n'}
        table = "## Configuration\n\n| key | default |\n|---|---|\n| `listen`, `drain_s` | `auto` |\n"
        self.assertEqual(self.violations(documents.check, {"README.md": table, **settings}), [])
        misspelled = table.replace("`drain_s`", "`drain`")
        self.assertEqual(self.violations(documents.check, {"README.md": misspelled, **settings}), ["README.md:1", "README.md:5"])
        link = table + "\n[gone](docs/gone.md) [web](https://example.org) [here](config/server.json#listen)\n"
        self.assertEqual(self.violations(documents.check, {"README.md": link, **settings}), ["README.md:7"])


if __name__ == "__main__":
    unittest.main()
