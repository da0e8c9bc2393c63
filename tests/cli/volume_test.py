"""Volumes from files on the command line: `cloudscape bake --vdb`, documents that name its file, and files that are none.

Usage: volume_test.py <cloudscape> [unittest options]. Exit codes: 0 done, 1 failed, 2 wrong usage.
"""
import array
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "container"))
from png_pixels import read_png  # noqa: E402

PROGRAM = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "cloudscape").resolve()
CACHE = tempfile.mkdtemp()
SMALL = ["--width", "64", "--height", "36", "--quality", "standard", "--samples", "4"]
WITHOUT = "a program without OpenVDB"

# Seen from the south, lit from the south-west; in small steps, so that no edge is softened by their length.
MARCH = {"step_m": 12, "max_steps": 1000}
VIEW = {"pose": {"position_m": [0, -3000, 600], "azimuth_deg": 0, "elevation_deg": 6}, "lens": {"vertical_fov_deg": 22}, "march": MARCH}
SKY = {"sun": {"azimuth_deg": 220, "elevation_deg": 40}, "wind": {"speed_m_per_s": 0}, "view": VIEW}
BALL = SKY | {"volume": {"kind": "sphere", "origin_m": [-500, -500, 400], "size_m": [1000, 1000, 1000]},
              "medium": {"extinction_per_m": 0.004}}
CLOUDS = SKY | {
    "view": VIEW | {"pose": {"position_m": [0, -1200, 100], "elevation_deg": 38}, "lens": {"vertical_fov_deg": 40}},
    "volume": {"origin_m": [-1000, -1000, 500], "size_m": [2000, 2000, 1000], "resolution": 32, "tiling": False},
    "noise": {"channels": [{"frequency": 4, "octaves": 2}] * 4}, "detail": {"resolution": 16, "period_m": 500},
    "shape": {"coverage": 0.5}}


def from_file(document, file, **grid):
    volume = {"kind": "vdb" if file.endswith(".vdb") else "grid", "grid": {"file": file, **grid}}
    return {**document, "volume": {**document["volume"], **volume}}


def mean_difference(a, b):
    """Of two PNG files, in steps of 8 bits a channel."""
    pixels = [[value for row in read_png(path.read_bytes())[2] for pixel in row for value in pixel] for path in (a, b)]
    return sum(abs(x - y) for x, y in zip(*pixels)) / len(pixels[0])


class VolumeTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, *arguments], cwd=self.folder, timeout=600, text=True, capture_output=True,
                              env={"PATH": "/usr/bin:/bin", "XDG_CACHE_HOME": CACHE})

    def document(self, name, document):
        (self.folder / name).write_text(json.dumps(document))
        return name

    def done(self, *arguments):
        result = self.run_program(*arguments)
        if WITHOUT in result.stderr or "cannot write OpenVDB" in result.stderr:
            self.skipTest("built without OpenVDB")
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def still(self, document, output):
        self.done("still", self.document("sky.json", document), "-o", output, *SMALL)
        return self.folder / output

    def refused(self, document, code, *parts):
        result = self.run_program("still", self.document("sky.json", document), "-o", "a.png", *SMALL)
        self.assertEqual((result.returncode, result.stdout), (code, ""), result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        for part in parts:
            self.assertIn(part, result.stderr)
        self.assertFalse((self.folder / "a.png").exists())


class RoundTrip(VolumeTest):
    def test_a_ball_is_the_ball(self):
        told = self.done("bake", self.document("ball.json", BALL), "--vdb", "ball.vdb", "--vdb-resolution", "100")
        self.assertEqual(told, "ball.vdb: 100x100x100 voxels of 10 m, z up; extinction_per_m 0.004 where density is 1\n")
        ball = self.still(BALL, "ball.png")
        copy = self.still(from_file(BALL, "ball.vdb"), "copy.png")
        nothing = self.still(BALL | {"medium": {"extinction_per_m": 0}}, "nothing.png")
        self.assertGreater(mean_difference(ball, nothing), 5)
        self.assertLess(mean_difference(ball, copy), 0.4)

    def test_clouds_are_the_clouds_whichever_axis_is_up(self):
        """By sky and ground alone they agree to five steps of 255; lit by the sun to eight, since noise is lit through a coarser
        shape than it shows, which voxels are not. Voxels of 10 m smooth the edges."""
        even = CLOUDS | {"view": CLOUDS["view"] | {"march": MARCH | {"lighting": False}}}
        clouds, flat = self.still(CLOUDS, "clouds.png"), self.still(even, "even.png")
        nothing = self.still(CLOUDS | {"medium": {"extinction_per_m": 0}}, "nothing.png")
        self.assertGreater(mean_difference(clouds, nothing), 10)
        document = self.document("clouds.json", CLOUDS)
        for up in ("z", "y"):
            self.done("bake", document, "--vdb", f"{up}.vdb", "--vdb-resolution", "200", "--vdb-up", up)
            self.assertLess(mean_difference(clouds, self.still(from_file(CLOUDS, f"{up}.vdb", up=up), "copy.png")), 8)
            self.assertLess(mean_difference(flat, self.still(from_file(even, f"{up}.vdb", up=up), "copy.png")), 5)

    def test_a_written_volume_can_be_written_again(self):
        self.done("bake", self.document("ball.json", BALL), "--vdb", "a.vdb", "--vdb-resolution", "40")
        again = self.document("again.json", from_file(BALL, "a.vdb"))
        self.assertIn("40x40x40 voxels of 25 m", self.done("bake", again, "--vdb", "b.vdb", "--vdb-resolution", "40"))
        a = self.still(from_file(BALL, "a.vdb"), "a.png")
        b = self.still(from_file(BALL, "b.vdb"), "b.png")
        self.assertLess(mean_difference(a, b), 1)

    def test_placed_by_the_file_or_in_a_box(self):
        self.done("bake", self.document("ball.json", BALL), "--vdb", "ball.vdb", "--vdb-resolution", "40")
        small = BALL | {"volume": {"kind": "sphere", "origin_m": [-700, -300, 600], "size_m": [500, 500, 500]}}
        small["medium"] = {"extinction_per_m": 0.004}
        own = self.still(small, "small.png")
        boxed = self.still(from_file(small, "ball.vdb", placement="box"), "boxed.png")
        scaled = from_file(BALL, "ball.vdb", metres_per_unit=0.5, offset_m=[-450, -50, 400])
        moved = self.still(scaled, "moved.png")
        self.assertLess(mean_difference(own, boxed), 0.6)
        self.assertLess(mean_difference(own, moved), 0.6)
        self.refused(from_file(BALL, "ball.vdb", metres_per_unit=1e-6), 1, "'ball.vdb'", "metres_per_unit")
        self.refused(from_file(BALL, "ball.vdb", name="smoke"), 1, "has no grid 'smoke': it has 'density'")

    def test_options_that_cannot_be(self):
        document = self.document("ball.json", BALL)
        for options, part in ((["--vdb-resolution", "4"], "--vdb-resolution"), (["--vdb-up", "x"], "--vdb-up")):
            result = self.run_program("bake", document, "--vdb", "a.vdb", *options)
            self.assertEqual(result.returncode, 2)
            self.assertIn(part, result.stderr)
        result = self.run_program("bake", document, "--vdb", "nowhere/a.vdb")
        self.assertNotEqual(result.returncode, 0)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)


