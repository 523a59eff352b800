#!/usr/bin/env python3
"""What parameters cost to compile: writes the table of docs/parameters.md, and the two sentences below it. Some minutes.

usage: parameters.py [ROOT of the repository]

Seconds of the processor at -O2: the least of several compilations, and the most memory of them.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
ROOT = ROOT.parent.parent if ROOT.is_file() else ROOT
COMPILERS = {"g++ 12": "g++", "clang 19": "clang++-19"}
FLAGS = ["-std=c++20", "-O2", "-I", str(ROOT / "include"), "-isystem", "/usr/include/eigen3", "-DTOML_HEADER_ONLY=0", "-DTOML_SHARED_LIB=1"]
COMPILED = "#define CCA_COMPILED_CONFIG\n"  # as the target cca::config does
TIMES, MANY = 5, 10

SPACE = "#include <cca/space/domain.hpp>\n#include <cca/space/sample.hpp>\n"
MACROS = SPACE + "#include <cca/base/reflect.hpp>\n"
PARAMETERS = MACROS + "#include <cca/component/parameters.hpp>\n"
ROWS = {"Eigen and `cca/space`": SPACE,
        "and the struct macros of Hana": MACROS,
        "and `cca/component/parameters.hpp`": PARAMETERS,
        "and `cca/config.hpp`, from the target `cca::config`": COMPILED + PARAMETERS + "#include <cca/config.hpp>\n",
        "the same, all in headers (`CCA_COMPILED=OFF`)": PARAMETERS + "#include <cca/config.hpp>\n"}


def components(count):
    """So many components, each with a struct of 6 fields, and a graph of them."""
    text = "#include <cca/cca.hpp>\n#include <cca/config.hpp>\nstruct turns : cca::space<cca::joint_angles, cca::axes<cca::x>, cca::rate<1000>> {};\n"
    for i in range(count):
        fields = ", ".join(f"(cca::bounded<double, 0, {k}>, {name}{i})" for k, name in enumerate("abcdef", 1))
        text += f"struct c{i} {{\n  struct parameters {{ BOOST_HANA_DEFINE_STRUCT(parameters, {fields}); }};\n  parameters p{{}};\n" \
                f"  auto process(cca::beat) -> cca::out<\"y\", turns> {{ return p.a{i} + p.f{i}; }}\n}};\n"
    nodes = ", ".join(f'cca::node<"n{i}", c{i}>' for i in range(count))
    return text + f"struct all : cca::graph<{nodes}> {{}};\n"


def runs(count, files):
    return components(count) + "int main() {\n  cca::controller<all> c;\n" + \
        ('  c.load("a.toml"), c.save("b.toml");\n' if files else "  c.load();\n") + "}\n"


def structs(count):
    fields = ", ".join(f"(double, {name})" for name in "abcdef")
    return PARAMETERS + "".join(f"struct p{i} {{ BOOST_HANA_DEFINE_STRUCT(p{i}, {fields}); }};\n" for i in range(count))


def once(compiler, source):
    child = subprocess.Popen([compiler, *FLAGS, "-c", str(source), "-o", "/dev/null"])
    _, status, usage = os.wait4(child.pid, 0)
    if status:
        sys.exit(f"{source} does not compile with {compiler}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def cost(compiler, text, times=TIMES):
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "one.cpp"
        source.write_text(text)
        seconds, megabytes = zip(*(once(compiler, source) for _ in range(times)))
    return min(seconds), max(megabytes)


def main():
    table = {what: [cost(c, text) for c in COMPILERS.values()] for what, text in ROWS.items()}
    lines = ["| header | " + " | ".join(COMPILERS) + " |", "|---|---|---|"]
    lines += [f"| {what} | " + " | ".join(f"{s:.2f} s, {mb:.0f} MB" for s, mb in both) + " |" for what, both in table.items()]
    each, of_files, first, in_headers = [], [], [], []
    for c in COMPILERS.values():
        each.append(1000 * (cost(c, structs(MANY))[0] - cost(c, structs(0))[0]) / MANY)
        of_one, of_many = (cost(c, COMPILED + runs(n, True), 3)[0] - cost(c, COMPILED + runs(n, False), 3)[0] for n in (1, 1 + MANY))
        first.append(of_one)
        of_files.append(1000 * (of_many - of_one) / MANY)
        in_headers.append(cost(c, runs(1, True), 3)[0] - cost(c, runs(1, False), 3)[0])
    g, clang = range(2)
    lines += ["",
              f"Each struct `parameters` with 6 fields adds {each[g]:.0f} ms on g++ and {each[clang]:.0f} ms on clang, most of it for the macro; "
              f"`load(file)` and `save(file)` add {of_files[g]:.0f} and {of_files[clang]:.0f} ms for each.",
              f"The first `load(file)` or `save(file)` in a source file costs {first[g]:.2f} s on g++ and {first[clang]:.2f} s on clang more, for functions that all components share; "
              f"{in_headers[g]:.2f} and {in_headers[clang]:.2f} s where [all is in headers](compile_time.md#what-is-compiled-once)."]
    page = ROOT / "docs/parameters.md"
    text = page.read_text()
    begin = text.index("| header | g++")
    page.write_text(text[:begin] + "\n".join(lines) + "\n")
    print("\n".join(lines))


main()
