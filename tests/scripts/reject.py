#!/usr/bin/env python3
"""Compiles a file of tests/rejects twice: it must be accepted, and with CCA_REJECT=1 refused for the stated reason.

usage: reject.py FILE [--headers FOLDER] -- COMPILER [FLAGS...]
       reject.py --prepare FOLDER -- COMPILER [FLAGS...]

The file's first line is `// EXPECT: <regex>`; its name is the rule's id, or `<id>-<variant>`. Or it holds many mistakes:
its first lines are `// EXPECT <name>: <regex>`, and it is compiled once without and once with each CCA_REJECT=<name>.
A line `// FLAGS: ...` after the first holds flags for the mistake only; a line `// ERRORS: n` allows n errors, any of
which may match: where the mistake is in the language, the compiler goes on with errors of its own.
What the user sees of a refusal must be good to read: one error, whose sentence names the rule and matches the regex, and
at most 40 lines in all, or as many as a line `// LINES: n` allows. --prepare precompiles the headers that most files include, which saves three quarters of the time.
"""
import pathlib
import re
import subprocess
import sys

MOST_LINES = 40
COLUMN = 35  # letters of a line{"..."}, as clang shows them
HEADER = "cca/cca.hpp"


def run(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


def as_users_have_it(command):
    """Installed libraries as system headers, whose warnings nobody sees."""
    return [re.sub("^-I(?=/usr/.)", "-isystem", flag) for flag in command if flag != "-I/usr/include"]


def is_clang(command):
    return "clang" in pathlib.Path(command[0]).name


def prepare(folder, command):
    """Precompiles the headers; where that fails, files are compiled without."""
    (folder / "cca").mkdir(parents=True, exist_ok=True)
    source = folder / "all.hpp"
    source.write_text(f"#include <{HEADER}>\n")
    target = folder / ("all.pch" if is_clang(command) else f"{HEADER}.gch")
    if is_clang(command):
        return run([*command, "-x", "c++-header", str(source), "-o", str(target)])
    header = next((where for where in (pathlib.Path(flag[2:]) / HEADER for flag in command if flag.startswith("-I")) if where.exists()), source)
    # g++ reads this one where it finds the precompiled one beside it unfit.
    (folder / HEADER).write_text(f'#include "{header}"\n')
    return run([*command, "-w", "-x", "c++-header", str(header), "-o", str(target)])


def prepared(folder, command):
    if folder is None:
        return command
    if is_clang(command):
        return [*command, "-include-pch", str(folder / "all.pch")]
    # Only what the command line includes, or the file itself first of all, may come precompiled.
    return [command[0], f"-I{folder}", *command[1:], "-include", HEADER]


def prepared_for(file, folder, command):
    """A file of many mistakes is compiled for each: what it includes of the libraries is precompiled, for it alone."""
    includes = re.findall(r"^#include <.*>$", file.read_text(), re.M)
    if folder is None or not includes:
        return prepared(folder, command)
    own = folder / file.stem
    own.mkdir(parents=True, exist_ok=True)
    source = own / "own.hpp"
    source.write_text("\n".join(["#pragma once", *includes]) + "\n")
    target = own / ("own.pch" if is_clang(command) else "own.hpp.gch")
    if run([*command, "-w", "-x", "c++-header", str(source), "-o", str(target)])[0] != 0:
        return command  # what is wrong shows when the file is compiled
    return [*command, *(["-include-pch", str(target)] if is_clang(command) else ["-include", str(source)])]


def compile_file(command, file, *defines):
    return run([*command, "-fsyntax-only", "-fdiagnostics-color=never", *defines, str(file)])


def errors(output):
    return [line for line in output.splitlines() if re.search(r"\berror: ", line)]


def sentence(error):
    """What the first error says: a static assertion's text, or the text in a type, which clang shows in short columns."""
    assertion = re.search(r"static assertion failed[^:]*(?:requirement '.*?'[^:]*)?: (.*)", error)
    if assertion:
        return assertion[1].strip('"')
    said = ""
    error = re.sub(r".*?\brefused_\w+<", "", error, count=1)  # what stands before may have texts of its own
    for column in re.findall(r'"((?:[^"\\]|\\.)*)"', error):
        word_is_cut = len(column) == COLUMN and " " not in column
        said += column.rstrip() + ("" if word_is_cut else " ")
    return said.strip() or re.sub(r".*?\berror: ", "", error)


def note(text, name):
    """The text of the line `// <name>: text`."""
    line = re.search(rf"^// {name}: (.*)$", text, re.M)
    return line[1] if line else ""


def refusal_is_wrong(output, expect, allowed=1, most_lines=MOST_LINES):
    found = errors(output)
    if not any(re.search(expect, sentence(error)) for error in found[:allowed]):
        said = f"; it says: {sentence(found[0])}" if found else ""
        return (f"the first error does not match: {expect}" if allowed == 1 else f"no error matches: {expect}") + said
    if len(found) > allowed:
        return f"{len(found)} errors, and {'one' if allowed == 1 else allowed} would do"
    # The precompiled header, which no user has, adds a line.
    length = sum("/rejects/headers/" not in line for line in output.splitlines())
    return f"{length} lines of output, more than {most_lines}" if length > most_lines else ""


def verdict(file, command):
    """What is wrong, or the empty string; and the output of the compiler that shows it."""
    flags, allowed = note(file.read_text(), "FLAGS").split(), int(note(file.read_text(), "ERRORS") or 1)
    most_lines = int(note(file.read_text(), "LINES") or MOST_LINES)
    expected = re.findall(r"^// EXPECT(?: (\w+))?: (\S.*)$", file.read_text(), re.M)
    if not expected or not file.read_text().startswith("// EXPECT"):
        return "the first line is not `// EXPECT: <regex>`", ""
    for name, regex in expected:
        rule = file.stem.split("-")[0]
        if not name and rule not in regex.replace("\\", ""):
            return f"the expected text does not contain the rule's id, {rule}", ""

    code, output = compile_file(command, file)
    if code != 0:
        return "it does not compile without the mistake", output
    outputs = ""
    for name, regex in expected:
        code, output = compile_file(command, file, f"-DCCA_REJECT={name or 1}", *flags)
        outputs += output
        wrong = refusal_is_wrong(output, regex, allowed, most_lines) if code != 0 else "the compiler accepts the mistake"
        if wrong:
            return f"{name}: {wrong}" if name else wrong, output
    return "", outputs


def main(arguments):
    if "--" not in arguments:
        sys.exit(__doc__)
    split = arguments.index("--")
    options, command = arguments[:split], as_users_have_it(arguments[split + 1:])
    if len(options) == 2 and options[0] == "--prepare":
        code, output = prepare(pathlib.Path(options[1]), command)
        print(output)
        sys.exit(code)
    if len(options) not in (1, 3) or (len(options) == 3 and options[1] != "--headers"):
        sys.exit(__doc__)
    file = pathlib.Path(options[0])
    # What is compiled with other flags can't use the precompiled headers.
    use_prepared = len(options) == 3 and not note(file.read_text(), "FLAGS")
    has_many = re.search(r"^// EXPECT \w+:", file.read_text(), re.M)
    folder = pathlib.Path(options[2]) if use_prepared else None
    wrong, output = verdict(file, prepared_for(file, folder, command) if has_many else prepared(folder, command))
    print(output)
    if wrong:
        sys.exit(f"{file}: {wrong}")
    print(f"{file}: refused as expected")


if __name__ == "__main__":
    main(sys.argv[1:])
