"""A container engine as this machine has one: docker, podman, or the command that CLOUDSCAPE_CONTAINERS names."""
import os
import pathlib
import shlex
import shutil
import subprocess

BASE_IMAGE = "docker.io/library/debian:bookworm-slim"


class Engine:
    def __init__(self, command):
        self.command = command

    def run(self, *arguments, check=True, timeout_s=120):
        """Runs it; returns the finished process, with its output as text. Raises with the output where `check` fails."""
        done = subprocess.run([*self.command, *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=timeout_s)
        if check and done.returncode != 0:
            raise RuntimeError(f"{shlex.join([*self.command, *arguments])} ended with {done.returncode}:\n"
                               + done.stdout[-4000:])
        return done

    def output(self, *arguments, **options):
        return self.run(*arguments, **options).stdout.strip()

    def provide_base_image(self):
        """A wrapper called `containers` makes the base image itself, where no registry can be reached."""
        program = self.command[0]
        if pathlib.Path(program).name == "containers":
            Engine([program]).run("base", timeout_s=1200)


def works(command):
    """Whether the engine answers; docker's client alone, without its daemon, does not."""
    try:
        return subprocess.run([*command, "info"], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, timeout=60).returncode == 0
    except (OSError, subprocess.TimeoutExpired):
        return False


def find_engine():
    """The engine, or None where none works. A command that the environment names must work."""
    named = os.environ.get("CLOUDSCAPE_CONTAINERS")
    if named:
        return Engine(shlex.split(named))
    for program in ("docker", "podman"):
        if shutil.which(program) and works([program]):
            return Engine([program])
    return None
