"""Builds the image, runs it read-only, without capabilities and as its own user, and asks it for a still and a stream frame."""
import json
import secrets
import socket
import statistics
import sys
import time
import unittest
import urllib.error
import urllib.request

import engine
import png_pixels
import stream_client

IMAGE = "cloudscape-test"
SKIPPED = 77  # the exit code that CTest is told to read as "skipped"
SIZE_PX = [160, 90]


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class RunningImage:
    """One container of the image, ready to answer; `remove` it."""

    def __init__(self, containers):
        self.containers, self.port, self.token = containers, free_port(), secrets.token_urlsafe(24)
        self.name = f"cloudscape-test-{self.port}"
        started = time.monotonic()
        containers.run("run", "--detach", "--name", self.name, "--network", "host", "--read-only", "--tmpfs", "/tmp",
                       "--cap-drop", "all", "--security-opt", "no-new-privileges",
                       "--env", f"CLOUDSCAPE_LISTEN=127.0.0.1:{self.port}", "--env", f"CLOUDSCAPE_TOKEN={self.token}",
                       IMAGE)
        self.wait_until_ready(timeout_s=60)
        self.seconds_to_ready = time.monotonic() - started

    def get(self, path, timeout_s=120):
        request = urllib.request.Request(f"http://127.0.0.1:{self.port}{path}",
                                         headers={"Authorization": f"Bearer {self.token}"})
        with urllib.request.urlopen(request, timeout=timeout_s) as answer:
            return answer.read()

    def wait_until_ready(self, timeout_s):
        deadline = time.monotonic() + timeout_s
        while time.monotonic() < deadline:
            try:
                self.get("/readyz", timeout_s=5)
                return
            except (OSError, urllib.error.URLError):
                time.sleep(0.2)
        log = self.containers.run("logs", self.name, check=False).stdout
        self.remove()
        raise RuntimeError(f"/readyz did not answer 200 within {timeout_s} s; the container wrote:\n{log}")

    def execute(self, *command, check=True):
        return self.containers.run("exec", self.name, *command, check=check)

    def remove(self):
        self.containers.run("rm", "--force", self.name, check=False)


def build_image(containers, tag, *options):
    """Builds it, and removes the image that had the tag before."""
    before = containers.run("images", "--quiet", tag, check=False).stdout.split()
    containers.run("build", "--network", "host", "--file", "docker/Dockerfile", "--tag", tag, *options, ".", timeout_s=2400)
    for old in set(before) - set(containers.output("images", "--quiet", tag).split()):
        containers.run("rmi", old, check=False)


class ImageTest(unittest.TestCase):
    containers = None
    running = None

    @classmethod
    def setUpClass(cls):
        cls.containers.provide_base_image()
        build_image(cls.containers, IMAGE + "-build", "--target", "build")  # named, so that it can be removed when it is old
        build_image(cls.containers, IMAGE)
        cls.running = RunningImage(cls.containers)
        print(f"the container was ready after {cls.running.seconds_to_ready:.1f} s", flush=True)

    @classmethod
    def tearDownClass(cls):
        if cls.running:
            cls.running.remove()

    def test_1_runs_confined(self):
        status = dict(line.split(":", 1) for line in self.running.execute("cat", "/proc/1/status").stdout.splitlines())
        self.assertEqual(set(status["Uid"].split()), {"65532"})
        self.assertEqual(int(status["CapEff"], 16) | int(status["CapPrm"], 16) | int(status["CapBnd"], 16), 0)
        self.assertEqual(status["NoNewPrivs"].strip(), "1")
        self.assertNotEqual(self.running.execute("touch", "/usr/local/written", check=False).returncode, 0)

    def test_2_health_check_passes(self):
        self.running.execute("cloudscape", "healthcheck")

    def test_3_a_token_is_needed(self):
        with self.assertRaises(urllib.error.HTTPError) as refused:
            urllib.request.urlopen(f"http://127.0.0.1:{self.running.port}/api/v1/cloudscapes", timeout=10)
        self.assertEqual(refused.exception.code, 401)

    def still(self, image_format):
        width, height = SIZE_PX
        return self.running.get(f"/api/v1/stills?cloudscape={self.cloudscape()}&width={width}&height={height}"
                                f"&quality=draft&format={image_format}")

    def cloudscape(self):
        answer = json.loads(self.running.get("/api/v1/cloudscapes"))
        entries = answer["cloudscapes"] if isinstance(answer, dict) else answer
        return entries[0]["name"]

    def test_4_renders_a_still(self):
        width, height, rows = png_pixels.read_png(self.still("png"))
        self.assertEqual([width, height], SIZE_PX)
        brightness = [sum(pixel) / 3 for row in rows for pixel in row]
        self.assertGreater(statistics.pstdev(brightness), 4, "the still is all of one brightness")
        self.assertGreater(len({pixel for row in rows for pixel in row}), 200, "the still has hardly any colours")

    def test_5_encodes_jpeg(self):
        image = self.still("jpeg")
        self.assertEqual((image[:3], image[-2:]), (b"\xff\xd8\xff", b"\xff\xd9"))

    def test_6_streams_a_frame(self):
        width, height, image = stream_client.first_frame(self.running.port, self.running.token, self.cloudscape(), SIZE_PX)
        self.assertEqual([width, height], SIZE_PX)
        self.assertEqual(image[:3], b"\xff\xd8\xff")

    def test_7_stops_on_sigterm(self):
        started = time.monotonic()
        self.containers.run("stop", "--time", "20", self.running.name)
        self.assertLess(time.monotonic() - started, 12, "10 s to drain, and what the engine itself takes")
        code = self.containers.output("inspect", "--format", "{{.State.ExitCode}}", self.running.name)
        self.assertEqual(code, "0", self.containers.run("logs", self.running.name, check=False).stdout)


if __name__ == "__main__":
    ImageTest.containers = engine.find_engine()
    if ImageTest.containers is None:
        print("skipped: neither docker nor podman works here, and CLOUDSCAPE_CONTAINERS names no other engine")
        sys.exit(SKIPPED)
    unittest.main(verbosity=2)
