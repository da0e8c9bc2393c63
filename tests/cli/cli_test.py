"""The commands `cloudscape still`, `bake`, `devices` and `list` as processes: files, exit codes, and what they say.

Usage: cli_test.py <cloudscape> [unittest options]. Exit codes: 0 done, 1 failed, 2 wrong usage.
"""
import os
import pathlib
import shutil
import struct
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

PROGRAM = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "cloudscape").resolve()
MAGIC = {"png": b"\x89PNG\r\n\x1a\n", "jpg": b"\xff\xd8\xff", "exr": b"\x76\x2f\x31\x01"}
FEW_CELLS = ", ".join(['{"frequency": 4, "octaves": 2}'] * 4)
DOCUMENT = '{"volume": {"resolution": 16}, "detail": {"resolution": 16}, "noise": {"channels": [' + FEW_CELLS + ']}, "seed": %d}'
SMALL = ["--width", "32", "--height", "18", "--quality", "draft"]


class CliTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.sky = self.write("sky.json", DOCUMENT % 1)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return str(path)

    def run_program(self, *arguments):
        environment = {k: v for k, v in os.environ.items() if not k.startswith("CLOUDSCAPE_")}
        environment["XDG_CACHE_HOME"] = str(self.folder / "cache")
        return subprocess.run([PROGRAM, *arguments], cwd=self.folder, env=environment, timeout=300, text=True,
                              capture_output=True)

    def still(self, cloudscape, output, *options):
        return self.run_program("still", cloudscape, "-o", output, *SMALL, *options)

    def assert_done(self, result):
        self.assertEqual(result.returncode, 0, result.stderr)

    def assert_one_sentence(self, result, code, *parts):
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stdout, "")
        said = [line for line in result.stderr.splitlines() if not line.startswith("baking")]
        self.assertEqual(len(said), 1, result.stderr)
        self.assertTrue(said[0].startswith("cloudscape: "), said)
        for part in parts:
            self.assertIn(part, said[0])

    def bakes(self):
        return sorted((self.folder / "cache" / "cloudscape").glob("*.bake"))


class Still(CliTest):
    def test_each_format_has_its_magic(self):
        for extension, magic in MAGIC.items():
            self.assert_done(self.still(self.sky, f"picture.{extension}"))
            self.assertTrue((self.folder / f"picture.{extension}").read_bytes().startswith(magic), extension)

    def test_two_runs_make_the_same_bytes_and_the_second_does_not_bake(self):
        first = self.still(self.sky, "a.png")
        self.assert_done(first)
        self.assertIn("baking 16^3 texels: 100 %", first.stderr)
        second = self.still(self.sky, "b.png")
        self.assert_done(second)
        self.assertEqual(second.stderr, "")
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())
        self.assert_done(self.still(self.sky, "c.png", "--azimuth-deg", "90"))
        self.assertNotEqual((self.folder / "a.png").read_bytes(), (self.folder / "c.png").read_bytes())

    def test_a_reference_repeats_by_its_seed_and_says_how_far_it_is(self):
        ball = self.write("ball.json", '{"volume": {"kind": "sphere", "origin_m": [-500, 2000, 300], "size_m": [1000, 1000, 1000]}}')
        traced = ["--quality", "reference", "--samples", "2", "--exr-type", "float"]
        for name, seed in (("a", "5"), ("b", "5"), ("c", "6")):
            self.assert_done(self.run_program("still", ball, "-o", name + ".exr", *SMALL[:4], *traced, "--seed", seed))
        a, b, c = ((self.folder / (name + ".exr")).read_bytes() for name in "abc")
        self.assertEqual(a, b)
        self.assertNotEqual(a, c)
        self.assertIn(b"stderr.R\0", a)
        self.assert_one_sentence(self.run_program("still", ball, "-o", "d.exr", *traced, "--noise-target", "0"), 2,
                                 "/noise_target is 0", "within")

    def test_a_damaged_cache_is_told_once_and_baked_anew(self):
        self.assert_done(self.still(self.sky, "a.png"))
        (bake,) = self.bakes()
        whole = bake.read_bytes()
        bake.write_bytes(whole[:2000] + bytes([whole[2000] ^ 1]) + whole[2001:])
        again = self.still(self.sky, "b.png")
        self.assert_done(again)
        self.assertEqual(again.stderr.count("damaged"), 1, again.stderr)
        self.assertIn("baking", again.stderr)
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())
        self.assertEqual(bake.read_bytes(), whole)
        self.assertEqual(self.still(self.sky, "c.png").stderr, "")

    def test_a_cache_that_cannot_be_written_is_told_and_does_no_harm(self):
        self.write("file", "")
        result = self.still(self.sky, "a.png", "--cache-dir", str(self.folder / "file" / "cache"))
        self.assert_done(result)
        self.assertEqual(result.stderr.count("--cache-dir"), 1, result.stderr)
        self.assertTrue((self.folder / "a.png").exists())


