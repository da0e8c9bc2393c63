"""./run in a tree of its own, with dpkg, apt, sudo and CMake played by scripts: what it installs, builds and says."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = "bash env sh sed sort comm tail head mkdir nproc awk tee grep readlink dirname cat id touch".split()
NOBODY = 65534
FAKES = {
    "dpkg-query": 'sed "s/^/installed /" "$TREE/installed"',
    "apt-get": 'echo "$*" >>"$TREE/apt-calls"; case "$*" in *install*) exit "${APT_EXIT:-0}";; esac',
    "cmake": """echo "$*" >>"$TREE/cmake-calls"
        case "$1" in
          --preset) mkdir -p "build/$2"; touch "build/$2/build.ninja"; exit "${CONFIGURE_EXIT:-0}" ;;
          --build) echo "a.cpp:1:2: error: no such thing"; exit "${BUILD_EXIT:-0}" ;;
        esac""",
}
LISTS = ". .ci/packages.sh; echo $compiler_packages $library_packages $viewer_packages $runtime_packages"


class RunTest(unittest.TestCase):
    def setUp(self):
        self.tree = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.tree)
        shutil.copy(ROOT / "run", self.tree)
        shutil.copytree(ROOT / ".ci", self.tree / ".ci")
        (self.tree / "CMakePresets.json").write_text("{}")
        self.bin = self.tree / "bin"
        self.bin.mkdir()
        for tool in TOOLS:
            (self.bin / tool).symlink_to(shutil.which(tool))
        for name, body in FAKES.items():
            self.write_program(self.bin / name, body)
        self.needed = subprocess.run(["bash", "-c", LISTS], cwd=ROOT, text=True, stdout=subprocess.PIPE).stdout.split()
        self.set_installed(self.needed)
        self.write_program(self.tree / "build/release/cloudscape", 'echo "served: $*"')

    def write_program(self, path, body):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"#!/bin/sh\n{body}\n")
        path.chmod(0o755)

    def set_installed(self, packages):
        (self.tree / "installed").write_text("".join(f"{package}\n" for package in packages))

    def calls(self, program):
        file = self.tree / f"{program}-calls"
        return file.read_text().splitlines() if file.exists() else []

    def run_script(self, *arguments, user=None, **environment):
        return subprocess.run([self.tree / "run", *arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              user=user, env={"PATH": str(self.bin), "TREE": str(self.tree), **environment})

    def assert_fails(self, done, *words):
        self.assertNotEqual(done.returncode, 0)
        last = done.stderr.splitlines()[-1]
        self.assertTrue(last.startswith("./run: "), done.stderr)
        for word in words:
            self.assertIn(word, last)
        self.assertNotIn("served", done.stdout)

    def test_serves_with_its_arguments(self):
        done = self.run_script("--listen", "127.0.0.1:9000")
        self.assertEqual((done.returncode, done.stdout), (0, "served: serve --listen 127.0.0.1:9000\n"), done.stderr)
        self.assertEqual(self.calls("apt"), [])

    def test_configures_once(self):
        for _ in range(2):
            self.run_script()
        self.assertEqual([call.split()[0] for call in self.calls("cmake")], ["--preset", "--build", "--build"])

    def test_configures_again_where_something_was_missing(self):
        self.run_script()
        self.set_installed(self.needed[1:])
        self.run_script()
        self.assertEqual([call.split()[0] for call in self.calls("cmake")], ["--preset", "--build"] * 2)

    def test_installs_what_is_missing_and_only_that(self):
        self.set_installed(package for package in self.needed if package not in ("cmake", "libssl-dev"))
        done = self.run_script()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(self.calls("apt")[1].endswith("install --no-install-recommends cmake libssl-dev"), self.calls("apt"))

    def test_says_that_packages_cannot_be_installed(self):
        self.set_installed(self.needed[1:])
        self.assert_fails(self.run_script(APT_EXIT="100"), "apt-get", "build/logs/apt.log")
        self.assertEqual(self.calls("cmake"), [])

    def test_says_that_there_is_no_apt(self):
        (self.bin / "apt-get").unlink()
        self.assert_fails(self.run_script(), "Debian 12", "apt-get")

    @unittest.skipUnless(os.geteuid() == 0, "only root can play another user")
    def test_says_that_it_needs_root_or_sudo(self):
        self.set_installed(self.needed[1:])
        self.tree.chmod(0o755)
        self.assert_fails(self.run_script(user=NOBODY), "root or sudo", self.needed[0])

    @unittest.skipUnless(os.geteuid() == 0, "only root can play another user")
    def test_installs_through_sudo(self):
        self.set_installed(self.needed[1:])
        self.tree.chmod(0o777)
        for folder in (self.tree / "build", self.tree / "build/release"):
            folder.chmod(0o777)
        self.write_program(self.bin / "sudo", 'echo "sudo $1" >>"$TREE/sudo-calls"; shift; exec "$@"')
        done = self.run_script(user=NOBODY)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.calls("sudo"), ["sudo -n", "sudo -n"], "it never waits for a password without a terminal")
        self.assertIn(self.needed[0], self.calls("apt")[1])

    def test_says_that_configuring_failed(self):
        self.assert_fails(self.run_script(CONFIGURE_EXIT="1"), "could not configure", "build/logs/release-configure.log")

    def test_shows_the_compiler_errors_and_the_log(self):
        done = self.run_script(BUILD_EXIT="1")
        self.assert_fails(done, "did not build", "build/logs/release-build.log")
        self.assertIn("error: no such thing", done.stderr)


if __name__ == "__main__":
    unittest.main()