class Examples(VolumeTest):
    def test_of_the_repository_render(self):
        examples = sorted((pathlib.Path(__file__).parents[2] / "config" / "volumes").glob("*.json"))
        self.assertGreaterEqual(len(examples), 2)
        for example in examples:
            output = self.folder / f"{example.stem}.png"
            self.done("still", str(example), "-o", str(output), *SMALL)
            brightest = max(max(pixel) for row in read_png(output.read_bytes())[2] for pixel in row)
            self.assertGreater(brightest, 60, example.name)


class Files(VolumeTest):
    def grid(self, file, size=(2, 2, 2), **grid):
        return from_file(BALL, file, size=list(size), **grid)

    def test_of_raw_floats_beside_the_document_or_in_the_folder_that_is_named(self):
        (self.folder / "a.raw").write_bytes(array.array("f", [0.5] * 8).tobytes())
        beside = self.still(self.grid("a.raw"), "a.png")
        (self.folder / "volumes").mkdir()
        (self.folder / "volumes" / "a.raw").write_bytes(array.array("f", [0.5, 0] * 4).tobytes())
        self.done("still", self.document("sky.json", self.grid("a.raw")), "-o", "b.png", "--volume-dir", "volumes", *SMALL)
        self.assertGreater(mean_difference(beside, self.folder / "b.png"), 1)

    def test_that_cannot_be_used_are_named(self):
        self.refused(self.grid("none.raw"), 1, "'none.raw'", "is not in the folder")
        (self.folder / "a.raw").write_bytes(bytes(31))
        self.refused(self.grid("a.raw"), 1, "'a.raw'", "has 31 bytes, and 2x2x2 voxels", "volume.grid.size")
        (self.folder / "a.vdb").write_text("this is no volume")
        self.refused(self.grid("a.vdb"), 1, "'a.vdb'", "")

    def test_elsewhere_are_refused(self):
        for name in ("../a.raw", "/etc/a.raw", "a.txt", ""):
            self.refused({**BALL, "volume": {"kind": "grid", "grid": {"file": name}}}, 2, "/volume/grid/file", "bare name")
        self.refused({**BALL, "volume": {"kind": "vdb", "grid": {"file": "a.raw"}}}, 2, "/volume/grid/file", ".vdb")


if __name__ == "__main__":
    try:
        unittest.main(argv=sys.argv[:1] + sys.argv[2:])
    finally:
        shutil.rmtree(CACHE, ignore_errors=True)
