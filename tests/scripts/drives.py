#!/usr/bin/env python3
"""Checks that a family of drives is whole: what `How to add a drive` in CONTRIBUTING.md asks for.

usage: drives.py [ROOT of the repository]

A family is a header in hardware/drives/ that decodes frames: it declares a static function `decode`, however that is spelled. For each part that it lacks there is a sentence, which says what to add to which file. Comments and
what stands in `#if 0` are no part of a file, and neither is an `#include` alone.
"""
import pathlib
import re
import sys

HARDWARE = "hardware/include/cca/hardware"
DRIVES = HARDWARE + "/drives"
VIRTUAL = HARDWARE + "/virtual_drives"
CCA_CAN = "tools/cca_can"

TOKEN = re.compile(r"""
    (?P<comment> //[^\n]* | /\*.*?(?:\*/|\Z) )
  | R"(?P<mark>[^()\s\\"]{0,16})\(.*?\)(?P=mark)"
  | "(?:\\.|[^"\\\n])*"
  | (?<![0-9a-fA-F])'(?:\\[^\n][0-9a-fA-F]*|[^'\\\n])'
""", re.VERBOSE | re.DOTALL)

PARAMETER = re.compile(r"[<,]\s*class\b")  # of a template
STRUCT = re.compile(r"(?<!enum )\b(?:struct|class)\s+(?:\[\[.*?\]\]\s*)?(\w+)(?=[^()]*\Z)")


UNSEEN = ("this check does not see: a line in CHANGELOG.md, `wraps` where a position begins again, sentences of docs, "
          "whether what is there is right, and whether the programs compile and pass")


class Unreadable(Exception):
    pass


# ---- files ----

def shown(path):
    return str(path).encode("unicode_escape", "backslashreplace").decode("ascii")


def read(root, name):
    """The text of a file; None: there is none."""
    path = root / name
    if path.is_symlink() and not path.exists():
        raise Unreadable(f"{shown(name)}: this is a link to a file that does not exist: remove the link, or make the file")
    if not path.exists():
        return None
    if path.is_dir():
        raise Unreadable(f"{shown(name)}: this is a folder, and a file of this name is expected: rename the folder")
    try:
        return path.read_bytes().decode("utf-8")
    except UnicodeDecodeError as error:
        raise Unreadable(f"{shown(name)}: byte {error.start + 1} is not UTF-8: save the file as UTF-8") from None
    except OSError as error:
        raise Unreadable(f"{shown(name)}: the file can't be read: {error.strerror}") from None


# ---- C++ ----

def without_comments(text):
    """And without what stands in `#if 0`."""
    text = TOKEN.sub(lambda token: " " if token["comment"] else token[0], text)
    lines, off = [], 0
    for line in text.split("\n"):
        if off and re.match(r"\s*#\s*if", line):
            off += 1
        elif off and (re.match(r"\s*#\s*endif", line) or off == 1 and re.match(r"\s*#\s*(else|elif)", line)):
            off -= 1
        elif not off and re.match(r"\s*#\s*if\s+(0|false)\b", line):
            off = 1
        elif not off:
            lines.append(line)
    return "\n".join(lines)


def without_strings(text):
    return TOKEN.sub(lambda token: '""' if token[0][0] != "'" else "' '", text)


def body(code, begin):
    """What the next braces after `begin` contain; empty if the declaration ends before."""
    opened = re.compile(r"[{;]").search(code, begin)
    if not opened or opened[0] == ";":
        return ""
    depth = 0
    for brace in re.compile(r"[{}]").finditer(code, opened.start()):
        depth += 1 if brace[0] == "{" else -1
        if depth == 0:
            return code[opened.end():brace.start()]
    return ""


