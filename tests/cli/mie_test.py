"""The command `cloudscape mie` as a process: its table, its plot, and what it refuses.

Usage: mie_test.py <cloudscape> [unittest options]. Exit codes: 0 done, 1 failed, 2 wrong usage.
"""
import csv
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

PROGRAM = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "cloudscape").resolve()
SMALL = ["--effective-radius-um", "2"]


def run(*arguments, folder=None):
    return subprocess.run([PROGRAM, "mie", *arguments], cwd=folder, timeout=300, text=True, capture_output=True)


def rows_of(text):
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(lines)]


def headers_of(text):
    found = {}
    for line in text.splitlines():
        match = re.match(r"# (red|green|blue): (.*)", line)
        if match:
            found[match[1]] = {name: float(value) for name, value in re.findall(r"(\w+)=(\S+)", match[2])}
    return found


class Table(unittest.TestCase):
    def test_has_the_angles_that_were_asked_for_and_integrates_to_one(self):
        result = run(*SMALL, "--angles", "7201")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        rows = rows_of(result.stdout)
        self.assertEqual(len(rows), 7201)
        self.assertEqual((rows[0]["angle_deg"], rows[-1]["angle_deg"]), (0, 180))
        for row in rows[::100]:
            self.assertAlmostEqual(row["cos_theta"], math.cos(math.radians(row["angle_deg"])), 8)
        headers = headers_of(result.stdout)
        for colour, wavelength_um in (("red", 0.65), ("green", 0.55), ("blue", 0.45)):
            energy = cosine = 0
            for low, high in zip(rows, rows[1:]):
                weight = 2 * math.pi * (low["cos_theta"] - high["cos_theta"]) * (low[colour] + high[colour]) / 2
                energy += weight
                cosine += weight * (low["cos_theta"] + high["cos_theta"]) / 2
            self.assertAlmostEqual(energy, 1, 3)
            self.assertAlmostEqual(cosine, headers[colour]["asymmetry_g"], 3)
            self.assertEqual(headers[colour]["wavelength_um"], wavelength_um)
            self.assertTrue(1.8 < headers[colour]["extinction_efficiency"] < 2.6)
            self.assertTrue(0.9999 < headers[colour]["single_scattering_albedo"] < 1)

    def test_goes_into_a_file_and_is_the_same_each_time(self):
        with tempfile.TemporaryDirectory() as folder:
            result = run(*SMALL, "-o", "table.csv", "--plot", "plot.svg", folder=folder)
            self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
            self.assertEqual((pathlib.Path(folder) / "table.csv").read_text(), run(*SMALL).stdout)
            plot = (pathlib.Path(folder) / "plot.svg").read_text()
            self.assertTrue(xml.etree.ElementTree.fromstring(plot).tag.endswith("svg"))
            for wavelength in ("450 nm", "550 nm", "650 nm"):
                self.assertIn(wavelength, plot)

    def test_the_sun_blurs_the_forward_peak(self):
        sharp, blurred = (rows_of(run("--effective-radius-um", "10", "--sun-radius-deg", radius, "--angles", "181").stdout)
                          for radius in ("0", "1"))
        self.assertLess(blurred[0]["green"], 0.8 * sharp[0]["green"])
        self.assertAlmostEqual(blurred[90]["green"] / sharp[90]["green"], 1, 1)


class Refuses(unittest.TestCase):
    def assert_one_sentence(self, result, code, *parts):
        self.assertEqual((result.returncode, result.stdout), (code, ""), result.stderr)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        for part in ("cloudscape: ", *parts):
            self.assertIn(part, result.stderr)

    def test_droplets_and_angles_out_of_range(self):
        for option, values, limits in (("--effective-radius-um", ("0", "51", "nan"), "[1, 50]"),
                                       ("--effective-variance", ("0.001", "0.6"), "[0.01, 0.5]"),
                                       ("--sun-radius-deg", ("-1", "11"), "[0, 10]"), ("--angles", ("1", "-5"), "[2, ")):
            for value in values:
                self.assert_one_sentence(run(f"{option}={value}"), 2, option, value, limits)

    def test_a_folder_that_is_not_there(self):
        self.assert_one_sentence(run(*SMALL, "-o", "nowhere/table.csv"), 1, "nowhere")

    def test_words_for_numbers(self):
        result = run("--effective-radius-um", "ten")
        self.assertEqual(result.returncode, 2)
        self.assertIn("ten", result.stderr)


class Help(unittest.TestCase):
    def test_names_units_and_defaults(self):
        text = run("--help").stdout
        for part in ("--effective-radius-um", "=10 ", "um,", "=0.1 ", "=1801 ", "degrees", "650, 550 and 450 nm"):
            self.assertIn(part, text)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
