"""`cloudscape bench realtime` and `bench streams` as processes: short runs of tiny pictures, and what they refuse.

Usage: realtime_test.py <cloudscape> [unittest options].
"""
import json
import sys
import unittest

from cli_test import CliTest as Cli

PATH = """{"keys": [{"time_s": 0, "pose": {"position_m": [0, 0, 200], "elevation_deg": 20}},
                    {"time_s": 4, "pose": {"position_m": [400, 0, 300], "elevation_deg": 30}}]}"""


class Realtime(Cli):
    def setUp(self):
        super().setUp()
        self.path = self.write("path.json", PATH)

    def bench(self, name, *options):
        return self.run_program("bench", name, "--cloudscape", self.sky, "--path", self.path, "--warm-up", "0.3", *options)

    def test_flies_and_judges(self):
        result = self.bench("realtime", "--size", "64x36", "--speed", "1", "--frames", "6", "--legs", "9",
                            "--truth-samples", "2", "--flicker-frames", "4", "--flicker-size", "32x18", "-o", "results/a.json")
        self.assert_done(result)
        for part in ("64x36", "at 103 m/s", "frame to frame", "CPU of a frame", "LDR-FLIP (67 px a degree)", "PSNR", "slow pan"):
            self.assertIn(part, result.stdout)
        self.assertIn("judging the moving pictures: 100 %", result.stderr)
        told = json.loads((self.folder / "results/a.json").read_text())
        flight, quality = told["flight"], told["quality"]
        self.assertGreaterEqual(flight["frames"], 6)
        self.assertAlmostEqual(flight["fps"]["mean"], flight["frames"] / flight["seconds"])
        for figure in (flight["interval"]["median_ms"], flight["render"]["median_ms"], flight["bytes_per_frame"]):
            self.assertGreater(figure, 0)
        self.assertGreater(flight["cpu_ms_per_frame"], 0)
        self.assertEqual(len(quality["compared"]), 12, "every tenth frame of four seconds")
        self.assertTrue(0 < quality["flip"]["mean"] <= quality["flip"]["worst"] < 1, quality["flip"])
        self.assertEqual(quality["flicker"]["size_px"], [32, 18])
        self.assertEqual(quality["flicker"]["pan"]["frames"], 4)

    def test_the_judgement_depends_on_no_clock(self):
        judged = []
        for name in ("a.json", "b.json"):
            self.assert_done(self.bench("realtime", "--size", "64x36", "--seconds", "0.2", "--detail", "2", "--legs", "1",
                                        "--truth-samples", "2", "--flicker-frames", "4", "-o", name))
            quality = json.loads((self.folder / name).read_text())["quality"]
            judged.append((quality["compared"], quality["flicker"]))
        self.assertEqual(judged[0], judged[1])

    def test_moves_the_sun(self):
        self.assert_done(self.bench("realtime", "--size", "64x36", "--seconds", "0.5", "--legs", "0", "--flicker-frames", "0",
                                    "--sun-speed", "40", "--sun-climb", "-40"))

    def test_judges_nothing_where_nothing_is_asked_for(self):
        result = self.bench("realtime", "--size", "64x36", "--seconds", "0.3", "--legs", "0", "--flicker-frames", "0")
        self.assert_done(result)
        self.assertNotIn("FLIP", result.stdout)

    def test_measures_so_many_streams(self):
        for seconds in (1.5, 6, 24, 96):  # until each has shown frames, on a machine that is slow or has other work
            result = self.bench("streams", "--size", "64x36", "--streams", "3", "--seconds", str(seconds), "-o", "streams.json")
            self.assert_done(result)
            (measured,) = json.loads((self.folder / "streams.json").read_text())["measured"]
            slowest_fps = min(stream["fps"] for stream in measured["each"])
            if slowest_fps > 0:
                break
        self.assertGreater(slowest_fps, 0)
        self.assertRegex(result.stdout, r"30 frames a second: (not )?held\n60 frames a second: (not )?held")
        self.assertEqual(measured["streams"], 3)
        self.assertEqual(len(measured["each"]), 3)
        self.assertGreater(measured["bytes_per_stream"], 0)
        self.assertLessEqual(measured["bytes_per_stream"], 64 * 36 * 40)

    def test_searches(self):
        result = self.bench("streams", "--size", "16x9", "--most", "2", "--seconds", "0.3")
        self.assert_done(result)
        self.assertRegex(result.stdout, r"30 frames a second: [012] streams.*\n60 frames a second: [012] streams")
        self.assertIn("1 streams\n", result.stderr)

    def test_refuses_what_it_cannot_do(self):
        self.assert_one_sentence(self.bench("realtime", "--size", "64"), 2, "--size", "WIDTHxHEIGHT")
        self.assert_one_sentence(self.bench("realtime", "--size", "64x36", "--frames", "1", "--flicker-size", "no"), 2,
                                 "--flicker-size", "WIDTHxHEIGHT")
        self.assert_one_sentence(self.bench("streams", "--size", "64x36", "-o", "path.json/streams.json"), 2, "--output")
        for option, value in (("--speed", "0"), ("--streams", "0"), ("--poses", "none")):
            result = self.bench("streams", option, value)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn(option, result.stderr)


del Cli  # or its tests would run here too

if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