class StillConfig(CliTest):
    STILL = '{"title": "Small", "cloudscape": %s, "camera": {"elevation_deg": 20}, "image": {"width": 32, "height": 18, "quality": "draft"}}'

    def setUp(self):
        super().setUp()
        self.config = self.write("still.json", self.STILL % (DOCUMENT % 1))

    def test_a_file_is_rendered_as_it_says_and_options_go_first(self):
        self.assert_done(self.run_program("still", "--config", self.config, "-o", "a.png"))
        self.assert_done(self.still(self.sky, "b.png", "--elevation-deg", "20"))
        self.assertEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())
        self.assert_done(self.run_program("still", "--config", self.config, "-o", "c.png", "--elevation-deg", "30", "--width", "16"))
        self.assertEqual(struct.unpack(">II", (self.folder / "c.png").read_bytes()[16:24]), (16, 18))
        other = self.write("other.json", DOCUMENT % 2)
        self.assert_done(self.run_program("still", other, "--config", self.config, "-o", "d.png"))
        self.assertNotEqual((self.folder / "a.png").read_bytes(), (self.folder / "d.png").read_bytes())

    def test_bad_names_and_files_are_told_in_one_sentence(self):
        run = lambda *arguments: self.run_program("still", *arguments, "-o", "a.png")
        self.assert_one_sentence(run("--config", "fog-bwo"), 1, "still", "fog-bwo", "did you mean fog-bow?")
        self.assert_one_sentence(run("--config", "nowhere/still.json"), 1, "nowhere/still.json")
        broken = self.write("broken.json", '{"cloudscape": "overcast",\n "image": {')
        self.assert_one_sentence(run("--config", broken), 2, broken, "line 2")
        wrong = self.write("wrong.json", '{"cloudscape": "overcast", "image": {"widht": 3}}')
        self.assert_one_sentence(run("--config", wrong), 2, wrong + "#/image/widht", "width")
        unnamed = self.write("unnamed.json", '{"image": {"width": 3}}')
        self.assert_one_sentence(run("--config", unnamed), 2, unnamed + "#/cloudscape", "missing")
        self.assert_one_sentence(run("--config", self.config, "--elevation-deg", "91"), 2, "elevation", "91")
        self.assert_one_sentence(run(), 2, "cloudscape", "--config")
        self.assertEqual(self.bakes(), [], "nothing was baked for it")


class StillRefuses(CliTest):
    def test_an_unknown_cloudscape_and_names_the_nearest(self):
        self.assert_one_sentence(self.still("fair-wether-cumulus", "a.png"), 1, "fair-wether-cumulus",
                                 "fair-weather-cumulus")

    def test_a_missing_document(self):
        self.assert_one_sentence(self.still("nowhere/sky.json", "a.png"), 1, "nowhere/sky.json")

    def test_a_broken_document_with_the_place(self):
        broken = self.write("broken.json", '{"volume": {"resolution": 16},\n "sun": {')
        self.assert_one_sentence(self.still(broken, "a.png"), 2, broken, "line 2")
        wrong = self.write("wrong.json", '{"medium": {"extinction_per_m": -1}}')
        self.assert_one_sentence(self.still(wrong, "a.png"), 2, wrong, "/medium/extinction_per_m", "-1")
        unknown = self.write("unknown.json", '{"medium": {"extinction": 1}}')
        self.assert_one_sentence(self.still(unknown, "a.png"), 2, unknown, "/medium/extinction")

    def test_bad_numbers_with_their_option(self):
        self.assert_one_sentence(self.still(self.sky, "a.png", "--time-s", "soon"), 2, "time", "soon")
        self.assert_one_sentence(self.still(self.sky, "a.png", "--elevation-deg", "91"), 2, "elevation", "91")
        self.assert_one_sentence(self.still(self.sky, "a.png", "--position", "1,2"), 2, "position")

    def test_names_and_folders_it_cannot_write(self):
        self.assert_one_sentence(self.still(self.sky, "a.gif"), 2, "--output", "a.gif", ".png")
        self.assert_one_sentence(self.still(self.sky, "nowhere/a.png"), 1, "nowhere/a.png")
        self.assertEqual(list(self.folder.glob("**/*.gif")), [])
        self.assertEqual(self.bakes(), [], "it was told before anything was baked")

    def test_devices_that_are_not_there(self):
        self.assert_one_sentence(self.still(self.sky, "a.png", "--egl-device", "99"), 2, "99")
        self.assert_one_sentence(self.still(self.sky, "a.png", "--pass-execution", "cpu"), 2, "cpu", "compute")

    def test_wrong_usage_with_code_2(self):
        for arguments in (["still"], ["still", self.sky], ["paint"], [], ["still", self.sky, "-o", "a.png", "--what"]):
            result = self.run_program(*arguments)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertNotEqual(result.stderr, "", arguments)


