#!/usr/bin/env python3
"""Checks that Markdown has one sentence per line: no line holds two sentences, no sentence goes over two lines.

usage: markdown.py [--write] [ROOT of the repository | PAGE.md ...]

Checked are paragraphs, list items and quotes; not headings, tables, code, formulas, HTML and link definitions. A bold
phrase that begins a line ("**Faults.** A component ...") is a heading in the line, not a sentence. What stands in brackets
or quotation marks belongs to the sentence around it. --write rewrites the pages.
"""
import pathlib
import re
import sys

from format import files_of

ABBREVIATIONS = set("""e.g i.e etc vs cf fig figs eq eqs sec sect ch chap no nos p pp vol al approx resp ca incl excl min max
                       dr mr mrs st ed eds inc ltd dept jan feb mar apr jun jul aug sep sept oct nov dec""".split())
CLOSERS = "\"'”’)]*_`"
OPENERS = "\"'“‘([*_`"
FENCE = re.compile(r"\s*(```+|~~~+)")
ITEM = re.compile(r"(\s*(?:[-*+]|\d{1,3}[.)])\s+)(?=\S)")
QUOTE = re.compile(r"\s*>\s?")
OTHER = re.compile(r"\s*(?:\||#{1,6}\s|<[a-zA-Z/!]|\[[^\]]+\]:\s|([-*_=])(?:\s*\1){2,}\s*$|=+\s*$|-+\s*$)")


def masked(text):
    """The text, of the same length, without what hides dots: code, addresses, what stands in brackets and quotation marks."""
    def hide(pattern, text, keep=1):
        return re.sub(pattern, lambda m: m[0][:keep] + "x" * (len(m[0]) - 2 * keep) + m[0][len(m[0]) - keep:], text)

    def hide_quoted(match):  # a sentence may end before the closing mark
        inner = match[0][1:-1]
        return match[0][0] + "x" * (len(inner) - 1) + inner[-1:] + match[0][-1]

    text = re.sub(r"(`+)(?!`)(.+?)(?<!`)\1(?!`)", lambda m: m[1] + "x" * len(m[2]) + m[1], text)
    text = hide(r"<https?://[^>]*>", text)
    text = re.sub(r"(?<=\]\()[^()]*(?:\([^()]*\)[^()]*)*(?=\))", lambda m: "x" * len(m[0]), text)
    text = re.sub(r'"[^"]+"|“[^”]+”', hide_quoted, text)
    while True:  # innermost brackets first; "(It is.)" keeps its end
        fresh = re.sub(r"\(([^()]*)\)", lambda m: "\1" + "x" * max(len(m[1]) - 1, 0) + m[1][-1:] + "\2", text)
        if fresh == text:
            return text.replace("\1", "(").replace("\2", ")")
        text = fresh


def ends(text):
    """Whether the text, masked, ends like a sentence or an introduction to what follows."""
    return text.rstrip().rstrip(CLOSERS)[-1:] in (".", "!", "?", ":", "…") or text.rstrip().endswith("`:")


def sentences(text):
    """The sentences of a text without line breaks."""
    mask = masked(text)
    found, begin = [], 0
    for match in re.finditer(rf"(?<=[.!?])[{re.escape(CLOSERS)}]*\s+(?=[{re.escape(OPENERS)}]*[A-ZÄÖÜ0-9`])", mask):
        before = mask[begin:match.end()].rstrip()
        word = before.rstrip(CLOSERS)
        last = word.rstrip(".").split()[-1:] or [""]
        last = last[0].lstrip(OPENERS)
        inside = mask[match.start() - 1] != "." or not word.endswith("..")
        if word.endswith(".") and (last.lower() in ABBREVIATIONS or re.fullmatch(r"[A-Z]", last) or not inside):
            continue
        if re.fullmatch(r"(\*\*|__|\*|_).+?\1", before) and before.count(before[:2]) <= 2:  # a heading in the line
            continue
        closing = mask[match.start():match.end()]
        if ")" in closing and before.count("(") - before.count(")") == 0 and not before.startswith("("):
            continue  # "(It is.) And on": the bracket belongs to the sentence before it
        found.append(text[begin:match.end()].strip())
        begin = match.end()
    return found + [text[begin:].strip()]


