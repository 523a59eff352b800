#!/usr/bin/env python3
"""Makes docs/troubleshooting.md from the files of tests/rejects.

usage: make_troubleshooting.py ROOT            writes the page; compiles what on it is not as the files have it
       make_troubleshooting.py ROOT --all      compiles all of them, for a change to what the compilers say (some minutes)
       make_troubleshooting.py ROOT --check    compiles nothing: rules, code and texts are those of the files

Each rule has a section: its meaning (the comment at the top of its file), the code in `#if CCA_REJECT` and in its `#else`,
and what each compiler says. Files of a variant, `<id>-<variant>.cpp`, follow as shorter sections.
"""
import pathlib
import re
import subprocess
import sys
import textwrap

import markdown
import reject
import rules

COMPILERS = ["g++", "clang++-19"]
WIDTH = 118
HEAD = """# Troubleshooting

<!-- Made by tests/scripts/make_troubleshooting.py from tests/rejects; to change it, change those. -->

What the compiler says when an architecture breaks a rule, why, and what to do. Look for the rule's id, the word with a dot
that the message begins with.

- One rule is reported at a time, the first in the order of this page; when it is mended the next may appear.
- g++ shows the message as one line, in the type that it could not complete. clang shows the same text in pieces of 35
  letters, `line{"..."}`, to be read on from one to the next.
- `static_assert(cca::check<trot>());` gives the message without a controller, where it stands.
  The same text can be had as a value: print `cca::diagnosis<trot>.message`.

The examples are made of these parts ([parts.hpp](../tests/rejects/parts.hpp)):

"""


class Reject:
    def __init__(self, file):
        self.file, self.text = file, file.read_text()
        self.rule, _, self.variant = file.stem.partition("-")
        self.expect = re.match(r"// EXPECT: (.*)\n", self.text)[1]
        self.flags, self.allowed = reject.note(self.text, "FLAGS").split(), int(reject.note(self.text, "ERRORS") or 1)
        comments = re.sub(r"^// (?:FLAGS|ERRORS|LINES): .*\n", "", self.text, flags=re.M)
        self.meaning = " ".join(re.match(r"// EXPECT.*\n((?://.*\n)*)", comments)[1].replace("//", "").split())
        parts = re.findall(r"^#if CCA_REJECT\n(.*?)(?:^#else\n(.*?))?^#endif", self.text, re.M | re.S)
        self.broken, self.fixed = ("\n...\n".join(textwrap.dedent(p[i]).rstrip() for p in parts) for i in (0, 1))


def order(root):
    """The rules of graphs in the order of their list; then the others."""
    listed = rules.rules_of_graphs(root)
    tested = {file.stem.split("-")[0] for file in (root / "tests/rejects").glob("*.cpp")}
    return [rule for rule in listed if rule in tested] + sorted(tested - set(listed))


def trimmed(output, file, error):
    """The error and where it comes from, with file names only."""
    lines = output.splitlines()
    told = [error]
    for line in lines:
        if re.search(re.escape(file.name) + r":\d+:\d+:.*(required from here|in instantiation of)", line):
            told.append(line)
            break
    short = [re.sub(r"\S*/(?=[\w.+-]+\.[hc]pp:\d)", "", line) for line in told]
    short[0] = re.sub(r"^([\w.+-]+\.hpp):\d+:\d+:", r"\1:", short[0])
    return "\n".join(wrapped(piece, "    ") for line in short for piece in re.sub(r'(?<=[<}])(,?) ?(?=line\{")', r"\1\n    ", line).split("\n"))