def grey_png(width, height, pixel):
    """An 8 bit grey PNG; pixel(x, y) is its grey."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + bytes(pixel(x, y) for x in range(width)) for y in range(height))
    return (MAGIC["png"] + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class HeightMaps(CliTest):
    LAND = ('{"volume": {"kind": "box"}, "medium": {"extinction_per_m": 0}, "ground": {"kind": "terrain", "terrain": '
            '{"resolution": 64, "size_m": 6400, "height_map": "%s"}}, "view": {"pose": {"position_m": [3200, 3200, 3000], '
            '"elevation_deg": -60}}}')

    def test_beside_the_document_or_in_the_folder_that_is_named(self):
        land = self.write("land.json", self.LAND % "hill.png")
        hill = grey_png(32, 32, lambda x, y: min(255, x * y))
        (self.folder / "hill.png").write_bytes(hill)
        self.assert_done(self.still(land, "a.png"))
        (self.folder / "maps").mkdir()
        (self.folder / "maps" / "hill.png").write_bytes(grey_png(32, 32, lambda x, y: 0))
        self.assert_done(self.still(land, "b.png", "--height-map-dir", str(self.folder / "maps")))
        self.assertNotEqual((self.folder / "a.png").read_bytes(), (self.folder / "b.png").read_bytes())

    def test_that_are_missing_or_damaged_are_named(self):
        self.assert_one_sentence(self.still(self.write("land.json", self.LAND % "none.png"), "a.png"), 1, "'none.png'",
                                 "is not in the folder")
        self.write("text.png", "no picture")
        self.assert_one_sentence(self.still(self.write("land.json", self.LAND % "text.png"), "a.png"), 1, "'text.png'",
                                 "damaged")

    def test_elsewhere_are_refused(self):
        for name in ("../hill.png", "/etc/hill.png", "hill.jpg"):
            self.assert_one_sentence(self.still(self.write("land.json", self.LAND % name), "a.png"), 2,
                                     "/ground/terrain/height_map", name, "bare name")


PATH = '{"keys": [{"time_s": 0, "pose": {"azimuth_deg": 0}}, {"time_s": 1, "pose": {"azimuth_deg": 30}, "vertical_fov_deg": 60}]}'


class Sequence(CliTest):
    def setUp(self):
        super().setUp()
        self.path = self.write("path.json", PATH)

    def sequence(self, *options, output="frame_###.png", path=None):
        return self.still(self.sky, output, "--path", path or self.path, "--frames-per-second", "4", *options)

    def files(self, pattern="frame_*"):
        return {file.name: file.read_bytes() for file in self.folder.glob(pattern)}

    def test_a_file_a_frame_each_as_the_still_at_its_time(self):
        result = self.sequence("--frames", "2-4", "--time-s", "10")
        self.assert_done(result)
        frames = self.files()
        self.assertEqual(sorted(frames), ["frame_002.png", "frame_003.png", "frame_004.png"])
        self.assertIn("3 of 3 frames", result.stderr)
        self.assert_done(self.still(self.sky, "last.png", "--azimuth-deg", "30", "--elevation-deg", "10", "--position",
                                    "0,0,2", "--vertical-fov-deg", "60", "--time-s", "11"))
        self.assertEqual((self.folder / "last.png").read_bytes(), frames["frame_004.png"])
        self.assertNotEqual(frames["frame_002.png"], frames["frame_003.png"])

    def test_the_whole_path_is_the_default_and_every_format_is_written(self):
        for extension, magic in MAGIC.items():
            self.assert_done(self.sequence(output=f"f#.{extension}"))
            files = self.files(f"f*.{extension}")
            self.assertEqual(len(files), 5, "0 to 1 s at 4 frames a second")
            for name, content in files.items():
                self.assertTrue(content.startswith(magic), name)
        self.assertEqual(list(self.folder.glob(".*")), [], "nothing temporary is left")

    def test_resume_renders_what_is_missing_or_broken_and_nothing_else(self):
        self.assert_done(self.sequence())
        whole = self.files()
        self.write("frame_000.png", "broken")
        (self.folder / "frame_001.png").unlink()
        (self.folder / "frame_002.png").write_bytes(whole["frame_002.png"][:-1])
        kept = (self.folder / "frame_003.png").stat()
        result = self.sequence("--resume")
        self.assert_done(result)
        self.assertIn("2 of 5 frames are there already", result.stderr)
        self.assertEqual(self.files(), whole)
        self.assertEqual((self.folder / "frame_003.png").stat().st_ino, kept.st_ino)
        self.assertIn("5 of 5 frames are there already", self.sequence("--resume").stderr)
        self.assert_done(self.sequence())
        self.assertNotEqual((self.folder / "frame_003.png").stat().st_ino, kept.st_ino, "without it all are rendered")

    def test_an_interrupted_run_leaves_whole_files_and_says_how_to_go_on(self):
        environment = {k: v for k, v in os.environ.items() if not k.startswith("CLOUDSCAPE_")}
        program = subprocess.Popen(
            [PROGRAM, "still", self.sky, "-o", "frame_####.png", "--path", self.path, "--frames-per-second", "1000", *SMALL,
             "--cache-dir", str(self.folder / "cache")], cwd=self.folder, env=environment, stderr=subprocess.PIPE, text=True)
        end = time.monotonic() + 120
        while not self.files() and time.monotonic() < end:
            time.sleep(0.01)
        program.send_signal(signal.SIGINT)
        said = program.communicate(timeout=120)[1]
        self.assertEqual(program.returncode, 130, said)
        self.assertIn("--resume", said)
        files = self.files()
        self.assertLess(len(files), 1001)
        self.assertIn(f"stopped after {len(files)} of 1001 frames", said)
        for name, content in files.items():
            self.assertTrue(content.endswith(b"IEND\xae\x42\x60\x82"), name)
        self.assertEqual(list(self.folder.glob(".*")), [])

    def test_refuses_in_one_sentence_before_it_renders(self):
        for options, code, parts in (
                (("--frames", "3-2"), 2, ("--frames", "3-2")), (("--frames", "all"), 2, ("--frames", "'all'", "0-299")),
                (("--frames", "0-9"), 2, ("--frames", "0-9", "frame 4")), (("--azimuth-deg", "3"), 2, ("--path", "azimuth"))):
            self.assert_one_sentence(self.sequence(*options), code, *parts)
        self.assert_one_sentence(self.sequence(output="frame.png"), 2, "--output", "#")
        self.assert_one_sentence(self.sequence(output="nowhere/#.png"), 1, "nowhere/0.png")
        self.assert_one_sentence(self.sequence(path="fly-arund"), 1, "fly-around")
        self.assert_one_sentence(self.sequence(path="nowhere/path.json"), 1, "nowhere/path.json")
        self.assert_one_sentence(self.still(self.sky, "a.png", "--resume"), 2, "--resume", "--path")
        self.assertEqual(self.bakes(), [], "nothing was baked for it")


class Bake(CliTest):
    def test_writes_the_textures_and_fills_the_cache(self):
        result = self.run_program("bake", self.sky, "--out", "textures")
        self.assert_done(result)
        self.assertIn("textures/shape.exr", result.stdout)
        for name in ("shape.exr", "detail.exr"):
            self.assertTrue((self.folder / "textures" / name).read_bytes().startswith(MAGIC["exr"]), name)
        self.assertEqual(len(self.bakes()), 1)
        self.assertEqual(self.still(self.sky, "a.png").stderr, "")

    def test_another_seed_is_another_bake(self):
        self.assert_done(self.run_program("bake", self.sky))
        self.assert_done(self.run_program("bake", self.write("other.json", DOCUMENT % 2)))
        self.assertEqual(len(self.bakes()), 2)

    def test_layers_have_one_format_of_their_own(self):
        layers = '{"layers": [{"noise": {"frequency": 4, "octaves": 2}}], ' + (DOCUMENT % 1)[1:]
        result = self.run_program("bake", self.write("layers.json", layers), "--verbose", "--out", "baked")
        self.assert_done(result)
        rows = [line.split() for line in result.stdout.splitlines()[1:-1]]
        self.assertEqual([row[:2] for row in rows], [["rg16f", "16x16x16"]])
        self.assertEqual((self.folder / "baked" / "shape.exr").read_bytes()[:4], MAGIC["exr"])
        low = self.write("low.json", '{"layers": [{"bottom_m": 10}]}')
        self.assert_one_sentence(self.run_program("bake", low), 2, "low.json#/layers/0/bottom_m is 10: must be an altitude")

    def test_verbose_tells_what_each_format_costs(self):
        result = self.run_program("bake", self.sky, "--verbose")
        self.assert_done(result)
        head, *rows = [line.split() for line in result.stdout.splitlines()]
        self.assertEqual(head[0], "format")
        variation = 8 * 128**2  # bytes on disk; on the device twice as many
        others = 4 * 16**3 + 2 * variation  # bytes of the detail texture and of the variation map
        self.assertEqual([row[:3] for row in rows], [["rgba8", "16x16x16", str(4 * 16**3 + others)],
                                                     ["r16f", "16x16x16", str(2 * 16**3 + others)]])
        for row in rows:
            self.assertGreater(int(row[3]), int(row[2]) - variation)
            self.assertLess(int(row[3]), int(row[2]) - variation + 200)
            self.assertGreaterEqual(float(row[4]), 0)  # 16^3 texels take a millisecond
            self.assertGreaterEqual(float(row[5]), 0)
        (bake,) = self.bakes()
        self.assertEqual(bake.stat().st_size, int(rows[0][3]))
        self.assertEqual(self.still(self.sky, "a.png").stderr, "")

    def test_a_mixed_shape_has_one_channel(self):
        mixed = self.write("mixed.json", (DOCUMENT % 1).replace('"resolution": 16}', '"resolution": 16, "format": "r16f"}', 1))
        self.assert_done(self.run_program("bake", mixed, "--out", "textures"))
        header = (self.folder / "textures" / "shape.exr").read_bytes()[:400]
        self.assertIn(b"channels\0chlist\0", header)
        self.assertIn(b"Y\0\1\0\0\0", header)
        self.assertNotIn(b"G\0\1\0\0\0", header)

    def test_refuses_a_folder_that_is_a_file(self):
        blocked = self.write("textures", "")
        self.assert_one_sentence(self.run_program("bake", self.sky, "--out", blocked), 1, blocked)


class Lists(CliTest):
    def test_devices_has_a_line_a_device_and_one_that_works(self):
        result = self.run_program("devices")
        self.assert_done(result)
        self.assertRegex(result.stdout, r"(?i)llvmpipe|softpipe|nvidia|amd|radeon|intel")

    def test_list_names_each_preset_with_a_sentence(self):
        result = self.run_program("list")
        self.assert_done(result)
        presets = {file.stem for file in (pathlib.Path(__file__).parents[2] / "config/cloudscapes").glob("*.json")}
        self.assertEqual({line.split()[0] for line in result.stdout.splitlines()}, presets)
        for line in result.stdout.splitlines():
            self.assertRegex(line, r"^[a-z0-9-]+ +[A-Z].*\.$")

    def test_list_names_each_still_with_a_sentence(self):
        result = self.run_program("list", "--stills")
        self.assert_done(result)
        stills = {file.stem for file in (pathlib.Path(__file__).parents[2] / "config/stills").glob("*.json")}
        self.assertEqual({line.split()[0] for line in result.stdout.splitlines()}, stills)
        for line in result.stdout.splitlines():
            self.assertRegex(line, r"^[a-z0-9-]+ +[A-Z].*\.$")

    def test_help_and_version(self):
        self.assertRegex(self.run_program("--version").stdout, r"^cloudscape \d+\.\d+\.\d+\n$")
        help_text = self.run_program("still", "--help")
        self.assert_done(help_text)
        for option in ("--elevation-deg", "--quality", "--egl-device", "--output"):
            self.assertIn(option, help_text.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
