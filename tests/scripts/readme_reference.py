"""The README's reference of the document is what `cloudscape reference` prints: readme_reference.py PROGRAM README [--write]"""
import pathlib
import subprocess
import sys

BEGIN, END = "<!-- reference: begin -->\n", "<!-- reference: end -->\n"


def main():
    program, readme = sys.argv[1], pathlib.Path(sys.argv[2])
    printed = subprocess.run([program, "reference"], capture_output=True, text=True, check=True).stdout.strip() + "\n"
    before, rest = readme.read_text().split(BEGIN)
    told, after = rest.split(END)
    if told == printed:
        return 0
    if "--write" in sys.argv:
        readme.write_text(before + BEGIN + printed + END + after)
        return 0
    line = next((n for n, pair in enumerate(zip(told.splitlines(), printed.splitlines())) if pair[0] != pair[1]), 0)
    print(f"{readme.name}:{before.count(chr(10)) + 2 + line}: the document's reference is not what the program prints; "
          f"refresh it with: python3 {sys.argv[0]} {program} {readme} --write")
    return 1


if __name__ == "__main__":
    sys.exit(main())