def decoding_type(code):
    """The struct with a static function `decode`; None: there is no such function."""
    scopes, begin = [], 0
    for at in re.finditer(r"[{};]|\bdecode\s*\(", code):
        before = code[begin:at.start()]
        if at[0][0] == "d":
            if re.search(r"\bstatic\b", before):
                return next((name for name in reversed(scopes) if name), "")
            continue
        if at[0] == "{":
            named = STRUCT.search(PARAMETER.sub("", before))
            scopes.append(named[1] if named else "")
        elif at[0] == "}" and scopes:
            scopes.pop()
        begin = at.end()
    return None


def words_behind(code, start):
    """The words of `start`, and those that the aliases and structs of this file put behind them."""
    behind = {}
    for name, what in re.findall(r"\busing\s+(\w+)\s*=([^;]*);", code):
        behind.setdefault(name, []).append(what)
    for struct in re.finditer(r"\b(?:struct|class)\s+(\w+)\s*(?:final\s*)?(:(?!:)[^{;]*)?(?=\{)", code):
        behind.setdefault(struct[1], []).append((struct[2] or "") + body(code, struct.end()))
    found, todo = set(), set(re.findall(r"\w+", start))
    while todo:
        word = todo.pop()
        found.add(word)
        todo |= {w for text in behind.get(word, []) for w in re.findall(r"\w+", text)} - found
    return found


def tested_by(code, law):
    """The arguments of each `law<...>()` in a test case; those of a template are its list of types."""
    for case in re.finditer(r"\bTEST_CASE(_TEMPLATE)?\s*\(", code):
        arguments = code[case.end():(code.find("{", case.end()) + 1 or len(code) + 1) - 1]
        for called in re.finditer(law + r"\s*<([^;]*?)>\s*\(", body(code, case.end())):
            yield called[1]
            listed = arguments.split(",")
            if case[1] and len(listed) > 1 and re.search(rf"\b{re.escape(listed[1].strip())}\b", called[1]):
                yield ",".join(listed[2:])


# ---- pages ----

def tables(page):
    """Each table as (the heading above it, rows of cells)."""
    page = re.sub(r"<!--.*?(-->|\Z)", "", page, flags=re.DOTALL)
    heading, rows = "", []
    for line in page.split("\n") + [""]:
        if line.startswith("|"):
            rows.append([cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip().strip("|"))])
        else:
            if rows:
                yield heading, rows
                rows = []
            if line.startswith("#"):
                heading = line.lstrip("#").strip()


def has_row(page, first, heading=""):
    """A row whose first cell has this pattern and whose second cell is not empty."""
    return any(len(row) > 1 and row[1] and re.search(first, row[0])
               for above, rows in tables(page) if above.startswith(heading) for row in rows)


def has_named(page, first, second):
    """A row whose first cell has the one pattern, and a later one the other."""
    return any(re.search(first, row[0]) and re.search(second, " ".join(row[1:])) for _, rows in tables(page) for row in rows)


def has_column(page, *names):
    """A table whose first line has one of these names, with a text in each of its lines."""
    for _, rows in tables(page):
        for at, head in enumerate(rows[0]):
            if at > 0 and not rows[0][0] and head.strip("`") in names:
                if len(rows) > 2 and all(len(row) > at and row[at] for row in rows[2:]):
                    return True
    return False


def number_word(n):
    words = "no one two three four five six seven eight nine ten eleven twelve".split()
    return words[n] if n < len(words) else str(n)


# ---- a family ----

