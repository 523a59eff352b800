"""The checks of formatting: each must let pass what is right and name what is wrong."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import format
import markdown

HERE = pathlib.Path(__file__).resolve().parent


class Sentences(unittest.TestCase):
    def same(self, *sentences):
        self.assertEqual(markdown.sentences(" ".join(sentences)), list(sentences))

    def test_ends(self):
        self.same("It works.", "Does it?", "Yes!", "`load` reads a file.", "**Bold** text (so it is).", "12 tests pass.", "[A link](a.md) follows.")
        self.same('It says "stop".', "So it stops.")
        self.same('It says "Stop. Go."', "It goes.")

    def test_no_ends(self):
        for text in ("See e.g. Fig. 3 and i.e. this, cf. Sect. 4.", "From 0.5 to 1.5 rad in `a. B` and a.cpp.", "A. J. Ijspeert et al. 2013 did it.",
                     "First a, ... Then z.", "It goes (it does. Really.) on.", "[A page](a. B. C) is here.", 'It says "a. B. c" there.',
                     "**Faults.** A component may stop.", "*One beat.* First of all it begins.", "It costs 5 s vs. 7 s.", "It holds (so it does.) And how it holds."):
            with self.subTest(text=text):
                self.same(text)


class Markdown(unittest.TestCase):
    def passes(self, text):
        self.assertEqual(markdown.rewritten(text), (text, []))

    def becomes(self, text, fresh, line, what):
        self.assertEqual(markdown.rewritten(text), (fresh, [(line, what)]))
        self.passes(fresh)

    def test_right(self):
        self.passes("# A heading. With a dot\n\nOne sentence.\nAnother one:\n\n- an item\n- one more. \n  With two sentences.\n\n> A quote.\n> It goes on.\n")
        self.passes("| a. B | c |\n|---|---|\n| One. Two. | three |\n")
        self.passes("```cpp\n// One. Two.\nint\nx;\n```\n\n~~~\nOne. Two.\n~~~\n\n    One. Two.\n")
        self.passes("$$a = b,\\qquad\nc = d$$\nThen.\n\n$$\na = b\n$$\n\n$$a. B = c$$\n")
        self.passes("- An item with code:\n  ```sh\n  one. Two\n  three\n  ```\n")
        self.passes("<!-- One. Two.\nThree. -->\n<p>One. Two.</p>\n\n[a]: http://b.c\n\n---\n")
        self.passes("A sentence that ends here.\ng++ begins the next one in a line of its own.\n")
        self.passes("![one](a.svg)\n![two](b.svg)\n")
        self.passes("One line\\\nand a hard break.\n")

    def test_two_sentences(self):
        two = "two sentences in a line"
        self.becomes("One. Two.\n", "One.\nTwo.\n", 1, two)
        self.becomes("First.\nOne. Two.\n", "First.\nOne.\nTwo.\n", 2, two)
        self.becomes("1. One. Two.\n2. Three.\n", "1. One.\n   Two.\n2. Three.\n", 1, two)
        self.becomes("- a\n  - One. Two.\n", "- a\n  - One.\n    Two.\n", 2, two)
        self.becomes("> One. Two.\n", "> One.\n> Two.\n", 1, two)
        self.becomes("**Faults.** One. Two.\n", "**Faults.** One.\nTwo.\n", 1, two)

    def test_wrapped(self):
        wrapped = "a sentence over several lines"
        self.becomes("A sentence\nthat goes on.\n", "A sentence that goes on.\n", 1, wrapped)
        self.becomes("- An item,\n  which goes on.\n", "- An item, which goes on.\n", 1, wrapped)
        self.becomes("> A quote,\n> which goes on.\n", "> A quote, which goes on.\n", 1, wrapped)


class Program(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def run_script(self, name, *arguments, **options):
        done = subprocess.run([sys.executable, "-B", str(HERE / name), *arguments, str(self.root)], capture_output=True, text=True, **options)
        return done.returncode, done.stdout + done.stderr

    def test_markdown(self):
        page = self.root / "a.md"
        page.write_text("One. Two.\n")
        code, said = self.run_script("markdown.py")
        self.assertEqual(code, 1)
        self.assertIn("a.md:1: two sentences in a line", said)
        self.run_script("markdown.py", "--write")
        self.assertEqual(page.read_text(), "One.\nTwo.\n")
        self.assertEqual(self.run_script("markdown.py")[0], 0)

    def test_format_finds_and_writes(self):
        if not shutil.which(format.PROGRAM):
            self.fail(f"{format.PROGRAM} is missing: run ./bootstrap")
        (self.root / ".clang-format").write_text("BasedOnStyle: Google\n")
        source = self.root / "a.cpp"
        source.write_text("int   x;\n")
        code, said = self.run_script("format.py")
        self.assertEqual(code, 1)
        self.assertIn("a.cpp:1:4: not formatted", said)
        self.assertEqual(self.run_script("format.py", "--write")[0], 0)
        self.assertEqual(source.read_text(), "int x;\n")
        self.assertEqual(self.run_script("format.py")[0], 0)

    def test_tables_in_comments_stay(self):
        style = (HERE.parents[1] / ".clang-format").read_text()
        (self.root / ".clang-format").write_text(style)
        source = self.root / "a.hpp"
        for table in ("//   first    {}\n//   second   other\n", "// | {} | b |\n// | c | d |\n"):
            source.write_text("// A table.\n//\n" + table.format(("word " * 25).strip()) + "int x;\n")
            before = source.read_text()
            self.assertEqual(self.run_script("format.py", "--write")[0], 0)
            self.assertEqual(source.read_text(), before)
        source.write_text("// " + "word " * 25 + "\n// more.\nint x;\n")  # running text is filled
        self.run_script("format.py", "--write")
        self.assertLess(max(map(len, source.read_text().splitlines())), 111)

    def test_format_says_what_is_missing(self):
        code, said = self.run_script("format.py", env={"PATH": str(self.root)})
        self.assertEqual(code, 1)
        self.assertIn("run ./bootstrap", said)

    def test_without_git(self):
        (self.root / "build").mkdir()
        for name in ("a.cpp", "build/b.cpp", "c.hpp"):
            (self.root / name).write_text("")
        self.assertEqual([file.name for file in format.files_of(self.root, ".cpp", ".hpp")], ["a.cpp", "c.hpp"])


if __name__ == "__main__":
    unittest.main()
