#!/usr/bin/env python3
"""Disassembles beats and fails if a beat calls anything but, in the graph with a simulated robot, the simulator.

    calls.py <compiler> [flags...]

Checks small.cpp, the skeletons, the trot with the simulated robot, and a chain, a fan-out and a graph of mixed rates of 30 nodes.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

import generate

HERE = pathlib.Path(__file__).resolve().parent
INCLUDES = ["-isystem", "/usr/include/eigen3", "-I", str(HERE.parent / "include"), "-I", str(HERE.parent / "robots/include"), "-I", str(HERE.parent / "sim/include"), "-I", str(HERE),
            "-DCCA_COMPILED_SIM"]  # as in a project with CMake: the simulator is a library, so the beat holds none of its code
# Of the library's own functions: angles beyond 1.6 million rad, those more than a turn outside their range, remainders of large quotients;
# and what clang calls where one of them could throw.
FAR = {"cca::math::detail::far_sine_and_cosine(double)", "cca::detail::wrap_far_turn(double)", "cca::detail::wrap_far_signed(double)",
       "cca::math::detail::long_remainder(double, double)", "__clang_call_terminate"}
# The simulator: its node with the servos, the world that it calls (a library), and what of these is inlined into the beat; what runs
# once the robot has faulted, or instead of a beat while it is stopped. objdump can't read names with strings as template arguments.
SIMULATOR = re.compile(r"^cca::sim::(world|robot_world|push_plan|detail::simulated_robot_of<.*>)::|^_ZNK?3cca3sim6detail18simulated_robot_of|^cca::robots::joint_servo::|^cca::sim::refuse_number\("
                       # The gait's own functions, which it calls with numbers: clang leaves them, and inlined they cost it a tenth more.
                       r"|^trot::gait::(sweep|flexion)\("
                       r"|^memset$|^std::__throw_out_of_range_fmt\(|^__cxa_|^_Unwind_Resume$|^__clang_call_terminate$|^std::terminate\(\)$"
                       r"|^cca::detail::(loop_host|component_host)<.*>::(fail\(cca::detail::beat_outcome|idle\()|cca::detail::note_missed<")
SIMULATED = HERE / "oncilla_beat.cpp"
# The functions of the beat. The compilers inline a small advance() into step(), and that into the `beat` of a source. objdump can't
# read the name that clang gives to an advance() with a `requires`.
BEAT = re.compile(r"controller<.*>::(advance|step)\(\)|^beat\(|^_ZN3cca10controllerI.*E7advanceEvQ")


def calls(listing):
    """Yields (function, called function) for the functions of the beat. In an object file the relocation names the called function."""
    function, waits = None, False
    for line in listing.splitlines():
        head = re.match(r"(?:[0-9a-f]+ )?<(.*)>:$", line)
        if head:
            function = head[1]
            continue
        if not function or not BEAT.search(function):
            continue
        if waits and (relocation := re.search(r"R_X86_64_(?:PLT32|PC32|GOTPCRELX?)\s+(.*?)(?:-0x[0-9a-f]+)?$", line)):
            if not relocation[1].startswith(".text"):
                yield function, relocation[1]
        waits = bool(re.search(r"\s(call|jmp)\s", line))
        if waits and re.search(r"\scall\s+\*", line):
            yield function, "a pointer: " + line.split("call")[1].strip()


def bad_calls(compiler, flags, source, work):
    done = subprocess.run([compiler, "-std=c++20", *flags, *INCLUDES, "-c", str(source), "-o", str(work / "beat.o")], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stderr[:3000])
    listing = subprocess.run(["objdump", "-dr", "-C", "--no-show-raw-insn", str(work / "beat.o")], capture_output=True, text=True, check=True).stdout
    if not any(BEAT.search(name) for name in re.findall(r"<(.*)>:", listing)):
        sys.exit(f"{source.name}: no beat in the disassembly")
    return sorted({called for _, called in calls(listing) if called not in FAR and not BEAT.search(called)
                   and not (source == SIMULATED and SIMULATOR.search(called))})


def main():
    compiler, flags = sys.argv[1], sys.argv[2:] or ["-O2"]
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        sources = [HERE / "small.cpp", HERE / "skeleton_beats.cpp", SIMULATED]
        for shape in generate.SHAPES:
            sources.append(work / f"{shape}.cpp")
            sources[-1].write_text(generate.source(shape, 30, only_graph=True))
        for source in sources:
            bad = bad_calls(compiler, flags, source, work)
            print(f"{source.stem}: {'calls ' + '; '.join(bad) if bad else 'calls nothing' + (' but the simulator' if source == SIMULATED else '')}")
            failed |= bool(bad)
    sys.exit(failed)


if __name__ == "__main__":
    main()