class Family:
    def __init__(self, name, type_name):
        self.name, self.type = name, type_name or name
        self.virtual = f"virtual_{name}"
        self.word = rf"(?<![\w-]){re.escape(name)}(?![\w-])"
        # cia402 is written CiA 402, my_drive is written My drive.
        parts = re.split(r"_|(?<=[a-zA-Z])(?=\d)", name)
        self.title = r"(?i:(?<!\w)" + "[ _-]?".join(re.escape(part) for part in parts) + r"(?!\w))"
        # As on the command line of cca-can: "odrive:3", "odrive-0.5:3".
        self.spelled = rf"(?<![\w-]){re.escape(name)}(-[\w.]+)?:"

    def specialisation(self, code, template):
        for found in re.finditer(rf"\b(?:struct|class)\s+{template}\s*<\s*(?:\w+\s*::\s*)*{re.escape(self.type)}\b[^{{;]*", code):
            if self.virtual in re.findall(r"\w+", found[0] + body(code, found.end())):
                return True
        return False

    def includes(self, text, header):
        return re.search(rf"(?m)^\s*#\s*include\s*<cca/hardware/{re.escape(header)}>", without_comments(text))

    # Step 2
    def short_path(self, text):
        return self.includes(text, f"drives/{self.name}.hpp")

    def short_virtual_path(self, text):
        return self.includes(text, f"virtual_drives/{self.virtual}.hpp")

    def virtual_drive(self, text):
        code = without_strings(without_comments(text))
        return any(all(re.search(rf"\b{member}\s*\(", body(code, found.end())) for member in ("hear", "law", "answer"))
                   for found in re.finditer(rf"\b(?:struct|class)\s+{re.escape(self.virtual)}\b", code))

    def virtual_of(self, text):
        return self.specialisation(without_strings(without_comments(text)), "virtual_of")

    # Step 1
    def states_bad_number(self, text):
        return "drive.bad_number" in without_comments(text)

    # Steps 3 to 5
    def laws(self, text):
        code = without_strings(without_comments(text))
        return any(self.type in words_behind(code, what) for what in tested_by(code, r"\bdrive"))

    def virtual_laws(self, text):
        code = without_strings(without_comments(text))
        return any(self.virtual in words_behind(code, what) for what in tested_by(code, r"\bvirtual_drive"))

    def fuzz_target(self, text):
        code = without_strings(without_comments(text))
        return "LLVMFuzzerTestOneInput" in code and any(self.type in words_behind(code, what)
                                                        for what in re.findall(r"\bhears\s*<([^;]*?)>\s*\(", code))

    def robot_with_all(self, text):
        code = without_strings(without_comments(text))
        return any(self.type in words_behind(code, what) for what in re.findall(r"\bstruct\s+\w+\s*:\s*on_bus\s*<([^{;]*)>\s*\{", code))

    def judged(self, text):
        code = without_strings(without_comments(text))
        found = re.search(r"\bread\s*\([^;{]*\{", code)
        return found and re.search(rf"\bis_{re.escape(self.name)}\s*<", body(code, found.end() - 1))

    # Step 6
    def followed(self, text):
        return any(rows[0][0] == "drive" and re.search(self.title, row[0]) for _, rows in tables(text) for row in rows[2:])

    def header_row(self, text):
        return has_row(text, rf"<cca/hardware/{re.escape(self.name)}\.hpp>")

    def column(self, text):
        return has_column(text, self.name, self.type)

    def virtual_column(self, text):
        return has_column(text, self.virtual)

    def source_row(self, text):
        return has_row(text, self.title, "Sources")

    def model(self, name):
        def is_listed(text):
            # A list in the comment at the top: "Models: mit.hpp, odrive.hpp. Laws: ..."
            listed = re.search(r"(?m)^//.*?\bModels:((?:\s*(?://)?\s*\w[\w.+-]*\.hpp,?)*)", text)
            return listed and re.search(rf"(?<![\w.+-]){re.escape(name)}\.hpp(?![\w+-])", listed[1])
        return is_listed

    def readme(self, text):
        return has_row(text, "^drives$") and any(row[0] == "drives" and re.search(self.title, " ".join(row[1:])) for _, rows in tables(text) for row in rows)

    def listed_page(self, text):
        return any("](drives.md)" in cell and re.search(self.title, " ".join(row[at + 1:]))
                   for _, rows in tables(text) for row in rows for at, cell in enumerate(row))

    # Step 7
    def tool_family(self, text):
        return re.search(rf'\bfamily\s*\{{\s*"{self.spelled}', without_comments(text))

    def tool_codec(self, text):
        return re.search(rf'\bsame_as_codec\s*<[^;]*?>\s*\(\s*"{self.spelled}', without_comments(text))

    def address(self, text):
        code = without_strings(without_comments(text))
        return any(all(re.search(rf"\b{member}\s*\(", body(code, found.end())) for member in ("to_real", "to_unit"))
                   for found in re.finditer(rf"\bstruct\s+{re.escape(self.name)}_address\b", code))

    def families_row(self, text):
        said = re.search(r"\bfamilies\s*=([^;]*);", without_comments(text))
        return said and re.search(self.spelled, "".join(re.findall(r'"((?:\\.|[^"\\])*)"', said[1])))

    def with_drive(self, text):
        code = without_comments(text)
        for found in re.finditer(r"\bwith_drive\s*\([^;{]*\{", code):
            what = body(code, found.end() - 1)
            if re.search(rf'"{re.escape(self.name)}(-[\w.]+)?"', what) and re.search(rf"\b{re.escape(self.name)}_address\b", without_strings(what)):
                return True
        return False

    def played(self, text):
        return self.specialisation(without_strings(without_comments(text)), "played")

    def help(self, text):
        return re.search(self.spelled, without_comments(text).partition("help_text")[2])

    def page_row(self, text):
        return has_row(text, rf"`{self.spelled}")

    def wrong_name(self, text):
        said = '"' + without_comments(text).partition('TEST_CASE("a wrong name')[2].partition(";")[0]
        return re.search(self.spelled, "".join(re.findall(r'"((?:\\.|[^"\\])*)"', said)))

    def effects(self, command):
        return lambda text: has_named(text, f"^`{command}`$", self.title)

    def jogs(self, text):
        return any(above == "jog" and re.search(self.title, row[0]) for above, rows in tables(text) for row in rows[2:])

    def is_asked(self, root):
        """Its address asks something: `ask` returns a frame."""
        code = without_strings(without_comments(read(root, CCA_CAN + "/drives/addresses.hpp") or ""))
        for found in re.finditer(rf"\bstruct\s+{re.escape(self.name)}_address\b", code):
            if asks := re.search(r"\bask\s*\(\s*\)[^;{]*\{", what := body(code, found.end())):
                return not re.fullmatch(r"\s*return\s*(?:[\w:]+\s*)?(?:\{\s*\}|\(\s*\))\s*;\s*", body(what, asks.end() - 1))
        return False

    def in_list_of_asked(self, text):
        # On a line with --ask, or on the next one: "mit,moteus,robstride", "some of mit, moteus".
        code = without_comments(text)
        beside = "\n".join(re.findall(r"[^\n]*--ask[^\n]*\n?[^\n]*", code))
        return any(self.name in re.split(r",\s*", words) for words in re.findall(r"(?<![\w,])\w+(?:,\s*\w+)*", beside))

    def parts_if_asked(self):
        add = f"`{self.name}` to the families of `--ask`"
        files = ("commands.hpp", "words.hpp", "commands/list.hpp", "commands/help.hpp")
        return [(f"{CCA_CAN}/{file}", self.in_list_of_asked, 7, "its name among the families that `list --ask` asks", add) for file in files] + [
            ("docs/cca_can.md", self.effects("list"), 7, "what the question of `list` does to it", "its name to the row `list` of the table of what a command does to a motor")]

    def parts(self):
        """Of each part: the file, whether a text of it has the part, the step, what is lacking, what to add."""
        name, virtual = self.name, self.virtual
        drive_name = CCA_CAN + "/drives/drive_name.hpp"
        row, models = "a row that begins with", "the list after `Models:`"
        return [
            (f"{HARDWARE}/{name}.hpp", self.short_path, 2, "its short path for programs", f"`#include <cca/hardware/drives/{name}.hpp>`"),
            (f"{VIRTUAL}/{virtual}.hpp", self.virtual_drive, 2, "its virtual drive", f"`{virtual}` with its members `hear`, `law` and `answer`"),
            (f"{VIRTUAL}/virtual_of.hpp", self.virtual_of, 2, "the way from it to its virtual drive, which `virtual_robot` takes",
             f"the specialisation `virtual_of<{self.type}...>`, derived from `{virtual}`,"),
            (f"{HARDWARE}/{virtual}.hpp", self.short_virtual_path, 2, "the short path of its virtual drive", f"`#include <cca/hardware/virtual_drives/{virtual}.hpp>`"),
            (f"tests/runtime/hardware/{name}.cpp", self.laws, 3, "a test of the laws of drives", f"a test case that calls `laws::drive<{self.type}...>()`"),
            ("tests/runtime/drive_chain/virtual_drives.cpp", self.virtual_laws, 4, "a test of the laws of virtual drives",
             f"a rig of `{virtual}` to the list of the test case `the laws`"),
            ("tests/laws/families_oncilla.hpp", self.robot_with_all, 4, "a joint of the robot with all families", f"a joint `on_bus<..., {self.type}..., ...>`"),
            ("tests/fuzz/robot/judge.hpp", self.judged, 4, "what its frames ask for, for the campaign of a whole robot", f"a branch for `is_{name}<D>` to `read`"),
            (f"tests/fuzz/{name}.cpp", self.fuzz_target, 5, "a fuzz target of its decoder", f"`LLVMFuzzerTestOneInput` with a call of `fuzz::hears<{self.type}...>`"),
            ("docs/drives.md", self.header_row, 6, "its row in the table of headers", f"{row} `<cca/hardware/{name}.hpp>`"),
            ("docs/drives.md", self.column, 6, "its column in the table of drives", f"a column `{self.type}` with what it does in each line"),
            ("docs/drives.md", self.virtual_column, 6, "its column in the table of virtual drives", f"a column `{virtual}` with what it does in each line"),
            ("docs/drives.md", self.source_row, 6, "its row in the table of sources", f"{row} its name and has your source"),
            (f"{DRIVES}/drive.hpp", self.model(name), 6, "its name in the list of models", f"`{name}.hpp` to {models}"),
            (f"{VIRTUAL}/virtual_drive.hpp", self.model(virtual), 6, "the name of its virtual drive in the list of models", f"`{virtual}.hpp` to {models}"),
            ("docs/README.md", self.listed_page, 6, "its name in the list of pages", "it to the row of `[Drives](drives.md)`"),
            ("README.md", self.readme, 6, "its name in the table of what it works with", "it to the row of `drives`"),
            ("docs/robots.md", self.followed, 6, "its name in the table of what a drive follows", f"it to the first column of the table that begins with `drive`"),
            (CCA_CAN + "/drives/addresses.hpp", self.address, 7, "its address in cca-can", f"a struct `{name}_address` with `to_real` and `to_unit`"),
            (drive_name, self.families_row, 7, "its row in the list of families of cca-can", f"`{name}:...` to the text `families`"),
            (drive_name, self.with_drive, 7, "its place among the drives of cca-can", f'a branch for "{name}" with `{name}_address` to `with_drive`'),
            (drive_name, self.played, 7, "a drive that cca-can can play", f"the specialisation `played<{self.type}...>` with `{virtual}`"),
            (CCA_CAN + "/commands/help.hpp", self.help, 7, "its name in the help of cca-can", f"`{name}:...` to the drives in `help_text`"),
            ("docs/cca_can.md", self.page_row, 7, "its row in the table of drives of cca-can", f"{row} `{name}:...`"),
            ("docs/cca_can.md", self.effects("enable"), 7, "what `enable` does to it", "its name to the row `enable` of the table of what a command does to a motor"),
            ("docs/cca_can.md", self.jogs, 7, "how jog moves it", "its name to the table below `jog`"),
            ("tests/runtime/tool/families.cpp", self.tool_family, 7, "a test that cca-can lists, enables and jogs it", f'`family{{"{name}:...", ...}}` to the list of families'),
            ("tests/runtime/tool/drives.cpp", self.tool_codec, 7, "a test that cca-can sends what its codec sends", f'a call `same_as_codec<{self.type}...>("{name}:...", ...)`'),
            ("tests/runtime/tool/drives.cpp", self.wrong_name, 7, "its name in the test of a wrong name", f'`{name}:...` to the first message in the test case "a wrong name..."'),
        ]

    def refuses_bad_number(self, root):
        """A mistake of this family in tests/rejects, if its header has a sentence about its number."""
        codec = f"{DRIVES}/{self.name}.hpp"
        if not self.states_bad_number(read(root, codec)):
            return True
        return any(self.includes(text := read(root, str(file.relative_to(root))), f"{self.name}.hpp") and "CCA_REJECT" in text
                   for file in sorted((root / "tests/rejects").glob("drive.bad_number*.cpp")))

    def corpus(self, root):
        """A frame is longer than its head: four bytes for the id, length and flags."""
        folder = root / "tests/fuzz/corpus" / self.name
        return folder.is_dir() and any(file.is_file() and not file.name.startswith(".") and file.stat().st_size > 6 for file in folder.iterdir())


