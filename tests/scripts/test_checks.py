"""Tests of the checks: each must accept correct input and report every mistake."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import compilers
import components
import drives
import elementary
import figures
import finite
import headers_alone
import includes
import make_troubleshooting
import reductions
import refusals
import reject
import rules
import snippets
import temporary
import version
import words


class Tree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def write(self, name, text):
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        return file


class Refusals(Tree):
    def setUp(self):
        super().setUp()
        self.write("door/include/cca/door/a.hpp", 'if (x) return fail("no such thing: " + name);\nthrow refused("it is closed");\n')
        self.write("tests/a.cpp", 'CHECK(why == "no such "\n  "thing: x");\n')
        self.row = "no such thing: | tests/a.cpp | no such thing: x\n"

    def test_a_refusal_needs_a_line(self):
        self.write(refusals.TABLE, self.row)
        self.assertEqual([one for one in refusals.check(self.root)],
                         [f'door/include/cca/door/a.hpp: "it is closed": write a test of this refusal, and a line for it in {refusals.TABLE}'])

    def test_a_line_needs_a_refusal_and_a_test(self):
        self.write(refusals.TABLE, self.row + "it is closed | tests/a.cpp | closed\nit is gone | tests/b.cpp | gone\n")
        self.assertEqual(len(list(refusals.check(self.root))), 3)
        self.write("tests/a.cpp", "no such thing: x, it is closed")
        self.write(refusals.TABLE, self.row + "it is closed | tests/a.cpp | it is closed\n")
        self.assertEqual(list(refusals.check(self.root)), [])


class Components(Tree):
    def found(self, row, code, page="Header: `<cca/motor/a.hpp>`.", folder="motor"):
        self.write(components.PAGE, f"## Components of the library\n\n| component | header | page |\n|---|---|---|\n{row}\n")
        self.write("docs/motor.md", page)
        self.write(f"include/cca/{folder}/a.hpp", code)
        return list(components.problems(self.root))

    def test_all(self):
        code = "struct a {\n  auto process(beat now) -> out<1> {}\n};\n"
        row = "| `a<S>` | `motor/a.hpp` | x | [Motor](motor.md#a) |"
        self.assertEqual(self.found(row, code), [])
        self.assertEqual(len(self.found("| `b<S>` | `motor/a.hpp` | [Motor](motor.md) |", code)), 1)  # declares no `b`
        self.assertEqual(len(self.found("| `a<S>` | `motor/b.hpp` | [Motor](motor.md) |", code)), 2)  # no such header; `a` has no row
        self.assertEqual(len(self.found(row, code, page="Header: `<cca/motor/b.hpp>`.")), 1)  # the page names another header
        self.assertEqual(len(self.found("| `a<S>` | `motor/a.hpp` | [Motor](none.md) |", code)), 1)  # no such page
        self.assertEqual(len(self.found("| `a<S>` | `motor/a.hpp` | x |", code)), 1)  # no page
        self.assertEqual(len(self.found(f"{row}\n{row}", code)), 1)  # two rows
        self.assertEqual(self.found(row, f"namespace detail {{\n{code}}}  // namespace detail\nusing a = int;"), [])
        self.assertEqual(len(self.found(row, code, folder="adaptive")), 1)  # has no row

class Compilers(Tree):
    def found(self, where, code, page=""):
        self.write(compilers.PAGE, page)
        self.write(where, code)
        return list(compilers.problems(self.root))

    def test_all(self):
        attribute = "[[gnu::always_inline]] void f();\n"
        named = "`include/cca/motor/a.hpp`"
        self.assertEqual(self.found("include/cca/motor/a.hpp", attribute, named), [])
        self.assertEqual(self.found("include/cca/motor/a.hpp", "// A list (docs/compilers.md).\n", named), [])
        self.assertEqual(len(self.found("include/cca/motor/a.hpp", "int a;\n", named)), 1)  # nothing there that the page explains
        self.assertEqual(len(self.found("include/cca/motor/a.hpp", attribute)), 1)  # the page does not name it
        self.assertEqual(len(self.found("include/cca/motor/a.hpp", "// See docs/compilers.md.\n")), 1)
        self.assertEqual(len(self.found("include/cca/motor/a.hpp", "// g++ 12 needs it.\n")), 1)
        self.assertEqual(len(self.found("include/cca/motor/a.hpp", "int a;  // Clang needs it.\n")), 1)
        self.assertEqual(len(self.found("include/cca/motor/a.hpp", "#if defined(__clang__)\n")), 1)
        self.assertEqual(len(self.found("include/cca/motor/a.hpp", "// clang-format off\n")), 0)
        self.found("include/cca/motor/a.hpp", "int a;\n")
        self.assertEqual(self.found("include/cca/runtime/b.hpp", attribute), [])
        self.assertEqual(self.found("include/cca/base/compiler.hpp", "// g++\n#if defined(__clang__)\n"), [])
        self.assertEqual(len(self.found("hardware/include/cca/hardware/c.hpp", attribute)), 1)


class Includes(Tree):
    def found(self, name, *targets, more=""):
        self.write(name, "// Why.\n#pragma once\n" + "".join(f"#include <{t}>\n" for t in targets) + more)
        return list(includes.problems(self.root))

    def test_right(self):
        self.found("include/cca/graph/a.hpp", "vector", "Eigen/Core", "cca/space/b.hpp", "cca/graph/c.hpp", "cca/version.hpp")
        self.found("include/cca/runtime/b.hpp", "cca/graph/a.hpp")
        self.found("include/cca/config/c.hpp", "toml++/toml.h", "cca/component/a.hpp")
        self.found("include/cca/config.hpp", "toml++/toml.h", "cca/config/c.hpp", "cca/component/a.hpp")
        self.found("include/cca/cca.hpp", "cca/graph/a.hpp", "cca/runtime/a.hpp")
        self.found("include/cca/motor.hpp", "cca/motor/a.hpp", "cca/space/a.hpp")
        self.found("robots/include/cca/robots/a.hpp", "cca/robot/a.hpp", "cca/robots/b.hpp")
        self.found("hardware/include/cca/hardware/drives/a.hpp", "cca/robots/a.hpp", "cca/hardware/bus/b.hpp")
        self.found("dds/include/cca/dds/a.hpp", "dds/dds.h", "cca/dds/b.hpp", "cca/runtime/b.hpp")
        self.assertEqual(self.found("sim/include/cca/sim/a.hpp", "cca/robots/a.hpp", "cca/robot/a.hpp", "cca/cca.hpp", "ode/ode.h", "cca/sim/b.hpp"), [])

    def test_wrong(self):
        for name, target in (("include/cca/space/a.hpp", "cca/graph/a.hpp"), ("include/cca/graph/a.hpp", "cca/runtime/a.hpp"),
                             ("include/cca/runtime/a.hpp", "cca/robot/a.hpp"), ("include/cca/robot/a.hpp", "cca/config/a.hpp"),
                             ("include/cca/graph/a.hpp", "cca/cca.hpp"), ("include/cca/cca.hpp", "cca/config/a.hpp"),
                             ("include/cca/robot/a.hpp", "cca/sim/a.hpp"), ("include/cca/graph/a.hpp", "toml++/toml.h"),
                             ("include/cca/graph/a.hpp", "ode/ode.h"), ("include/cca/graph/a.hpp", "boost/hana.hpp"),
                             ("include/cca/odd/a.hpp", "cca/space/a.hpp"), ("include/cca/odd.hpp", "cca/space/a.hpp"),
                             ("sim/include/cca/sim/a.hpp", "cca/hardware/a.hpp"), ("hardware/include/cca/hardware/a.hpp", "cca/sim/a.hpp"),
                             ("robots/include/cca/robots/a.hpp", "cca/sim/a.hpp"), ("robots/include/cca/robots/a.hpp", "ode/ode.h"),
                             ("include/cca/robot/a.hpp", "cca/robots/a.hpp"), ("include/cca/graph/a.hpp", "dds/dds.h"),
                             ("dds/include/cca/dds/a.hpp", "cca/robots/a.hpp"), ("include/cca/runtime/a.hpp", "cca/dds/a.hpp")):
            with self.subTest(name=name, target=target):
                self.setUp()
                self.assertEqual(len(self.found(name, target)), 1)

    def test_rooms(self):
        self.found("include/cca/runtime/a.hpp", "cca/runtime/b.hpp")
        self.found("include/cca/runtime/environments/c.hpp", "cca/runtime/a.hpp", "cca/runtime/live/d.hpp")
        self.found("hardware/include/cca/hardware/robot/e.hpp", "cca/hardware/bus/f.hpp")
        self.assertEqual(self.found("hardware/include/cca/hardware/f.hpp", "cca/hardware/robot/f.hpp"), [])
        for number, (name, target) in enumerate((("include/cca/runtime/g.hpp", "cca/runtime/live/d.hpp"), ("include/cca/runtime/odd/h.hpp", "cca/runtime/a.hpp"),
                                                 ("include/cca/runtime/environments/i.hpp", "cca/runtime/transports/j.hpp"),
                                                 ("hardware/include/cca/hardware/bus/k.hpp", "cca/hardware/drives/l.hpp"),
                                                 ("hardware/include/cca/hardware/safety/m.hpp", "cca/hardware/oncilla.hpp")), 1):
            self.assertEqual(len(self.found(name, target)), number, name)

    def test_headers_that_are_rooms(self):
        self.found("include/cca/base/math.hpp", "cca/base/math/a.hpp")
        self.found("include/cca/robot/recorded/b.hpp", "cca/robot/body_tree.hpp")
        self.found("include/cca/adaptive/choice/c.hpp", "cca/adaptive/sequencer.hpp")
        self.assertEqual(self.found("include/cca/adaptive/plan/d.hpp", "cca/adaptive/choice/d.hpp"), [])  # it forwards
        self.assertEqual(len(self.found("include/cca/adaptive/plan/e.hpp", "cca/adaptive/choice/c.hpp", "cca/adaptive/criterion.hpp")), 1)
        self.assertEqual(len(self.found("include/cca/base/math/f.hpp", "cca/base/math.hpp", "cca/base/inlining.hpp")), 2)
        self.assertEqual(len(self.found("include/cca/robot/recorded/g.hpp", "cca/robot/body_pose.hpp", "cca/robot/body.hpp")), 3)
        self.assertEqual(len(self.found("include/cca/runtime/environments/waiting/h.hpp", "cca/runtime/environments/links/i.hpp", "cca/base/file.hpp")), 4)

    def test_every_room_is_known(self):
        root = pathlib.Path(includes.__file__).parents[2]
        self.assertEqual(list(includes.unknown_rooms(root)), [])
        for folder, rooms in includes.ROOMS.items():
            for room in rooms:
                name = room if room.endswith(".hpp") else "a.hpp" if room == "." else f"{room}/a.hpp"
                part = folder.split("/")[0]
                base = {"ros2": "dds/include/"}.get(part, f"{part}/include/" if part in includes.OUTSIDE else "include/")
                self.write(f"{base}cca/{folder}/{name}", "// Why.\n#pragma once\n")
        self.write("include/cca/cca.hpp", "// All.\n#pragma once\n")
        self.assertEqual(list(includes.unknown_rooms(self.root)), [])
        self.write("sim/include/cca/sim/engine/wheels/a.hpp", "// Why.\n#pragma once\n")
        self.write("include/cca/trace/odd/a.hpp", "// Why.\n#pragma once\n")
        self.assertEqual(len(list(includes.unknown_rooms(self.root))), 2)
        (self.root / "include/cca/base/math.hpp").unlink()
        self.assertEqual(len(list(includes.unknown_rooms(self.root))), 3)

    def test_macros(self):
        self.assertEqual(self.found("include/cca/base/a.hpp", more="#define A\n"), [])
        self.assertEqual(self.found("include/cca/runtime/b.hpp", more="#define A\n"), [])
        self.assertEqual(len(self.found("include/cca/motor/c.hpp", more="# define A\n")), 1)

    def test_form(self):
        self.assertEqual(len(self.found("include/cca/space/long.hpp", more="\n" * 340)), 1)
        self.write("include/cca/space/long.hpp", "int x;\n")
        self.assertEqual(len(list(includes.problems(self.root))), 2)

    def test_folders(self):
        for i in range(20):
            self.found(f"include/cca/graph/h{i}.hpp")
        self.assertEqual(self.found("include/cca/graph/plan/h20.hpp"), [])
        self.assertEqual(len(self.found("include/cca/graph/h20.hpp")), 2)  # the folder, and the name
        self.assertEqual(len(self.found("include/cca/motor/h0.hpp")), 3)
        self.assertEqual(len(self.found("include/cca/mapping.hpp")), 3)
        self.found("include/cca/mapping/mapping.hpp")
        self.write("include/cca/motor/h1.hpp", "// Moved.\n#pragma once\n\n#include <cca/graph/h1.hpp>\n")
        self.assertEqual(len(list(includes.problems(self.root))), 3)

    def test_short_paths_do_not_count(self):
        for i in range(20):
            self.write(f"hardware/include/cca/hardware/h{i}.hpp", "// Why.\n#pragma once\n")
        self.write("hardware/include/cca/hardware/drive.hpp", "// For programs.\n#pragma once\n\n#include <cca/hardware/drives/drive.hpp>\n")
        self.assertEqual(list(includes.problems(self.root)), [])
        self.write("hardware/include/cca/hardware/h20.hpp", "// Why.\n#pragma once\n")
        self.assertEqual(len(list(includes.problems(self.root))), 1)

    def test_folders_of_programs(self):
        for i in range(20):
            self.write(f"tools/a/h{i}.hpp", "")
        self.assertEqual(list(includes.problems(self.root)), [])
        self.write("tools/a/h20.hpp", "")
        self.assertEqual(len(list(includes.problems(self.root))), 1)

    def test_what_is_named_exists(self):
        self.write("tests/runtime/space/a.cpp", "")
        self.assertEqual(self.found("include/cca/space/a.hpp", more="// Example: tests/runtime/space/a.cpp.\n"), [])
        self.assertEqual(len(self.found("include/cca/space/a.hpp", more="// Example: tests/runtime/space/b.cpp; docs/c.md.\n")), 2)

    def test_one_header_includes_hana(self):
        self.found("include/cca/component/b.hpp", "boost/hana/tuple.hpp")
        self.assertEqual(len(self.found("include/cca/graph/a.hpp", "boost/hana/tuple.hpp")), 1)

    def test_only_main_knows_the_command_line(self):
        self.assertEqual(self.found("include/cca/main/a.hpp", "CLI/CLI.hpp"), [])
        self.assertEqual(self.found("include/cca/main/b.hpp", "cca/config/f.hpp"), [])
        self.assertEqual(len(self.found("include/cca/main/g.hpp", "cca/config.hpp")), 1)
        self.assertEqual(len(self.found("include/cca/runtime/c.hpp", "CLI/CLI.hpp")), 2)
        self.assertEqual(len(self.found("include/cca/runtime/d.hpp", "cca/main/a.hpp")), 3)
        self.assertEqual(len(self.found("include/cca/runtime/e.hpp", "cca/config.hpp")), 4)


class HeadersAlone(Tree):
    def refused(self, **headers):
        for name, text in headers.items():
            self.write(f"include/cca/{name}.hpp", text)
        found = headers_alone.headers(self.root)
        return found, [header for header, _ in headers_alone.refused(found, self.root, ["clang++-19", f"-I{self.root / 'include'}"])]

    def test_all(self):
        (self.root / "outside.hpp").write_text("")
        headers_alone.precompiled(self.root / "outside.hpp", ["clang++-19", f"-I{self.root / 'include'}"], self.root / "outside.pch")
        found, refused = self.refused(a="#pragma once\nstruct a {};\n", b="#pragma once\n#include <cca/a.hpp>\ninline a of_a;\n",
                                      c="#pragma once\ninline a of_a;\n")
        self.assertEqual(found, ["cca/a.hpp", "cca/b.hpp", "cca/c.hpp"])
        self.assertEqual(refused, ["cca/c.hpp"])
        self.write("include/cca/d.hpp", "#include <vector>\n  #include <cca/a.hpp>\n")
        self.assertEqual(headers_alone.includes_from_outside(self.root), ["<vector>"])

    def test_share(self):
        found = list(range(10))
        self.assertEqual(headers_alone.share(found, 1, "00000003ab"), found)
        self.assertEqual(headers_alone.share(found, 4, ""), [0, 4, 8])  # not in a repository
        parts = [headers_alone.share(found, 4, f"0000000{commit}ab") for commit in range(4)]
        self.assertEqual(sorted(sum(parts, [])), found)


class Snippets(Tree):
    SOURCE = "int main() {\n  // [part]\n  f();\n    g();\n  // [part end]\n}\n"

    def found(self, code, write=False):
        self.write("a.cpp", self.SOURCE)
        self.write("README.md", f"Text.\n\n<!-- from a.cpp: part -->\n```cpp\n{code}```\nMore.\n")
        return list(snippets.check(self.root / "README.md", self.root, write))

    def test_equal(self):
        self.assertEqual(self.found("f();\n  g();\n"), [])

    def test_different(self):
        self.assertEqual(len(self.found("f();\n")), 1)

    def test_written(self):
        self.found("f();\n", write=True)
        self.assertIn("```cpp\nf();\n  g();\n```\nMore.\n", (self.root / "README.md").read_text())
        self.assertEqual(list(snippets.check(self.root / "README.md", self.root, False)), [])

    def test_no_source(self):
        page = self.write("README.md", "```cpp\nf();\n```\n\n<!-- from b.cpp: part -->\n```cpp\nf();\n```\n")
        self.assertEqual(len(list(snippets.check(page, self.root, False))), 2)

    def test_no_block(self):
        self.write("a.cpp", self.SOURCE)
        page = self.write("README.md", "Write `<!-- from a.cpp: part -->`.\n\n<!-- from a.cpp: part -->\n\nText.\n")
        self.assertEqual(len(list(snippets.check(page, self.root, False))), 1)


class Elementary(Tree):
    def lines(self, code):
        return [line for line, _ in elementary.calls(code)]

    def test_calls(self):
        for wrong in ("x = std::sin(y);", "std::atan2(a, b)", "return f(std::powf(a, 2));", "std::transform(a, b, c, std::tanh<double>);", "using std::exp;",
                      "x = 2 *::hypot(a, b);", "x = __builtin_log(y);", "return sin(x);", "x = -cos(y) + 1;", "h = (A * x).array().tanh();", "h = x.array().exp() + 1;",
                      "Eigen::AngleAxisd(a, b)", "Eigen::Quaterniond q(Eigen::Matrix3d(m));", "a.slerp(t, b)", "std::normal_distribution<double> noise;",
                      "x = std::sqrt(y);", "x = 2 * std::floor(z);"):
            self.assertEqual(self.lines("\n" + wrong), [2], wrong)
        for right in ("x = math::sin(y);", "return cca::math::pow(a, 2);", "x = math::sqrt(y) + std::abs(math::floor(z));", "// std::sin(x)", "/* std::sin(x)\n*/",
                      'm << "write std::exp(x)";', "return rotation::exp(v);", "inline vector4<Scalar> exp(const vector3<Scalar>& v) {", "template <class Quaternion>",
                      "auto remainder = 3;", "std::expected<int>", "std::log_level x;", "find.exp(x, 1)", "cosine(x)"):
            self.assertEqual(self.lines(right), [], right)

    def test_files(self):
        for name in elementary.OUTSIDE:
            self.write(name, "x = std::sin(y);")
        self.write("include/cca/base/math/angles.hpp", "x = std::sin(y);")
        self.write("include/cca/a.hpp", "x = math::sin(y);")
        self.assertEqual(list(elementary.problems(self.root)), [])
        self.write("include/cca/a.hpp", "\nx = std::sin(y);")
        self.write(next(iter(elementary.OUTSIDE)), "x = 1;")
        found = list(elementary.problems(self.root))
        self.assertEqual(len(found), 2, found)
        self.assertTrue(found[0].startswith("include/cca/a.hpp:2: std::sin "))


class Reductions(Tree):
    def lines(self, code):
        return [line for line, _ in reductions.calls(code)]

    def test_calls(self):
        for wrong in ("x = a.dot(b);", "x = (a - b).norm();", "x = a.template head<3>().squaredNorm();", "x = p->sum();", "x = a.lpNorm<1>();", "x = m.trace() + 1;",
                      "x = (a\n  - b).mean();", "x = m.rowwise().sum();", "n = v.normalized();", "x = m.determinant();", "x = m.transpose() * v;", "x = m.transpose()\n* v;",
                      "const Eigen::LLT<matrix> f(m);", "x = m.llt().solve(b);", "w = slope.inverse() * b;", "Eigen::SelfAdjointEigenSolver<matrix> s(m);"):
            self.assertEqual(len(self.lines(wrong)), 1, wrong)
        self.assertEqual(self.lines("\nx = a\n  .norm();"), [3])
        for right in ("x = math::dot(a, b);", "x = math::norm(a - b);", "x = math::sum(v);", "m = a * b.transpose();", "// x = a.dot(b)", "/* a.norm()\n*/", '"a.sum()"',
                      "writer.dot()", "x = v.maxCoeff();", "sum = 1;", "a.normal(b)", "rotation::inverse(q)", "x = t.dot_product(b);", "j.inverse * t"):
            self.assertEqual(self.lines(right), [], right)

    def test_files(self):
        for name in [*reductions.OUTSIDE, *(f"{folder}/a.hpp" for folder in reductions.OUTSIDE_FOLDERS)]:
            self.write(name, "x = v.norm();")
        self.write(reductions.OWN, "x = v.norm();")
        self.write("include/cca/a.hpp", "x = math::norm(v);")
        self.assertEqual(list(reductions.problems(self.root)), [])
        self.write("include/cca/a.hpp", "\nx = v.norm();")
        for name in (next(iter(reductions.OUTSIDE)), next(iter(reductions.OUTSIDE_FOLDERS)) + "/a.hpp"):
            self.write(name, "x = 1;")
        found = list(reductions.problems(self.root))
        self.assertEqual(len(found), 3, found)
        self.assertTrue(found[0].startswith("include/cca/a.hpp:2: norm() "))


class Version(Tree):
    def found(self, changes="# Changelog\n\n## Unreleased (1.3.0)\n\n## 1.2.0\n\n## 1.1.0\n", **files):
        self.write(version.HEADER, "int version_major = 1;\nint version_minor = 2;\nint version_patch = 0;\n")
        self.write("CHANGELOG.md", changes)
        for name in ("CMakeLists.txt", "docs/a.md"):
            self.write(name, files.get(name.partition(".")[0].replace("/", "_"), ""))
        return list(version.problems(self.root))

    def test_all(self):
        self.assertEqual(self.found(CMakeLists="project(cca VERSION ${version})\nfind_package(cca REQUIRED)", docs_a="find_package(cca 1.2 REQUIRED)"), [])
        self.assertEqual(len(self.found(changes="# Changelog\n\n## Unreleased (1.2.0)\n\n## 1.1.0\n")), 1)
        self.assertEqual(len(self.found(changes="")), 1)
        self.assertEqual(len(self.found(CMakeLists="project(cca VERSION 1.2.0)")), 1)
        self.assertEqual(len(self.found(CMakeLists="find_package(cca 1.2 REQUIRED)")), 1)
        self.assertEqual(len(self.found(docs_a="find_package(cca 1.1 REQUIRED)")), 1)


class Words(Tree):
    def found(self, text, name="docs/a.md"):
        self.write(name, text)
        return list(words.problems(self.root))

    def test_all(self):
        self.assertEqual(self.found("A wall-clock run, `as_fast_as_possible{}`, a pace on a clock of yours.\n"), [])
        self.assertEqual(self.found("It goes at wall-clock speed.\n"), ["docs/a.md:1: `at wall-clock speed`: write `in a wall-clock run`"])
        self.assertEqual(self.found("A run on a clock.\nAs fast as possible it waits.\n"), ["docs/a.md:2: `As fast as possible`: write `in a fast run`",
                                                                                      "docs/a.md:1: `on a clock`: write `in a wall-clock run`"])
        self.assertEqual(len(self.found("", "docs/a.md") + self.found("// It goes as fast\n  // as possible.\n", "include/cca/a.hpp")), 1)
        self.assertEqual(self.found("At wall-clock speed.\n", "CHANGELOG.md")[1:], [])

    def test_written(self):
        file = self.write("include/cca/a.hpp", "// At wall-clock\n// speed it goes, as fast as possible it waits.\n")
        self.assertEqual(list(words.problems(self.root, write=True)), [])
        self.assertEqual(file.read_text(), "// In a wall-clock\n// run it goes, in a fast run it waits.\n")


class Figures(Tree):
    PAGE = """## The trot's controller