def wrapped(text, indent=""):
    """Columns of clang stay as they are."""
    if text.startswith("    line{"):
        return text
    return textwrap.fill(text, WIDTH, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def compiled(files, root, compilers):
    """(file name, compiler) -> what it says."""
    said = {}
    libraries = subprocess.run(["pkg-config", "--cflags", "eigen3", "ompi"], stdout=subprocess.PIPE, text=True, check=True).stdout.split()
    for compiler in compilers:
        for file in files:
            one = Reject(file)
            _, output = reject.compile_file([compiler, "-std=c++20", f"-I{root}/include", f"-I{root}/robots/include", f"-I{root}/hardware/include", f"-I{root}/sim/include", f"-I{root}/record/include", f"-I{root}/mpi/include", *libraries], file, "-DCCA_REJECT=1", *one.flags)
            first = next((error for error in reject.errors(output)[:one.allowed] if re.search(one.expect, reject.sentence(error))), "")
            if not first:
                sys.exit(f"{file} on {compiler}: unexpected output\n{output}")
            said[file.name, compiler] = (trimmed(output, file, first), reject.sentence(first).replace("\\'", "'"))
    return said


def from_page(page):
    """The same, as the page has it."""
    said = {}
    for name, section in re.findall(r"^<!-- (\S+\.cpp) -->\n(.*?)(?=^<!-- \S+\.cpp -->|\Z)", page, re.M | re.S):
        full = re.search(r"^Message:\n\n```text\n(.*?)\n```", section, re.M | re.S)
        sentence = full[1].replace("\n", " ") if full else ""
        for compiler in COMPILERS:
            block = re.search(rf"^`{re.escape(compiler)}`:\n\n```text\n(.*?)\n```", section, re.M | re.S)
            said[name, compiler] = (block[1] if block else "", sentence)
    return said


def fenced(code, language="cpp"):
    return f"```{language}\n{code}\n```\n\n"


def section(one, said):
    text = f"<!-- {one.file.name} -->\n"
    text += f"{one.meaning}\n\n" if not one.variant else f"**{one.meaning}**\n\n"
    text += "Broken:\n\n" + fenced(one.broken) + ("Fixed:\n\n" + fenced(one.fixed) if one.fixed else "")
    sentence = said[one.file.name, COMPILERS[0]][1]
    text += "Message:\n\n" + fenced(wrapped(sentence), "text")
    if not one.variant:
        for compiler in COMPILERS:
            text += f"`{compiler}`:\n\n" + fenced(said[one.file.name, compiler][0], "text")
    return text + f"The whole file: [{one.file.name}](../tests/rejects/{one.file.name})\n\n"


def make(root, files, said):
    parts = (root / "tests/rejects/parts.hpp").read_text()
    text = HEAD + fenced(parts[parts.index("struct"):].rstrip()) + "## Rules\n\n"
    known = [Reject(file) for file in files]
    for rule in order(root):
        text += f"- [{rule}](#{rule.replace('.', '')})\n"
    for rule in order(root):
        text += f"\n## {rule}\n\n"
        for one in sorted((r for r in known if r.rule == rule), key=lambda r: r.variant):
            text += section(one, said)
    return markdown.rewritten(re.sub(r"\n{3,}", "\n\n", text).rstrip() + "\n")[0]


def is_stale(file, page, said):
    one = Reject(file)
    if (file.name, COMPILERS[0]) not in said or not re.search(one.expect, said[file.name, COMPILERS[0]][1]):
        return True
    return markdown.rewritten(section(one, said))[0].strip() not in page


def main(arguments):
    root = pathlib.Path(arguments[0]).resolve() if arguments else pathlib.Path(__file__).resolve().parents[2]
    page = root / "docs/troubleshooting.md"
    files = sorted((root / "tests/rejects").glob("*.cpp"))
    old = page.read_text() if page.exists() else ""
    said = from_page(old)
    stale = [file for file in files if is_stale(file, old, said)]
    if "--check" not in arguments:
        said |= compiled(files if "--all" in arguments else stale, root, COMPILERS)
        page.parent.mkdir(exist_ok=True)
        page.write_text(make(root, files, said))
        return
    if stale or make(root, files, said) != old:
        sys.exit(f"{page} is not what the files say: make it anew with {pathlib.Path(__file__).name}\n" + "\n".join(file.name for file in stale))
    print(f"{page.name} has {len(files)} examples, as the files have them")


if __name__ == "__main__":
    main(sys.argv[1:])