def families(root, refused):
    for header in sorted((root / DRIVES).glob("*.hpp")):
        name = f"{DRIVES}/{header.name}"
        try:
            type_name = decoding_type(without_strings(without_comments(read(root, name))))
        except Unreadable as why:
            refused.append(str(why))
            continue
        if header.stem != "drive" and type_name is not None:
            yield Family(header.stem, type_name)


def problems(root):
    refused = []
    found = list(families(root, refused))
    yield from refused
    if not found and not refused:
        yield f"{DRIVES}: there is no family of drives: this is no repository of cca, or no header there has a static function `decode`"
    told = set(refused)
    counted = re.search(r"(\w+) families of CAN drives", read(root, "README.md") or "") if found else None
    if counted and counted[1] != number_word(len(found)):
        yield f"README.md: it says `{counted[0]}`, and there are {number_word(len(found))}: change the word in README.md (step 6 of How to add a drive in CONTRIBUTING.md)"
    for family in found:
        def lacks(what, add, file, step):
            return (f"{shown(file)}: the drive `{shown(family.name)}` lacks {what}: add {shown(add)} in {shown(file)} "
                    f"(step {step} of How to add a drive in CONTRIBUTING.md)")
        try:
            asked = family.parts_if_asked() if family.is_asked(root) else []
        except Unreadable:
            asked = []  # said below, of the part that stands in that file
        for file, has, step, what, add in family.parts() + asked:
            try:
                text = read(root, file)
            except Unreadable as why:
                if str(why) not in told:
                    yield str(why)
                told.add(str(why))
                continue
            if text is None or not has(text):
                yield lacks(what, add, file, step)
        try:
            refused_number = family.refuses_bad_number(root)
        except Unreadable as why:
            refused_number = True
            if str(why) not in told:
                yield str(why)
            told.add(str(why))
        if not refused_number:
            yield lacks("a mistake for its sentence `drive.bad_number`", f"a file that includes `<cca/hardware/{family.name}.hpp>` and has the mistake",
                        f"tests/rejects/drive.bad_number-{family.name}.cpp", 1)
        if not family.corpus(root):
            yield lacks("a first frame for its fuzz target", "a file with a frame of more than 6 bytes", f"tests/fuzz/corpus/{family.name}", 5)


def main(arguments):
    sys.stdout.reconfigure(errors="backslashreplace")
    found = list(problems(pathlib.Path(arguments[0] if arguments else ".")))
    print("\n".join(found) or f"each drive is whole; {UNSEEN}")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