def only_links(text):
    return not re.sub(r"!?\[[^\]]*\]\([^)]*\)|\[!\[[^\]]*\]\([^)]*\)\]\([^)]*\)", "", text).strip()


def arranged(lines):
    """The lines of one paragraph, without their indentation, as they should stand."""
    groups = [[]]
    for line in lines:
        groups[-1].append(line)
        if line.endswith(("  ", "\\", "<br>")) or only_links(line) or ends(masked(" ".join(groups[-1]))):
            groups.append([])
    fresh = []
    for group in filter(None, groups):
        tail = "  " if group[-1].endswith("  ") else ""
        parts = sentences(" ".join(line.strip() for line in group))
        fresh += parts[:-1] + [parts[-1] + tail]
    return fresh


def blocks(lines):
    """Yields (first line, end, prefix of the first line, prefix of the others) of what is checked."""
    i, fence, comment, math = 0, None, False, False
    indent = 0  # where the text of the list item begins that we are in
    while i < len(lines):
        line = lines[i]
        mark = FENCE.match(line)
        if fence:
            if mark and mark[1].startswith(fence) and line.strip() == mark[1]:
                fence = None
            i += 1
        elif comment or line.lstrip().startswith("<!--"):
            comment = "-->" not in line
            i += 1
        elif math or line.lstrip().startswith("$$"):
            math = not line.rstrip().endswith("$$") or not math and line.strip() == "$$"
            i += 1
        elif mark:
            fence = mark[1]
            i += 1
        elif not line.strip() or OTHER.match(line) and not ITEM.match(line):
            if line.strip() and not line.startswith(" "):
                indent = 0
            i += 1
        elif not ITEM.match(line) and len(line) - len(line.lstrip()) >= indent + 4:  # indented code
            i += 1
        else:
            item, quote = ITEM.match(line), QUOTE.match(line)
            first = quote[0] if quote else item[0] if item else re.match(r"\s*", line)[0]
            rest = quote[0] if quote else " " * len(first)
            indent = len(first) if item else indent if line.startswith(" ") else 0
            end = i + 1
            while end < len(lines) and lines[end].strip() and not OTHER.match(lines[end]) and not ITEM.match(lines[end]) \
                    and not FENCE.match(lines[end]) and bool(QUOTE.match(lines[end])) == bool(quote):
                if quote and (not lines[end][len(quote[0]):].strip() or ITEM.match(lines[end][len(quote[0]):])):
                    break
                end += 1
            yield i, end, first, rest
            i = end


def rewritten(text):
    """The page with one sentence per line, and (line, what is wrong) for each paragraph that changes."""
    lines = text.split("\n")
    fresh, wrong, last = [], [], 0
    for begin, end, first, rest in blocks(lines):
        old = [lines[begin][len(first):]] + [QUOTE.sub("", line, 1) if QUOTE.match(first) else line.lstrip() for line in lines[begin + 1:end]]
        new = arranged(old)
        if [line.rstrip() for line in old] != [line.rstrip() for line in new]:
            place = next((i for i, (a, b) in enumerate(zip(old, new)) if a.rstrip() != b.rstrip()), 0)
            two = len(new[place]) < len(old[place].rstrip())
            wrong.append((begin + place + 1, "two sentences in a line" if two else "a sentence over several lines"))
            fresh += lines[last:begin] + [(rest if i else first) + line for i, line in enumerate(new)]
            last = end
    return "\n".join(fresh + lines[last:]), wrong


def main(arguments):
    write = "--write" in arguments
    named = [pathlib.Path(argument) for argument in arguments if argument != "--write"]
    root = named[0].resolve() if named and named[0].is_dir() else pathlib.Path(__file__).resolve().parents[2]
    pages = named if named and not named[0].is_dir() else [root / name for name in files_of(root, ".md")]
    found = 0
    for page in pages:
        text, wrong = rewritten(page.read_text())
        if write and wrong:
            page.write_text(text)
            print(f"{page}: rewritten")
        elif wrong:
            found += len(wrong)
            print("\n".join(f"{page}:{line}: {what}" for line, what in wrong))
    if found:
        sys.exit(f"markdown: {found} paragraphs do not have one sentence per line: tests/scripts/markdown.py --write splits them")
    print("Markdown has one sentence per line")


if __name__ == "__main__":
    main(sys.argv[1:])
