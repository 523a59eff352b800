#!/usr/bin/env python3
"""Compiles a file of tests/rejects twice: it must be accepted, and with CCA_REJECT=1 refused for the stated reason.

usage: reject.py FILE -- COMPILER [FLAGS...]

The file's first line is `// EXPECT: <regex>`; its name is the rule's id, or `<id>-<variant>`. What the user sees of the
refusal must be good to read: the first error names the rule and matches the regex, and all of it is at most 40 lines.
"""
import pathlib
import re
import subprocess
import sys

MOST_LINES = 40


def compile_file(command, file, *defines):
    done = subprocess.run([*command, "-fsyntax-only", "-fdiagnostics-color=never", *defines, str(file)],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


def first_error(output):
    """From the first error to the second: the error itself, with its notes."""
    lines = output.splitlines()
    errors = [i for i, line in enumerate(lines) if re.search(r"\berror: ", line)]
    if not errors:
        return ""
    return "\n".join(lines[errors[0]:errors[1] if len(errors) > 1 else None])


def readings(text):
    """The text, and its string literals as one: clang prints a sentence as a pack of short padded columns."""
    literals = re.findall(r'"((?:[^"\\]|\\.)*)"', text)
    return [text] + [re.sub(r" +", " ", between.join(literals)) for between in (" ", "")]


def verdict(file, command):
    """What is wrong, or the empty string; and the output of the compiler that shows it."""
    expect = re.match(r"// EXPECT: (\S.*)\n", file.read_text())
    if not expect:
        return "the first line is not `// EXPECT: <regex>`", ""
    rule = file.stem.split("-")[0]
    if rule not in expect[1].replace("\\", ""):
        return f"the expected text does not contain the rule's id, {rule}", ""

    code, output = compile_file(command, file)
    if code != 0:
        return "it does not compile without the mistake", output
    code, output = compile_file(command, file, "-DCCA_REJECT=1")
    if code == 0:
        return "the compiler accepts the mistake", output
    error = first_error(output)
    if not any(re.search(expect[1], reading) for reading in readings(error)):
        return f"the first error does not match: {expect[1]}", output
    length = len(output.splitlines())
    if length > MOST_LINES:
        return f"{length} lines of output, more than {MOST_LINES}", output
    return "", output


def main(arguments):
    if len(arguments) < 3 or arguments[1] != "--":
        sys.exit(__doc__)
    file, command = pathlib.Path(arguments[0]), arguments[2:]
    wrong, output = verdict(file, command)
    print(output)
    if wrong:
        sys.exit(f"{file}: {wrong}")


if __name__ == "__main__":
    main(sys.argv[1:])
