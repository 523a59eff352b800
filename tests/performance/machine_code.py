#!/usr/bin/env python3
"""Checks that a beat which can't be traced, or that nobody traces or records, has no code for it.

usage: machine_code.py FILE -- COMPILER [FLAGS...]

FILE (traced_beats.cpp) has one graph three times. The beat of `as_it_is` and the usual beat of `with_both` must be the same
instructions; neither calls a trace. The beat of `with_trace` calls it for each firing. In the same way `plain_modes` and
`seen_modes`, a mode of a set, and `plain_split` and `seen_split`, an environment of a deployment.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

FIRINGS = 7  # sense, act and five components
WANTED = {"as_it_is": r"controller<as_it_is>::advance\(\)|controllerI8as_it_isE7advanceE",
          "with_trace": r"controller<with_trace>::advance\(\)|controllerI10with_traceE7advanceE",
          "with_both": r"controller<with_both>::advance_unseen\(\)",
          "plain_modes": r"controller<plain_modes>::advance_in<0, cca::detail::mode_part<plain_modes, 0> ?>\(\)",
          "seen_modes": r"controller<seen_modes>::advance_in<0, cca::detail::mode_part<seen_modes, 0> ?>\(\)",
          "plain_split": r"environment_loop<plain_split, 0>::run_unseen\(\)",
          "seen_split": r"environment_loop<seen_split, 0>::run_unseen\(\)"}
PAIRS = (("as_it_is", "with_both"), ("plain_modes", "seen_modes"), ("plain_split", "seen_split"))


def functions(listing):
    """The instructions and relocations of each function."""
    found, name = {}, None
    for line in listing.splitlines():
        if head := re.match(r"<(.*)>:$", line):
            name = head[1]
            found[name] = []
        elif name and line.strip():
            found[name].append(line.strip())
    return found


def plain(lines, function, graph):
    """Without what only names: the function, the graph, labels of constants, places in the file."""
    text = "\n".join(lines).replace(function, "FUNCTION").replace(graph, "GRAPH")
    text = re.sub(r"[#].*", "", text)
    text = re.sub(r"\.(L|rodata|text|data)[\w.]*", "LABEL", text)
    text = re.sub(r"LABEL[-+]0x[0-9a-f]+", "LABEL", text)
    return [re.sub(r"\s+", " ", line).strip() for line in text.splitlines()]


def main():
    split = sys.argv.index("--")
    file, command = sys.argv[1], sys.argv[split + 1:]
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder) / "beats.o"
        subprocess.run([*command, "-c", file, "-o", str(made)], check=True)
        listing = subprocess.run(["objdump", "-drC", "--no-show-raw-insn", "--no-addresses", str(made)], check=True, capture_output=True, text=True).stdout
    beats, all_functions = {}, functions(listing)
    for graph, pattern in WANTED.items():
        names = [name for name in all_functions if re.search(pattern, name) and "cold" not in name]
        if len(names) != 1:
            sys.exit(f"{graph}: {len(names)} beats in the disassembly")
        beats[graph] = (names[0], all_functions[names[0]])
    same = []
    for one, other in PAIRS:
        left_lines, right_lines = (plain(beats[graph][1], beats[graph][0], graph) for graph in (one, other))
        for number, (left, right) in enumerate(zip(left_lines, right_lines)):
            if left != right:
                sys.exit(f"{one}, instruction {number}: `{left}` is `{right}` in the beat of {other} that nobody traces or records")
        if len(left_lines) != len(right_lines):
            sys.exit(f"{one}: {len(left_lines)} instructions are {len(right_lines)} in the beat of {other} that nobody traces or records")
        same.append(str(len(left_lines)))
    hooks = {graph: [line for line in lines if "trace_track::" in line] for graph, (_, lines) in beats.items()}
    for graph in (graph for pair in PAIRS for graph in pair):
        if hooks[graph]:
            sys.exit(f"{graph}: calls a trace: {hooks[graph][0]}")
    fired = sum("trace_track::fired" in line for line in hooks["with_trace"])
    cold = sum("trace_track::fired" in line for name, lines in all_functions.items() if "with_trace" in name and "cold" in name for line in lines)
    if fired + cold < FIRINGS:
        sys.exit(f"with_trace: {fired + cold} hooks, expected {FIRINGS}")
    print(f"{', '.join(same)} instructions and relocations are the same; the traceable beat has {len(beats['with_trace'][1])}")


if __name__ == "__main__":
    main()
