#!/usr/bin/env python3
"""Checks that each link within the repository leads somewhere: in all .md files, relative paths and #anchors.

usage: links.py [ROOT of the repository]

Addresses (https://...) are not visited. An anchor is a heading of the page, spelled as GitHub and GitLab do.
"""
import pathlib
import re
import sys
import urllib.parse

FENCE = re.compile(r"^(```|~~~).*?^\1[^\S\n]*$", re.M | re.S)
COMMENT = re.compile(r"<!--.*?-->", re.S)
CODE = re.compile(r"(`+)(?!`).*?(?<!`)\1(?!`)", re.S)
LINK = re.compile(r"\[[^\[\]]*\]\(\s*<?([^)\s>]*)>?(?:\s+\"[^\"]*\")?\s*\)")
HEADING = re.compile(r"^#{1,6}\s+(.*?)\s*#*\s*$", re.M)


def blanked(pattern, text):
    """The text with each match replaced by as many empty lines, so that line numbers stay."""
    return pattern.sub(lambda found: "\n" * found[0].count("\n"), text)


def anchors(text):
    """The anchors of a page, in order."""
    found = []
    for heading in HEADING.findall(blanked(FENCE, text)):
        heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        anchor = re.sub(r"[^\w\- ]", "", heading.replace("`", "").replace("*", "")).strip().lower().replace(" ", "-")
        same = found.count(anchor) + sum(a.startswith(f"{anchor}-") and a[len(anchor) + 1:].isdigit() for a in found)
        found.append(f"{anchor}-{same}" if same else anchor)
    return found


def links(text):
    """Yields line and target of each link of a page."""
    plain = blanked(CODE, blanked(COMMENT, blanked(FENCE, text)))
    for link in LINK.finditer(plain):
        yield plain.count("\n", 0, link.start()) + 1, link[1]


def check(page, root):
    """Yields what is wrong with one page."""
    for line, target in links(page.read_text()):
        where = f"{page.relative_to(root)}:{line}: {target}"
        if re.match(r"[a-z][a-z0-9+.-]*:", target):
            continue
        path, _, anchor = urllib.parse.unquote(target).partition("#")
        to = (page.parent / path).resolve() if path else page
        if not to.is_relative_to(root):
            yield f"{where}: leads out of the repository"
        elif not to.exists():
            yield f"{where}: there is no such file"
        elif anchor and (to.suffix != ".md" or anchor not in anchors(to.read_text())):
            yield f"{where}: {to.relative_to(root)} has no heading for this anchor"


def main(arguments):
    root = pathlib.Path(arguments[0]).resolve() if arguments else pathlib.Path(__file__).resolve().parents[2]
    pages = [p for p in sorted(root.rglob("*.md"))
             if not any(part in ("build", ".git") for part in p.relative_to(root).parts)]
    found = [problem for page in pages for problem in check(page, root)]
    print("\n".join(found) or f"all links of {len(pages)} pages lead somewhere")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
