"""`cloudscape bench track` as a process: the form of its table, JSON and plots, and what it refuses.

Usage: track_test.py <cloudscape> [unittest options].
"""
import json
import sys
import unittest
import xml.etree.ElementTree as ElementTree

from cli_test import CliTest as Cli

PATH = """{"keys": [{"time_s": 0, "pose": {"position_m": [0, 0, 200], "elevation_deg": 20}},
                    {"time_s": 4, "pose": {"position_m": [100, 0, 300], "elevation_deg": 30}}],
           "sections": [{"name": "first", "begin_s": 0, "end_s": 2}, {"name": "last", "begin_s": 2, "end_s": 4}]}"""
SVG = "{http://www.w3.org/2000/svg}"


class Track(Cli):
    def setUp(self):
        super().setUp()
        self.path = self.write("path.json", PATH)

    def track(self, *options):
        arguments = {"--cloudscape": self.sky, "--path": self.path, "--size": "64x36", "--frames": "4"}
        arguments.update(zip(options[::2], options[1::2]))
        return self.run_program("bench", "track", *[word for pair in arguments.items() for word in pair])

    def test_prints_tables_and_writes_json_and_plots(self):
        result = self.track("--variants", "adaptive-on,phase-none", "-o", "results")
        self.assert_done(result)
        for part in ("Table 3.2: adaptive step length", "Table 3.4: phase function", "on / off", "0.917", "by section"):
            self.assertIn(part, result.stdout)
        self.assertNotIn("Table 3.1", result.stdout)
        self.assertIn("flying along the track: 100 %", result.stderr)
        self.check_json(json.loads((self.folder / "results/track.json").read_text()))
        figures = sorted(file.name for file in (self.folder / "results").glob("*-wall.svg"))
        self.assertEqual(figures, ["figure-3.2-wall.svg", "figure-3.3-wall.svg", "figure-3.5-wall.svg"])
        for name in figures:
            self.check_plot(ElementTree.parse(self.folder / "results" / name).getroot(), 1 if "3.3" in name else 2)

    def check_json(self, track):
        self.assertEqual(track["benchmark"], "track")
        self.assertGreater(track["machine"]["cores"], 0)
        self.assertEqual(track["size_px"], [64, 36])
        self.assertEqual(track["frames"]["section"], ["first", "first", "last", "last"])
        self.assertEqual([variant["name"] for variant in track["variants"]], ["base", "adaptive-on", "phase-none"])
        self.assertEqual([table["table"] for table in track["tables"]], ["3.2", "3.4"])
        for variant in track["variants"]:
            self.assertEqual(set(variant["sections"]), {"first", "last"})
            times = variant["frames"]["wall_ms"]
            self.assertEqual(len(times), 4)
            self.assertGreater(min(times), 0)
            self.assertGreater(min(variant["frames"]["cpu_ms"]), 0)
            self.assertAlmostEqual(variant["wall"]["mean_ms"], sum(times) / 4)

    def check_plot(self, svg, curves):
        self.assertEqual(svg.tag, SVG + "svg")
        drawn = [path for path in svg.iter(SVG + "path") if path.get("stroke-linejoin")]
        self.assertEqual(len(drawn), curves)
        for path in drawn:
            self.assertEqual(path.get("d").count("L"), 3, "a line through four frames")

    def test_json_and_plots_go_where_they_are_told(self):
        self.assert_done(self.track("--variants", "light-off", "-o", "a/b/track.json", "--plots", "plots"))
        self.assertTrue((self.folder / "a/b/track.json").exists())
        self.assertTrue((self.folder / "plots/figure-3.4-wall.svg").exists())

    def test_refuses_what_it_does_not_know(self):
        self.assert_one_sentence(self.track("--variants", "structure-of"), 2, "--variants", "'structure-of'",
                                 "structure-off")
        for size in ("64", "0x36", "64x36x2", "9000x10"):
            self.assert_one_sentence(self.track("--size", size), 2, "--size", size, "WIDTHxHEIGHT")
        for frames in ("0", "-1", "many"):
            result = self.track("--frames", frames)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn("--frames", result.stderr)

    def test_refuses_paths_that_are_none(self):
        self.assert_one_sentence(self.track("--path", "test-trak"), 1, "test-trak", "test-track")
        self.assert_one_sentence(self.track("--path", "nowhere/path.json"), 1, "nowhere/path.json")
        broken = self.write("broken.json", '{"keys": [')
        self.assert_one_sentence(self.track("--path", broken), 2, broken)
        backwards = self.write("backwards.json", '{"keys": [{"time_s": 2}, {"time_s": 1}]}')
        self.assert_one_sentence(self.track("--path", backwards), 2, backwards + "#/keys/1/time_s", "more than")

    def test_refuses_a_folder_that_is_a_file_before_it_renders(self):
        blocked = self.write("blocked", "")
        self.assert_one_sentence(self.track("-o", "blocked"), 2, "--output", "blocked")
        self.assert_one_sentence(self.track("--plots", blocked), 2, "--plots", blocked)


del Cli  # or its tests would run here too

if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