| compiler | flags | instructions per beat | graph : by hand | ns |
|---|---|---|---|---|
| g++ | `-O2` | 1,000 / 1,100 / 2,500 | **0.909** | 1 |
| clang | `-O2` | 2,000 / 2,040 / 9,400 | **0.980** | 1 |

## Graphs that nobody tuned

| compiler | flags | mean | most | least |
|---|---|---|---|---|
| g++ | `-O2` | **1.051** | **1.124** | 0.993 |
| clang | `-O2` | **1.004** | **1.038** | 0.902 |

## Compiling

| graph | compiler | nodes | s | s above Eigen |
|---|---|---|---|---|
| chain | g++ | 100 | 1.7 | 0.7 |
| mixed | g++ | 100 | 1.8 | 0.8 |
| mixed | g++ | 300 | 1.8 | 1.9 |
| chain, a type each | g++ | 100 | 2.6 | 1.7 |
"""
    README = ("It takes 0.91 to 0.98 times the instructions of the same arithmetic by hand, the other 2.5 to 4.7 times those of the graph.\n"
              "It takes 1.00 to 1.05 times on average in graphs that nobody tuned, and 0.90 to 1.12 times in single ones.\n"
              "It takes 0.7 to 0.8 s more than Eigen's header alone, or 1.7 to 1.7 s if each node has a type of its own.\n")

    def found(self, readme, page=PAGE):
        self.write("README.md", readme)
        self.write("docs/performance.md", page)
        return list(figures.problems(self.root))

    def test_all(self):
        self.assertEqual(self.found(self.README), [])
        self.assertEqual(self.found(self.README.replace("0.91", "0.90")),
                         ["README.md: `0.90 to 0.98 times the instructions of the same arithmetic by hand`: docs/performance.md has 0.91 to 0.98"])
        self.assertEqual(len(self.found(self.README.replace("0.7 to 0.8", "0.7 to 1.9"))), 1)
        self.assertEqual(len(self.found("")), 6)
        self.assertEqual(len(self.found(self.README, "")), 6)


class Rules(Tree):
    def test_rules(self):
        self.write("include/cca/graph/a.hpp", '// "node.comment"\nauto a = "space.mismatch"; auto b = "wire.direction: " + wire<"node.x", "graph.y">{};\n')
        self.write("tests/rejects/space.mismatch.cpp", "")
        self.write("tests/rejects/space.mismatch-axes.cpp", "")
        self.write("tests/rejects/rate.gone.cpp", "")
        self.assertEqual(sorted(rules.rules(self.root)), ["space.mismatch", "wire.direction"])
        self.assertEqual(len(list(rules.problems(self.root))), 2)

    def test_rules_of_graphs(self):
        def header(name, id):
            self.write(f"include/cca/graph/diagnosis/rules/wires/{name}.hpp", f'static constexpr std::string_view id = "{id}";\n')
            self.write(f"tests/rejects/{id}.cpp", "")

        self.write("include/cca/graph/diagnosis/rules/rules.hpp", "using rules = list<\n    wire_direction,\n    wire_two_writers\n>;\n")
        header("wire_two_writers", "wire.two_writers")
        header("wire_direction", "wire.direction")
        self.write("tests/rejects/many_nodes/mistakes.cpp", "// EXPECT a: wire\\.direction: a\n// EXPECT b: wire\\.two_writers: b\n")
        self.assertEqual(rules.rules_of_graphs(self.root), ["wire.direction", "wire.two_writers"])
        self.assertEqual(list(rules.problems(self.root)), [])
        sentence = 'm.say() << "leads back: "\n         "turn it round" << x << "twice";'
        self.write("include/cca/graph/diagnosis/rules/wires/wire_direction.hpp", f'id = "wire.direction";\n{sentence}\n')
        self.assertEqual([problem.partition(": ")[2] for problem in rules.problems(self.root)],
                         ["no tells<> in tests/static expects `leads back: turn it round`"])
        self.write("tests/static/rules_wires.cpp", 'tells<a, b>({"wire.direction", "a.y", "`a.y` leads "\n "back: turn it "\n  "round"})\n')
        self.assertEqual(list(rules.problems(self.root)), [])
        header("wire_forgotten", "wire.forgotten")
        header("wire_direction", "wire.other")
        # One header is not in the list, one has another id than its name, and no header states wire.direction.
        self.assertEqual(len(list(rules.problems(self.root))), 3)

    def test_rules_of_modes_and_deployments(self):
        folder = "include/cca/graph/modes/rules"
        self.write("include/cca/graph/diagnosis/rules/rules.hpp", "using rules = list<\n    part_unknown_path\n>;\n")
        self.write("include/cca/graph/diagnosis/rules/components/part_unknown_path.hpp", 'id = "part.unknown_path";\n')
        self.write(f"{folder}/list_of_modes.hpp", "struct rules_of_modes {\n  using type = list<\n      part_unknown_path,\n      modes_two_rates\n  >;\n};\n")
        self.write(f"{folder}/modes_two_rates.hpp", 'id = "modes.two_rates";\n')
        self.write("include/cca/graph/deployment/rules/rules_of_deployments.hpp", "using type = list<deployment_unplaced>;\n")
        self.write("include/cca/graph/deployment/rules/deployment_unplaced.hpp", 'id = "deployment.unplaced";\n')
        ids = ["part.unknown_path", "deployment.unplaced", "modes.two_rates"]
        for id in ids:
            self.write(f"tests/rejects/{id}.cpp", "")
        self.write("tests/rejects/many_nodes/mistakes.cpp", "".join("// EXPECT a: " + id.replace(".", "\\.") + ": a\n" for id in ids))
        self.assertEqual(rules.rules_of_graphs(self.root), ids)
        self.assertEqual(list(rules.problems(self.root)), [])
        self.write(f"{folder}/modes_forgotten.hpp", 'id = "modes.forgotten";\n')
        self.assertEqual(len(list(rules.problems(self.root))), 2)  # in no list, without a file in tests/rejects


    def test_strategies(self):
        self.write("include/cca/graph/a.hpp", 'auto a = "space.mismatch";')
        self.write("tests/rejects/space.mismatch.cpp", "")
        self.write("include/cca/component/strategies/always.hpp", "")
        self.write("include/cca/component/strategies.hpp", "using library_strategies = list<always>;\n")
        row = "# Strategies\n\n| strategy | fires if |\n|---|---|\n| `always<N>` | always |\n"
        self.write("docs/strategies.md", row)
        self.assertEqual(list(rules.problems(self.root)), [])
        self.write("docs/strategies.md", row.replace("`always", "`other"))
        self.assertEqual(len(list(rules.problems(self.root))), 1)
        self.write("include/cca/component/strategies/never.hpp", "")
        self.assertEqual(len(list(rules.problems(self.root))), 3)


class Finite(Tree):
    def test_every_header_has_a_test_or_a_reason(self):
        for name in finite.WITHOUT:
            self.write(f"include/cca/{name}", "" if name in finite.SILENT else "// While an input is NaN: nothing.\n")
        self.write("include/cca/motor/hopf.hpp", "// While an input is NaN or infinite, it stands still.\n#pragma once\n")
        self.write("tests/runtime/finite/motor.cpp", 'TEST_CASE("motor/hopf.hpp") {}\n')
        self.assertEqual(list(finite.problems(self.root)), [])
        self.write("include/cca/motor/hopf.hpp", "// An oscillator.\n#pragma once\n// NaN is told too late.\n")
        self.assertEqual(len(list(finite.problems(self.root))), 1)
        self.write("include/cca/motor/hopf.hpp", "// NaN passes.\n#pragma once\n")
        self.write("include/cca/motor/gait.hpp", "// NaN means walk.\n#pragma once\n")
        self.assertEqual(len(list(finite.problems(self.root))), 1)
        self.write("include/cca/motor/gait.hpp", "")
        self.write("include/cca/motor/forgotten.hpp", "// NaN passes.\n")
        self.write("tests/runtime/finite/motor.cpp", 'TEST_CASE("motor/hopf.hpp") {}\nTEST_CASE("motor/gone.hpp") {}\n')
        self.assertEqual(len(list(finite.problems(self.root))), 2)


class Rejects(Tree):
    SOUND = '// EXPECT: space\\.mismatch: a and b\n#if CCA_REJECT\nstatic_assert(false, "space.mismatch: a and b");\n#endif\n'

    def wrong(self, text, name="space.mismatch.cpp"):
        return reject.verdict(self.write(name, text), ["g++", "-std=c++20"])[0]

    def test_sound(self):
        self.assertEqual(self.wrong(self.SOUND), "")
        self.assertEqual(self.wrong(self.SOUND, "space.mismatch-axes.cpp"), "")

    def test_instantiated_only_when_used(self):
        self.assertEqual(self.wrong(self.SOUND.replace("static_assert(false", "template <class T> void f(T) { static_assert(sizeof(T) == 0")
                                    .replace(");\n#endif", "); }\nint main() { f(0); }\n#endif")), "")

    def test_unsound(self):
        self.assertIn("first line", self.wrong("int x;\n"))
        self.assertIn("rule's id", self.wrong(self.SOUND, "space.other.cpp"))
        self.assertIn("without the mistake", self.wrong(self.SOUND.replace("#if CCA_REJECT", "#if 1")))
        self.assertIn("accepts", self.wrong(self.SOUND.replace("#if CCA_REJECT", "#if 0")))
        self.assertIn("does not match", self.wrong(self.SOUND.replace("#if CCA_REJECT", "#if CCA_REJECT\nint x = y;")))
        self.assertRegex(self.wrong(self.SOUND.replace('"space.mismatch: a', '"space.mismatch: c')), "does not match: .* a and b; it says: space.mismatch: c and b$")
        self.assertIn("2 errors", self.wrong(self.SOUND.replace("#endif", "int x = y;\n#endif")))
        self.assertIn("lines of output", self.wrong(self.SOUND.replace("#endif", "\n".join(f"#warning {i}" for i in range(30)) + "\n#endif")))

    def test_lines(self):
        longer = self.SOUND.replace("#endif", "\n".join(f"#warning {i}" for i in range(4)) + "\n#endif")
        self.assertEqual(self.wrong(longer), "")
        self.assertEqual(self.wrong(longer.replace("#if", "// LINES: 16\n#if")), "")
        self.assertIn("more than 14", self.wrong(longer.replace("#if", "// LINES: 14\n#if")))

    def test_flags_and_further_errors(self):
        text = self.SOUND.replace("#if CCA_REJECT", "// FLAGS: -DOLD=1\n#if CCA_REJECT && OLD")
        self.assertEqual(self.wrong(text), "")
        self.assertIn("accepts", self.wrong(text.replace("FLAGS", "FLAG")))
        two = self.SOUND.replace("#if CCA_REJECT\n", "// ERRORS: 2\n#if CCA_REJECT\nint x = y;\n")
        self.assertEqual(self.wrong(two), "")
        self.assertIn("3 errors, and 2 would do", self.wrong(two.replace("#endif", "int z = y;\n#endif")))
        self.assertIn("no error matches", self.wrong(two.replace('"space.mismatch: a', '"space.mismatch: c')))

    MANY = ('// EXPECT left: rule\\.a: left\n// EXPECT right: rule\\.a: right\n#if CCA_REJECT\nconstexpr int left = 1, right = 2;\n'
            'static_assert(CCA_REJECT != left, "rule.a: left");\nstatic_assert(CCA_REJECT != right, "rule.a: right");\n#endif\n').replace(
                "#if CCA_REJECT", "#ifdef CCA_REJECT")

    def test_many_mistakes(self):
        self.assertEqual(self.wrong(self.MANY, "many.cpp"), "")
        self.assertIn("right: the compiler accepts", self.wrong(self.MANY.replace("!= right", "!= 3"), "many.cpp"))

    def test_sentence(self):
        full = "x" * reject.COLUMN
        self.assertEqual(reject.sentence('error: t<c{"a sentence  "}, c{"in columns,"}, c{"of which a    "}>'), "a sentence in columns, of which a")
        self.assertEqual(reject.sentence(f'error: t<c{{"a   "}}, c{{"{full}"}}, c{{"yz and  "}}>'), f"a {full}yz and")
        self.assertEqual(reject.sentence("f.hpp:1:2: error: static assertion failed: rule.a: left"), "rule.a: left")
        self.assertEqual(reject.sentence("f.hpp:1:2: error: static assertion failed due to requirement 'a<b>': rule.a: left"), "rule.a: left")
        self.assertEqual(reject.sentence("f.hpp:1:2: error: no such thing"), "no such thing")

    def test_prepared(self):
        self.write("include/cca/cca.hpp", '#pragma once\n#include "known.hpp"\n')
        self.write("include/cca/known.hpp", "struct known {};\n")
        command = ["g++", "-std=c++20", f"-I{self.root}/include"]
        self.assertEqual(reject.prepare(self.root / "headers", command)[0], 0)
        self.write("include/cca/known.hpp", "#error is read again\n")
        self.write("parts.hpp", "#include <cca/cca.hpp>\n")
        file = self.write("space.mismatch.cpp", self.SOUND.replace("#if", '#include "parts.hpp"\nknown k;\n#if', 1))
        self.assertEqual(reject.verdict(file, reject.prepared(self.root / "headers", command))[0], "")


class Troubleshooting(Tree):
    REJECT = ("// EXPECT: rule\\.a: it is `(b|c)`\n// Why it is\n// so.\n#include <x>\nf(\n#if CCA_REJECT\n    b,\n    1\n#else\n    c\n#endif\n);\n")
    OUTPUT = ('In file included from here:\n/long/way/refusal.hpp:16:17: error: t<line{"rule.a: it is    "}, line{"`b`   "}>\n'
              "/there/rule.a.cpp:29:27: note: in instantiation of template class 'c<g>' requested here\n")

    def page(self):
        file = self.write("tests/rejects/rule.a.cpp", self.REJECT)
        self.write("tests/rejects/parts.hpp", "#pragma once\nstruct part {};\n")
        said = {(file.name, c): (make_troubleshooting.trimmed(self.OUTPUT, file, reject.errors(self.OUTPUT)[0]), "rule.a: it is `b`") for c in make_troubleshooting.COMPILERS}
        self.write("docs/troubleshooting.md", make_troubleshooting.make(self.root, [file], said))
        return self.root / "docs/troubleshooting.md"

    def test_page(self):
        text = self.page().read_text()
        for part in ("## rule.a", "Why it is so.", "b,\n1\n", "```cpp\nc\n```", "rule.a: it is `b`", 'refusal.hpp: error: t<\n    line{"rule.a: it is    "},\n'):
            self.assertIn(part, text)
        make_troubleshooting.main([str(self.root), "--check"])

    def test_out_of_date(self):
        self.page()
        for old, new in (("    c\n", "    d\n"), ("Why", "How"), ("(b|c)", "(d|e)")):
            self.write("tests/rejects/rule.a.cpp", self.REJECT.replace(old, new))
            with self.subTest(new=new), self.assertRaises(SystemExit):
                make_troubleshooting.main([str(self.root), "--check"])
        self.page()
        self.write("tests/rejects/rule.a-more.cpp", self.REJECT)
        with self.assertRaises(SystemExit):
            make_troubleshooting.main([str(self.root), "--check"])


class Drives(Tree):
    DECODES = "  static constexpr bool decode(const can_frame& f, drive_report& r) noexcept { return f.length == r.length; }\n"
    OF = "template <class M, int N>\nstruct virtual_of<acme2<M, N>> : virtual_acme2<acme2<M, N>> {};\n"
    PLAYED = "template <class M, int N>\nstruct played<hw::acme2<M, N>> {\n  using type = hw::virtual_acme2<hw::acme2<M, N>>;\n};\n"
    FAMILIES = 'inline constexpr const char* families =\n    "mit:MODEL:NUMBER, "\n    "acme2:KP:NUMBER";\n'
    WITH = ('template <class F>\nauto with_drive(const std::string& text, F&& f) {\n  if (p.family == "acme2") {\n'
            "    return f.template operator()<unit_acme2>(acme2_address{p.number}, s);\n  }\n}\n")
    VIRTUAL = "template <class Drive>\nclass virtual_acme2 {\npublic:\n  bool hear(const can_frame&);\n  drive_command law(int);\n  drive_frames answer(int);\n};\n"
    LAWS = '#include "../../laws/drive_laws.hpp"\n\nusing servo = acme2<motor, 1>;\n\nTEST_CASE("acme2: the laws of a drive") {\n  laws::drive<servo>();\n}\n'
    RIGS = ("template <class V>\nstruct rig {};\nstruct ak : rig<virtual_mit<hip>> {};\nstruct acme : rig<virtual_acme2<hip>> {};\n"
            'TEST_CASE_TEMPLATE("the laws", Rig, ak, acme) {\n  laws::virtual_drive<Rig>();\n}\n')
    ROBOT = ("template <int Number>\nusing servo = hw::acme2<motor, Number>;\nusing other = hw::mit_drive<motor, 1>;\n"
             "struct hip : on_bus<oncilla::hip, servo<1>, 0, 4> {};\nstruct knee : on_bus<oncilla::knee, other, 0, 2> {};\n")
    FUZZ = "using drive = acme2<motor, 1>;\nextern \"C\" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {\n  fuzz::hears<drive>(data, size);\n}\n"
    HEADER_ROW, SOURCE_ROW = "| `<cca/hardware/acme2.hpp>` | `acme2<Motor>` |\n", "| Acme 2, firmware 1 | its manual | |\n"
    PAGE = ("# Drives\n\n| header | what |\n|---|---|\n" + HEADER_ROW + "\n| | `mit_drive` | `acme2` |\n|---|---|---|\n| for | AK | ACME |\n"
            "\n| | `virtual_mit` | `virtual_acme2` |\n|---|---|---|\n| moves | after `enter` | at once |\n"
            "\n## Sources, and what is not verified\n\n| | source | not verified |\n|---|---|---|\n" + SOURCE_ROW)
    ASK = "return {question(number)};"
    ADDRESS = ("struct acme2_address {\n  void to_real(can_frame& f) const;\n  bool to_unit(can_frame& f) const;\n"
               "  drive_frames ask() const { " + ASK + " }\n};\n")
    JUDGE = ("template <class D>\nstd::optional<request> read(const can_frame& f) {\n  if constexpr (is_mit<D>) {\n  } else if constexpr (is_acme2<D>) {\n"
             "    r.enables = true;\n  }\n}\n")
    EFFECTS = ("| command | |\n|---|---|\n| `list` | reads a register of an Acme 2 |\n| `enable` | MIT, Acme 2: without torque |\n\n## jog\n\n"
               "| family | mode |\n|---|---|\n| MIT, Acme 2 | gains |\n")
    ADDRESSES, NAMES, HELP = "tools/cca_can/drives/addresses.hpp", "tools/cca_can/drives/drive_name.hpp", "tools/cca_can/commands/help.hpp"
    DRIVE = f"{drives.HARDWARE}/drives/acme2.hpp"

    def codec(self, decodes=DECODES):
        return f"// Why.\n#pragma once\n\ntemplate <class Motor, int Number>\nstruct acme2 {{\n{decodes}}};\n"

    def setUp(self):
        super().setUp()
        self.whole = {
            self.DRIVE: self.codec(),
            f"{drives.HARDWARE}/acme2.hpp": "#include <cca/hardware/drives/acme2.hpp>\n",
            f"{drives.HARDWARE}/virtual_acme2.hpp": "#include <cca/hardware/virtual_drives/virtual_acme2.hpp>\n",
            f"{drives.HARDWARE}/virtual_drives/virtual_acme2.hpp": self.VIRTUAL,
            f"{drives.HARDWARE}/virtual_drives/virtual_of.hpp": "#include <cca/hardware/virtual_drives/virtual_acme2.hpp>\n" + self.OF,
            f"{drives.HARDWARE}/virtual_drives/virtual_drive.hpp": "// Models: virtual_mit.hpp,\n// virtual_acme2.hpp. Laws: a.hpp\n#include <cca/hardware/drives/drive.hpp>\n",
            f"{drives.HARDWARE}/drives/drive.hpp": "// Models: mit.hpp, acme2.hpp. docs/drives.md\n",
            "tests/runtime/hardware/acme2.cpp": self.LAWS,
            "tests/runtime/drive_chain/virtual_drives.cpp": self.RIGS,
            "tests/laws/families_oncilla.hpp": self.ROBOT,
            "tests/fuzz/acme2.cpp": self.FUZZ,
            "tests/fuzz/corpus/acme2/first": "0123456789",
            "docs/drives.md": self.PAGE,
            "docs/README.md": "| | [Drives](drives.md) | MIT, Acme 2: units |\n",
            "README.md": "| | |\n|---|---|\n| drives | MIT, Acme 2 |\n\none families of CAN drives\n",
            "tests/runtime/tool/families.cpp": 'constexpr std::array families{family{"mit:3", ""}, family{"acme2:80:3", ""}};\n',
            "tests/runtime/tool/drives.cpp": 'void f() { same_as_codec<acme2<motor, 3>>("acme2:80:3", [](auto& r) { return 1; }); }\n'
                                           'TEST_CASE("a wrong name gives a message") {\n  CHECK(complaint("mit") == "one of mit:MODEL:NUMBER, "\n    "acme2:KP:NUMBER");\n}\n',
            "tests/fuzz/robot/judge.hpp": self.JUDGE,
            "docs/robots.md": "| drive | follows |\n|---|---|\n| MIT, Acme 2 | all |\n",
            "tools/cca_can/commands.hpp": 'throw usage_error("--ask " + *ask +\n  ": expected some of mit, acme2; an ODrive reports by itself");\n',
            "tools/cca_can/words.hpp": 'known_option{"list", "--ask", "families to ask: mit,acme2"},\n',
            "tools/cca_can/commands/list.hpp": 'say.out << "reports by itself; --ask mit,acme2 asks";\n',
            self.ADDRESSES: "#include <cca/hardware/acme2.hpp>\n" + self.ADDRESS,
            self.NAMES: "#include <cca/hardware/virtual_acme2.hpp>\n" + self.FAMILIES + self.WITH + self.PLAYED,
            self.HELP: 'inline constexpr const char* help_text = R"(  --ask mit,acme2 asks\n\nDRIVE: mit:3, acme2:KP:3\n)";\n',
            "docs/cca_can.md": "| name | drive |\n|---|---|\n| `acme2:80:3` | Acme 2 |\n\n" + self.EFFECTS,
        }
        for name, text in self.whole.items():
            self.write(name, text)

    def found(self):
        return list(drives.problems(self.root))

    def one_hole(self, file, old, new, what):
        """Without `old` the family lacks exactly this."""
        self.assertIn(old, self.whole[file])
        self.write(file, self.whole[file].replace(old, new))
        with self.subTest(file=file, new=new):
            found = self.found()
            self.assertEqual(len(found), 1, found)
            self.assertIn(f"{file}: the drive `acme2` lacks {what}: add ", found[0])
            self.assertRegex(found[0], rf" in {re.escape(file)} \(step [2-7] of How to add a drive in CONTRIBUTING.md\)$")
        self.write(file, self.whole[file])

    def test_whole(self):
        self.assertEqual(self.found(), [])

    def test_each_file_is_needed(self):
        for file, text in self.whole.items():
            if file == self.DRIVE:
                continue
            (self.root / file).unlink()
            with self.subTest(file=file):
                self.assertTrue(self.found())
            self.write(file, "")
            with self.subTest(file=file, empty=True):
                self.assertTrue(self.found())
            self.write(file, text)
        self.assertEqual(self.found(), [])

    def test_step_2(self):
        virtual = f"{drives.HARDWARE}/virtual_drives"
        self.one_hole(f"{drives.HARDWARE}/acme2.hpp", "#include", "// #include", "its short path for programs")
        self.one_hole(f"{drives.HARDWARE}/virtual_acme2.hpp", "#include", "// #include", "the short path of its virtual drive")
        self.one_hole(f"{virtual}/virtual_acme2.hpp", self.VIRTUAL, "template <class Drive> struct virtual_acme2 {};", "its virtual drive")
        for new in ("", f"// {self.OF}".replace("\n", " "), f"/* {self.OF} */", f"#if 0\n{self.OF}#endif\n"):
            self.one_hole(f"{virtual}/virtual_of.hpp", self.OF, new, "the way from it to its virtual drive, which `virtual_robot` takes")

    def test_step_1(self):
        self.write(self.DRIVE, self.codec() + 'auto text = "drive.bad_number: the number";\n')
        says = ("tests/rejects/drive.bad_number-acme2.cpp: the drive `acme2` lacks a mistake for its sentence `drive.bad_number`: add a file that includes "
                "`<cca/hardware/acme2.hpp>` and has the mistake in tests/rejects/drive.bad_number-acme2.cpp (step 1 of How to add a drive in CONTRIBUTING.md)")
        mistake = "// EXPECT: drive\\.bad_number: x\n#include <cca/hardware/acme2.hpp>\n#if CCA_REJECT\n#endif\n"
        self.assertEqual(self.found(), [says])
        for text in (mistake.replace("acme2", "acme"), mistake.replace("CCA_REJECT", "1"), mistake.replace("#include", "// #include")):
            self.write("tests/rejects/drive.bad_number.cpp", text)
            with self.subTest(text=text):
                self.assertEqual(self.found(), [says])
        self.write("tests/rejects/drive.bad_number.cpp", mistake)
        self.assertEqual(self.found(), [])

    def test_steps_3_to_5(self):
        laws, rigs, fuzz = "tests/runtime/hardware/acme2.cpp", "tests/runtime/drive_chain/virtual_drives.cpp", "tests/fuzz/acme2.cpp"
        for old, new in (("  laws::drive<servo>();", ""), ("  laws", "  // laws"), ("acme2<motor, 1>", "mit_drive<motor, 1>"), ("TEST_CASE", "void f")):
            self.one_hole(laws, old, new, "a test of the laws of drives")
        for old, new in ((", acme)", ")"), ("virtual_acme2", "virtual_mit"), (", acme)", ") // acme virtual_acme2<hip>\n"), ("  laws", "  // laws")):
            self.one_hole(rigs, old, new, "a test of the laws of virtual drives")
        for old, new in (("servo<1>", "other"), ("struct hip", "// struct hip"), ("hw::acme2<", "hw::acme<"), (": on_bus<oncilla::hip, servo<1>, 0, 4> {}", "")):
            self.one_hole("tests/laws/families_oncilla.hpp", old, new, "a joint of the robot with all families")
        for old, new in (("  fuzz::hears", "  // fuzz::hears"), ("acme2<motor", "mit_drive<motor")):
            self.one_hole(fuzz, old, new, "a fuzz target of its decoder")
        concept = "template <class D> concept is_acme2 = is_acme2<D>;\n"  # alone it is no branch
        for new in (self.JUDGE.replace("acme2", "acme"), self.JUDGE.replace("} else if", "// } else if"), concept + self.JUDGE.replace("acme2", "acme")):
            self.one_hole("tests/fuzz/robot/judge.hpp", self.JUDGE, new, "what its frames ask for, for the campaign of a whole robot")
        (self.root / "tests/fuzz/corpus/acme2/first").unlink()
        for name, text in ((".keep", "0123456789"), ("first", ""), ("first", "012345")):
            file = self.write(f"tests/fuzz/corpus/acme2/{name}", text)
            with self.subTest(name=name, text=text):
                self.assertEqual(["tests/fuzz/corpus/acme2: the drive `acme2` lacks a first frame for its fuzz target: add a file with a frame of more than 6 bytes in "
                                  "tests/fuzz/corpus/acme2 (step 5 of How to add a drive in CONTRIBUTING.md)"], self.found())
            file.unlink()

    def test_step_6(self):
        page = "docs/drives.md"
        self.one_hole(page, self.HEADER_ROW, "", "its row in the table of headers")
        self.one_hole(page, self.HEADER_ROW, f"\n<!--\n{self.HEADER_ROW}-->\n", "its row in the table of headers")
        self.one_hole(page, self.SOURCE_ROW, "", "its row in the table of sources")
        self.one_hole(page, "its manual", "", "its row in the table of sources")
        self.one_hole(page, "| `acme2` |", "| `acme` |", "its column in the table of drives")
        self.one_hole(page, "| AK | ACME |", "| AK | |", "its column in the table of drives")
        self.one_hole(page, "| `virtual_acme2` |", "| `virtual_acme` |", "its column in the table of virtual drives")
        self.one_hole(page, "| at once |", "| |", "its column in the table of virtual drives")
        self.one_hole(f"{drives.HARDWARE}/drives/drive.hpp", ", acme2.hpp.", ". Not acme2.hpp.", "its name in the list of models")
        self.one_hole(f"{drives.HARDWARE}/virtual_drives/virtual_drive.hpp", "// virtual_acme2.hpp. Laws: a.hpp", "// virtual_acme.hpp.\n#include <virtual_acme2.hpp>",
                      "the name of its virtual drive in the list of models")
        self.one_hole("docs/robots.md", "Acme 2", "Acme 23", "its name in the table of what a drive follows")
        self.one_hole("docs/README.md", "Acme 2", "Acme 23", "its name in the list of pages")
        self.one_hole("README.md", "Acme 2", "Acme 23", "its name in the table of what it works with")
        self.write("README.md", self.whole["README.md"].replace("one families", "two families"))
        self.assertEqual(self.found(), ["README.md: it says `two families of CAN drives`, and there are one: change the word in README.md "
                                        "(step 6 of How to add a drive in CONTRIBUTING.md)"])
        self.write("README.md", "| drives | Acme 2 |\n")  # a README without the figure is whole
        self.assertEqual(self.found(), [])

    def test_step_7(self):
        for new in ("", "// acme2_address", "struct acme2_address {};"):
            self.one_hole(self.ADDRESSES, self.ADDRESS, new, "its address in cca-can")
        for old, new in (("acme2:KP:NUMBER", ""), ('"acme2:KP:NUMBER"', '""  // "acme2:KP:NUMBER"\n')):
            self.one_hole(self.NAMES, old, new, "its row in the list of families of cca-can")
        for new in ("auto with_drive(int) { /* \"acme2\" acme2_address */ }", "auto with_drive(int) {}\nint f() { return acme2_address(\"acme2\"); }"):
            self.one_hole(self.NAMES, self.WITH, new, "its place among the drives of cca-can")
        for new in ("", f"#if 0\n{self.PLAYED}#endif\n", self.PLAYED.replace("virtual_acme2", "virtual_mit")):
            self.one_hole(self.NAMES, self.PLAYED, new, "a drive that cca-can can play")
        self.one_hole("docs/cca_can.md", "of an Acme 2", "", "what the question of `list` does to it")
        self.one_hole("docs/cca_can.md", "MIT, Acme 2: without", "MIT: without", "what `enable` does to it")
        self.one_hole("docs/cca_can.md", "MIT, Acme 2 | gains", "MIT | gains", "how jog moves it")
        for file in ("commands.hpp", "words.hpp", "commands/list.hpp", "commands/help.hpp"):
            old = re.search(r"mit, ?acme2", self.whole[f"tools/cca_can/{file}"])[0]
            self.one_hole(f"tools/cca_can/{file}", old, "mit", "its name among the families that `list --ask` asks")
        for asks in ("return {};", "return hw::drive_frames();"):
            self.write(self.ADDRESSES, self.whole[self.ADDRESSES].replace(self.ASK, asks))
            for file in ("tools/cca_can/commands.hpp", "docs/cca_can.md"):
                self.write(file, re.sub(r", acme2;|an Acme 2", "", self.whole[file]))
            with self.subTest(asks=asks):
                self.assertEqual(self.found(), [])  # it reports by itself
        for file in (self.ADDRESSES, "tools/cca_can/commands.hpp", "docs/cca_can.md"):
            self.write(file, self.whole[file])
        self.one_hole(self.HELP, ", acme2:KP:3", "", "its name in the help of cca-can")
        self.one_hole(self.HELP, ", acme2:KP:3\n)\";", "\n)\";  // acme2:KP:3", "its name in the help of cca-can")
        self.one_hole("docs/cca_can.md", "| `acme2:80:3` | Acme 2 |", "", "its row in the table of drives of cca-can")
        self.one_hole("docs/cca_can.md", "3` | Acme 2 |", "3` | |", "its row in the table of drives of cca-can")
        tool = "tests/runtime/tool"
        for old, new in (('family{"acme2:80:3", ""}', ""), ('family{"acme2', '// family{"acme2'), ("acme2:", "acme23:")):
            self.one_hole(f"{tool}/families.cpp", old, new, "a test that cca-can lists, enables and jogs it")
        for old, new in (("same_as_codec", "// same_as_codec"), ('"acme2:80', '"acme23:80')):
            self.one_hole(f"{tool}/drives.cpp", old, new, "a test that cca-can sends what its codec sends")
        for new in ("", '"acme:KP:NUMBER"', '""); f("acme2:KP:NUMBER"'):
            self.one_hole(f"{tool}/drives.cpp", '"acme2:KP:NUMBER"', new, "its name in the test of a wrong name")

    def test_a_family_is_found_however_it_spells_decode(self):
        (self.root / "tests/fuzz/acme2.cpp").unlink()
        for decodes in ("static constexpr auto decode(frame f) -> bool { return true; }", "constexpr static bool decode(frame f) { return true; }",
                        "static constexpr bool\n  decode(frame f) { return true; }", "[[nodiscard]] static inline constexpr bool decode (frame f) { return true; }",
                        "static bool decode(frame f) { return true; }", "template <class Frame>\n  static constexpr bool decode(Frame f) { return true; }",
                        "static /* why */ constexpr bool decode(frame f);", "enum class e { a };\n  struct request { int i; };\n  static bool decode(frame f);"):
            self.write(self.DRIVE, self.codec(decodes))
            with self.subTest(decodes=decodes):
                self.assertEqual(["tests/fuzz/acme2.cpp: the drive `acme2` lacks a fuzz target of its decoder: add `LLVMFuzzerTestOneInput` with a call of "
                                  "`fuzz::hears<acme2...>` in tests/fuzz/acme2.cpp (step 5 of How to add a drive in CONTRIBUTING.md)"], self.found())
        for other in ("// static constexpr bool decode(frame f)", 'static constexpr auto text = "static bool decode(frame)";', "bool f(frame x) { return decode(x); }"):
            self.write(self.DRIVE, self.codec(other))
            with self.subTest(other=other):
                self.assertIn("there is no family of drives", self.found()[0])

    def test_another_name_of_the_type(self):
        """As of mit.hpp, whose type is mit_drive."""
        for file, text in self.whole.items():
            self.write(file, re.sub(r"\bacme2(?=<| \{\n|`)", "acme2_drive", text))
        self.assertEqual(self.found(), [])

    def test_files_that_cannot_be_read(self):
        folder = self.root / drives.DRIVES
        for make, says in ((lambda file: file.write_bytes(b"// \xff\n"), "byte 4 is not UTF-8: save the file as UTF-8"),
                           (lambda file: file.mkdir(), "this is a folder, and a file of this name is expected: rename the folder"),
                           (lambda file: file.symlink_to("nothing"), "this is a link to a file that does not exist: remove the link, or make the file")):
            file = folder / "odd.hpp"
            make(file)
            with self.subTest(says=says):
                self.assertEqual(self.found(), [f"{drives.DRIVES}/odd.hpp: {says}"])
            file.rmdir() if file.is_dir() else file.unlink()
        (self.root / self.NAMES).write_bytes(b"\xc3")
        self.assertEqual(self.found(), [f"{self.NAMES}: byte 1 is not UTF-8: save the file as UTF-8"])

    def test_utf_8_where_the_machine_has_ascii(self):
        self.write(self.DRIVE, "").write_bytes("// Größe\n".encode() + self.codec().encode())
        plain = {**os.environ, "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0", "LC_ALL": "C"}
        ran = subprocess.run([sys.executable, drives.__file__, str(self.root)], env=plain, capture_output=True, text=True)
        self.assertEqual((ran.stdout, ran.stderr, ran.returncode), (f"each drive is whole; {drives.UNSEEN}\n", "", 0))

    def test_names_are_words_and_no_patterns(self):
        self.write("README.md", self.whole["README.md"].replace("one families", "two families"))
        self.write(f"{drives.DRIVES}/a+b(.hpp", self.codec().replace("acme2", "ab"))
        found = self.found()
        self.assertEqual(len(found), 30)
        self.assertTrue(all("the drive `a+b(` lacks " in one for one in found), found)
        self.write(f"{drives.DRIVES}/a+b(.hpp", "")
        self.write(f"{drives.DRIVES}/acme.2.hpp", self.codec().replace("acme2", "other"))
        self.assertEqual(len(self.found()), 29)

    def test_no_family(self):
        (self.root / self.DRIVE).unlink()
        self.assertIn("there is no family of drives", self.found()[0])


class Temporary(Tree):
    def found(self, text):
        self.write("tests/runtime/a.cpp", text)
        return list(temporary.check(self.root))

    def test_all(self):
        self.assertEqual(self.found('const auto f = fs::temp_directory_path() /\n  ("a" + std::to_string(::getpid()));\n'), [])
        self.assertIn("a.cpp:2: other tests", self.found('int i;\nconst auto f = fs::temp_directory_path() / "a.toml";\n')[0])
        self.assertIn("a.cpp:1: other tests", self.found('std::string f = "/tmp/a.toml";\n')[0])


if __name__ == "__main__":
    unittest.main()
