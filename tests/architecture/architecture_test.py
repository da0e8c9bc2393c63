"""Checks a source tree: architecture_test.py ROOT CHECK. Prints `file:line: why` for each violation, and fails if there is one."""
import importlib
import pathlib
import sys


def main():
    root, name = pathlib.Path(sys.argv[1]), sys.argv[2]
    check = importlib.import_module(name)
    violations = sorted(set(check.check(root)))
    print("\n".join(violations))
    if hasattr(check, "summary"):
        print(check.summary(root))
    print(f"{name}: {len(violations)} violations")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
