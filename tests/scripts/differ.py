#!/usr/bin/env python3
"""Whether an option changes what a program finds.

    differ.py PATTERN OPTION -- PROGRAM WORDS...

Runs the program without the option and with it. Both must end with 0 and print what the pattern, a regular expression, finds;
what its group has must differ.
"""
import re
import subprocess
import sys


def found(pattern, words):
    run = subprocess.run(words, capture_output=True, text=True, timeout=300)
    match = re.search(pattern, run.stdout)
    if run.returncode != 0:
        sys.exit(f"differ: {' '.join(words)}: ended with {run.returncode}\n{run.stderr}")
    if not match:
        sys.exit(f"differ: {' '.join(words)}: no \"{pattern}\" in\n{run.stdout}")
    return match.group(1)


def main(words):
    if len(words) < 4 or "--" not in words[2:]:
        sys.exit(__doc__)
    end = words.index("--")
    pattern, option, program = words[0], words[1:end], words[end + 1:]
    without, with_it = found(pattern, program), found(pattern, program + option)
    print(f"{without} without {' '.join(option)}, {with_it} with it")
    if without == with_it:
        sys.exit("differ: the same")


if __name__ == "__main__":
    main(sys.argv[1:])
