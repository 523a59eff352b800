"""Tests of links.py and outputs.py."""
import pathlib
import tempfile
import unittest

import links
import outputs


class Links(unittest.TestCase):
    def problems(self, text, **others):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            (root / "page.md").write_text(text)
            for name, content in others.items():
                (root / f"{name}.md").write_text(content)
            return list(links.check(root / "page.md", root))

    def test_a_file_that_exists(self):
        self.assertEqual(self.problems("[other](other.md)", other=""), [])

    def test_a_file_that_does_not_exist(self):
        self.assertEqual(self.problems("\n\n[other](othr.md)"), ["page.md:3: othr.md: there is no such file"])

    def test_a_file_outside_of_the_repository(self):
        self.assertEqual(len(self.problems("[other](../other.md)")), 1)

    def test_anchors(self):
        page = "# Two words, `code` and a_b\n## Same\n## Same\n"
        self.assertEqual(links.anchors(page), ["two-words-code-and-a_b", "same", "same-1"])
        self.assertEqual(self.problems("[a](other.md#same-1) [b](#here)\n# Here", other=page), [])
        self.assertEqual(len(self.problems("[a](other.md#same-2)", other=page)), 1)
        self.assertEqual(len(self.problems("[a](#there)\n# Here")), 1)

    def test_rule_ids_as_headings(self):
        self.assertEqual(links.anchors("## skeleton.arity\n"), ["skeletonarity"])

    def test_code_and_addresses_are_no_links(self):
        self.assertEqual(self.problems("`[x](no.md)` [y](https://example.org/no.md)\n```cpp\n[&](auto) {} [z](no.md)\n```\n"), [])


class Outputs(unittest.TestCase):
    def test_errors_of_gcc(self):
        told = "In file included from a.cpp:5:\n/src/refusal.hpp: In instantiation of 'x':\na.cpp:33:29:   required from here\n" \
               "/src/refusal.hpp:25:17: error: wrong\n   25 |   code\n"
        self.assertEqual(outputs.errors_in(told, "a.cpp"), "a.cpp:   required from here\nrefusal.hpp: error: wrong\n")

    def test_errors_of_clang(self):
        told = "In file included from x/a.cpp:5:\n../refusal.hpp:25:17: error: wrong\nx/a.cpp:33:29: note: requested here\n" \
               "1 error generated.\n"
        self.assertEqual(outputs.errors_in(told, "x/a.cpp"), "refusal.hpp: error: wrong\na.cpp: note: requested here\n")

    def test_a_block(self):
        page = "<!-- output of a b -->\n```text\none\ntwo\n```\nmore\n"
        self.assertEqual([b["text"] for b in outputs.blocks("a b").finditer(page)], ["one\ntwo\n"])
        self.assertEqual(list(outputs.blocks("a").finditer(page)), [])


if __name__ == "__main__":
    unittest.main()
