#!/usr/bin/env python3
"""Checks that one thing has one name, in comments and pages.

usage: words.py [--write] [ROOT of the repository]

WORDS says what is written instead of what; --write writes it: read the sentence then, and run format.py. What is no prose, such as a name in code or a path, is not looked at: a phrase
counts where its words are separated by spaces, or by the break of a line of comment.
"""
import pathlib
import re
import sys

from format import files_of

GAP = r"(?:[ \t]+|[ \t]*\n[ \t]*(?://|#)?[ \t]*)"
WORDS = {  # a regex, word by word: what to write
    r"at wall-clock speed": "in a wall-clock run",
    r"(?<!\w)as fast as possible": "in a fast run",
    r"on a clock(?! of| that)": "in a wall-clock run",
}
# Where a word is defined, or means something else.
ALLOWED = [
    ("docs/programs.md", "a fast run, which is as fast as possible"),
    ("record/include/cca/record/file/recording_file.hpp", "# from which on they ran at wall-clock speed"),  # in the files
]
SKIPPED = ("CHANGELOG.md", "page/", "tests/scripts/", "tests/record/")  # the page's programs are bundled into a file


def pattern_of(words):
    return re.compile(words.replace(" ", GAP), re.I)


def written(found, instead):
    """The words instead of what was found: with its capital letter, and with its break of a line before the last word."""
    gap = re.search(r"[ \t]*\n[ \t]*(?://|#)?[ \t]*", found[0])
    first, _, last = instead.rpartition(" ")
    text = first + (gap[0] if gap else " ") + last
    return text[0].upper() + text[1:] if found[0][0].isupper() else text


def problems(root, write=False):
    patterns = [(pattern_of(words), instead) for words, instead in WORDS.items()]
    for name in files_of(root, ".hpp", ".cpp", ".md", ".py", ".txt", ".cmake"):
        if name.as_posix().startswith(SKIPPED):
            continue
        text = whole = (root / name).read_text()
        for file, phrase in ALLOWED:
            if name.as_posix() == file:
                text = text.replace(phrase, " " * len(phrase))
        if write and not any(name.as_posix() == file for file, _ in ALLOWED):
            for pattern, instead in patterns:
                whole = pattern.sub(lambda found: written(found, instead), whole)
            if whole != text:
                (root / name).write_text(whole)
                text = whole
        for pattern, instead in patterns:
            for found in pattern.finditer(text):
                phrase = " ".join(re.sub(r"\n[ \t]*(?://|#)?", " ", found[0]).split())
                yield f"{name}:{text.count(chr(10), 0, found.start()) + 1}: `{phrase}`: write `{instead}`"


def main(arguments):
    rest = [argument for argument in arguments if argument != "--write"]
    root = pathlib.Path(rest[0]).resolve() if rest else pathlib.Path(__file__).resolve().parents[2]
    found = list(problems(root, len(rest) < len(arguments)))
    print("\n".join(found) or "each thing has one name")
    sys.exit("words: tests/scripts/words.py --write writes the right ones" if found else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
