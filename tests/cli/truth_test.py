"""`cloudscape bench truth` as a process: what it prints, its JSON, its page and pictures, kept references, and what it refuses.

Usage: truth_test.py <cloudscape> [unittest options].
"""
import html.parser
import json
import sys
import unittest

from cli_test import CliTest as Cli, MAGIC

MODELS = ["single", "beer-octaves"]
TRACED = "path tracing the reference"


class Sources(html.parser.HTMLParser):
    def __init__(self, page):
        super().__init__()
        self.found = []
        self.feed(page)

    def handle_starttag(self, tag, attributes):
        if tag == "img":
            self.found.append(dict(attributes)["src"])


class Truth(Cli):
    def truth(self, *options):
        arguments = {"--views": "noon", "--size": "32x18", "--samples": "2", "--model-samples": "1", "--quality": "draft",
                     "--cost-size": "32x18", "--cost-frames": "2"}
        arguments.update(zip(options[::2], options[1::2]))
        return self.run_program("bench", "truth", *[word for pair in arguments.items() for word in pair])

    def test_compares_two_models_and_keeps_the_reference(self):
        first = self.truth("--models", ",".join(MODELS), "-o", "report", "--references", "kept")
        self.assert_done(first)
        self.assertEqual(first.stderr.count(TRACED), 1)
        for part in ("noon: Noon", "LDRFLIP", "HDRFLIP", "PSNR", "ln ratio", *MODELS, "CPU ms/sun change", "Targets:"):
            self.assertIn(part, first.stdout)
        kept = list((self.folder / "kept").iterdir())
        self.assertEqual(len(kept), 1)
        self.assertTrue(kept[0].read_bytes().startswith(MAGIC["exr"]))
        report = json.loads((self.folder / "report/report.json").read_text())
        self.check_report(report)
        self.check_page((self.folder / "report/index.html").read_text())

        second = self.truth("--models", MODELS[0], "-o", "again", "--references", "kept", "--cost-frames", "0")
        self.assert_done(second)
        self.assertNotIn(TRACED, second.stderr)
        again = json.loads((self.folder / "again/report.json").read_text())["views"][0]
        self.assertIsNone(again["models"][0]["cost"])
        for figure in ("clouds", "ldr_flip", "hdr_flip", "psnr_db"):
            self.assertEqual(again["models"][0][figure], report["views"][0]["models"][0][figure])

        third = self.truth("--models", MODELS[0], "--references", "kept", "--samples", "3", "--cost-frames", "0")
        self.assert_done(third)
        self.assertIn(TRACED, third.stderr)

    def check_report(self, report):
        self.assertEqual(report["benchmark"], "truth")
        self.assertEqual(report["size_px"], [32, 18])
        self.assertEqual(report["reference_samples"], 2)
        self.assertEqual([model["model"] for model in report["summary"]], MODELS)
        self.assertEqual([len(model["targets"]) for model in report["summary"]], [4, 4])
        view, = report["views"]
        self.assertGreater(view["cloud_share"], 0.2)
        self.assertGreater(view["reference_noise"], 0)
        for model in view["models"]:
            self.assertEqual(model["whole"]["pixels"], 32 * 18)
            self.assertLess(model["clouds"]["pixels"], 32 * 18)
            self.assertGreater(model["clouds"]["relative_error_mean"], 0)
            for flip in ("ldr_flip", "hdr_flip"):
                self.assertTrue(0 < model[flip] < 1)
            self.assertTrue(0 < model["psnr_db"] < 100)
            self.assertGreater(model["cost"]["frame_cpu_ms"], 0)

    def check_page(self, page):
        sources = Sources(page).found
        self.assertEqual(len(sources), 6, "a picture and a map of the reference and of each model")
        for source in sources:
            self.assertTrue((self.folder / "report" / source).read_bytes().startswith(MAGIC["png"]), source)

    def test_refuses_what_it_does_not_know(self):
        self.assert_one_sentence(self.truth("--models", "beer-octave"), 2, "--models", "beer-octave", "beer-octaves")
        self.assert_one_sentence(self.run_program("bench", "truth", "--views", "noom"), 2, "--views", "noom", "noon")
        self.assert_one_sentence(self.run_program("bench", "truth", "--size", "32"), 2, "--size", "WIDTHxHEIGHT")
        for option, value in (("--samples", "1"), ("--quality", "reference"), ("--cost-frames", "-1")):
            result = self.run_program("bench", "truth", option, value)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn(option, result.stderr)

    def test_refuses_a_folder_that_is_a_file_before_it_renders(self):
        blocked = self.write("blocked", "")
        self.assert_one_sentence(self.truth("-o", blocked), 2, "--output", blocked)
        self.assert_one_sentence(self.truth("--references", blocked), 2, "--references", blocked)


del Cli  # or its tests would run here too

if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
