#!/usr/bin/env python3
"""Runs a program on several ranks, and judges what each of them got.

    ranks.py MPIRUN PROGRAM FOLDER CASE

CASE is one of CASES; PROGRAM is rollouts.cpp. Each rank that came to its end has written all its results to a file. What is
right comes from a run of the program without mpirun. With `same FILE -- WORD...` PROGRAM runs with the WORDs instead, first
without mpirun, then on 1 and 4 ranks; FILE is what it writes, and must have the same bytes each time.
"""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

import machines

NOT_RUN = 77
SILENCE = 2.0  # s, where a rank is lost; the machine may be busy
PATIENCE = 60.0  # s, where none is


class Wrong(Exception):
    pass


def expect(condition, text):
    if not condition:
        raise Wrong(text)


class Bench:
    def __init__(self, mpirun, program, folder):
        self.program, self.folder = program, pathlib.Path(folder)
        # CI is root, and has two cores. The ranks of one machine talk over its memory; MPI's own search for networks is left out.
        self.mpirun = [mpirun, "--oversubscribe", "--allow-run-as-root"]

    def words(self, ranks, silence, scenario, more):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        before = [*self.mpirun, "-n", str(ranks)] if ranks else []
        return [*before, self.program, str(self.folder), str(silence), scenario, *map(str, more)]

    def run(self, ranks, scenario, *more, silence=PATIENCE, code=0, seconds=60):
        """What each rank has written, by rank, and what all have printed. ranks = 0: without mpirun."""
        begin = time.monotonic()
        done = subprocess.run(self.words(ranks, silence, scenario, more), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              errors="replace", timeout=seconds)
        self.seconds = time.monotonic() - begin
        print(done.stdout)
        expect(done.returncode == code, f"{scenario} on {ranks} ranks ended with {done.returncode}, not with {code}")
        expect(not left_over(self.folder), "a process is left over")
        return self.written(), done.stdout

    def written(self):
        return {int(file.name): file.read_text() for file in self.folder.iterdir() if file.name.isdigit()}


def left_over(folder):
    """Processes of this test, a moment after mpirun has ended."""
    for _ in range(50):
        found = []
        for each in pathlib.Path("/proc").iterdir():
            try:
                if each.name.isdigit() and str(folder).encode() in (each / "cmdline").read_bytes().split(b"\0") and int(each.name) != os.getpid():
                    found.append(each.name)
            except OSError:
                pass  # it has ended
        found = [one for one in found if b"ranks.py" not in pathlib.Path(f"/proc/{one}/cmdline").read_bytes()] if found else []
        if not found:
            return []
        time.sleep(0.1)
    return found


def all_same(results, ranks, right):
    expect(sorted(results) == sorted(ranks), f"the ranks {sorted(results)} came to their end, not {sorted(ranks)}")
    for rank, text in sorted(results.items()):
        expect(text == right, f"rank {rank} has other results:\n{text[:2000]}\nright is\n{right[:2000]}")


def bits(bench):
    """The same bits on any number of ranks."""
    for scenario, lines in (("bits", 4 * 97), ("few", 1008)):
        alone, _ = bench.run(0, scenario)
        expect(alone[0].count("\n") >= lines, "the run without mpirun has too few results")
        for ranks in (1, 2, 3, 4):
            all_same(bench.run(ranks, scenario)[0], range(ranks), alone[0])


def killed(bench):
    """A rank that is killed: the others make its runs."""
    alone, _ = bench.run(0, "bits")
    results, printed = bench.run(4, "dies", 2, int(signal.SIGKILL), silence=SILENCE)
    all_same(results, {0, 1, 3}, alone[0])
    expect("rank 2 was ended by signal 9" in printed, "nobody says that it was killed")


def still(bench):
    """A rank that stands still is left out, and its process does not outlive the job."""
    alone, _ = bench.run(0, "bits")
    results, printed = bench.run(4, "dies", 1, int(signal.SIGSTOP), silence=SILENCE)
    all_same(results, {0, 2, 3}, alone[0])
    expect("rank 1 of 4 has been silent for 2 s" in printed, "nobody says that it was silent")


def wakes(bench):
    """A rank that was left out, and goes on later, learns so and ends; what it has changes nothing."""
    alone, _ = bench.run(0, "bits")
    results, printed = bench.run(4, "wakes", 2, silence=SILENCE)
    all_same(results, {0, 1, 3}, alone[0])
    expect("rank 0 has left out this rank" in printed, "it was not told")


def leaves(bench):
    """A rank that ends its program early."""
    alone, _ = bench.run(0, "bits")
    results, printed = bench.run(4, "leaves", 3, silence=SILENCE)
    all_same(results, {0, 1, 2}, alone[0])
    expect("rank 3 of 4 has ended, with exit code 5" in printed, "nobody says that it has ended")


def first(bench):
    """Without rank 0 all end, with a message and an exit code that is not 0."""
    _, printed = bench.run(4, "dies", 0, int(signal.SIGKILL), silence=PATIENCE, code=128 + signal.SIGKILL)
    expect("rank 0 was ended by signal 9 (Killed): the others can't go on without it" in printed, "nobody says why")
    expect(bench.seconds < 20, f"it took {bench.seconds} s")
    expect(not bench.written(), "a rank came to its end")
    _, printed = bench.run(4, "dies", 0, int(signal.SIGSTOP), silence=SILENCE, code=3)
    expect("cca::mpi: rank 0 has been silent for 2 s" in printed, "nobody says why")
    expect(bench.seconds < 20, f"it took {bench.seconds} s")
    expect(not bench.written(), "a rank came to its end")


def steps(bench):
    """Runs in steps, several at once on a thread: the same bits, exceptions and stops; a rank that is killed costs its runs."""
    alone, _ = bench.run(0, "steps")
    expect(alone[0].count("told of each on rank 0") == 9 and "not told" not in alone[0], "not each result is told of")
    expect(alone[0].count("\n") == 3 * (4 * (1 + 3 + 45) + 3), "the run without mpirun has too few results")
    for ranks in (1, 2, 4):
        results, _ = bench.run(ranks, "steps")
        all_same(results, range(ranks), alone[0])
    results, printed = bench.run(4, "steps_die", 2, int(signal.SIGKILL), silence=SILENCE)
    all_same(results, {0, 1, 3}, alone[0])
    expect("rank 2 was ended by signal 9" in printed, "nobody says that it was killed")
    results, _ = bench.run(4, "steps_fail")
    all_same(results, range(4), "run 1 of 1\n" * 2 + "3 results afterwards\n")
    for rank in (0, 3):
        results, _ = bench.run(4, "steps_stop", rank)
        lines = results[0].splitlines()
        expect(lines[0] == "some", f"{lines[0]} were returned")
        all_same(results, range(4), "".join(f"{line}\n" for line in ["some", *(f"run {i}" for i in range(len(lines) - 1))]))


def long(bench):
    """A run, or what a program does between calls, may take longer than the silence: nobody is left out."""
    results, printed = bench.run(3, "long", silence=SILENCE)
    all_same(results, range(3), "0\n1\n2\n3\n4\n" * 2)
    expect("left out" not in printed, "somebody was left out")


def errors(bench):
    """What is thrown anywhere is thrown everywhere."""
    results, _ = bench.run(4, "fails")
    all_same(results, range(4), "run 1 of 1\n" * 2 + "3 results afterwards\n")
    results, _ = bench.run(4, "settings")
    all_same(results, range(4), "told of 400\nasked of 400\ncca::mpi: rollouts is called within a run, or from two threads at once\n"
                                "3 results afterwards\n")
    results, _ = bench.run(4, "differ")
    all_same(results, range(4), "cca::mpi: rank 1 asks for 12 runs that return `int` where rank 0 makes 13 runs that return `int`: "
                                "all ranks must make the same calls, with the same numbers\n")


def stops(bench):
    """If one rank is to stop, all do, with the same results: those before the first that is missing."""
    for rank in (0, 3):
        results, _ = bench.run(4, "stops", rank)
        lines = results[0].split()
        expect(lines[0] == "some", f"{lines[0]} were returned")
        all_same(results, range(4), "".join(f"{line}\n" for line in ["some", *(str(3 * i) for i in range(len(lines) - 1))]))


def interrupted(bench):
    """Ctrl-C reaches mpirun alone; all ranks write what they have."""
    bench.mpirun += ["--mca", "odls_base_sigkill_timeout", "3"]  # the machine may be busy
    program = subprocess.Popen(bench.words(4, PATIENCE, "interrupted", []), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                               start_new_session=True)
    for _ in range(4):
        while "at work" not in (line := program.stdout.readline()):
            expect(line, "it ended by itself")
    time.sleep(1)
    program.send_signal(signal.SIGINT)
    printed, _ = program.communicate(timeout=30)
    print(printed)
    expect(program.returncode not in (0, None), "its exit code is 0")
    expect(not left_over(bench.folder), "a process is left over")
    results = bench.written()
    expect(results.get(0, "").endswith(" results\n") and int(results[0].split()[0]) > 5, f"rank 0 has written {results.get(0)!r}")
    all_same(results, range(4), results[0])


def two_machines(bench):
    """Over a network: the same bits; a rank that is killed there; a machine that is cut off."""
    if not machines.are_allowed():
        print("there is no right to make network namespaces")
        sys.exit(NOT_RUN)
    alone, _ = bench.run(0, "bits")
    pair = machines.Machines(bench.folder)
    before, options = pair.words()
    bench.mpirun = [*before, *bench.mpirun, *options]
    try:
        all_same(bench.run(4, "bits")[0], range(4), alone[0])
        results, _ = bench.run(4, "dies", 3, int(signal.SIGKILL), silence=SILENCE)
        all_same(results, range(3), alone[0])
        program = subprocess.Popen(bench.words(4, SILENCE, "slow", []), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        while "at work" not in (line := program.stdout.readline()):
            expect(line, "it ended by itself")
        pair.cut()
        for _ in range(300):
            if {0, 1} <= set(bench.written()):
                break
            time.sleep(0.1)
        all_same({rank: text for rank, text in bench.written().items() if rank < 2}, range(2), alone[0])
        program.kill()  # it waits for the machine that is cut off, for minutes
        program.wait()
    finally:
        pair.end()
        for pid in left_over(bench.folder):
            os.kill(int(pid), signal.SIGKILL)


CASES = {f.__name__: f for f in (bits, killed, still, wakes, leaves, first, steps, long, errors, stops, interrupted, two_machines)}


def same(bench, file, words):
    contents = []
    for ranks in (0, 1, 4):
        pathlib.Path(file).unlink(missing_ok=True)
        before = [*bench.mpirun, "-n", str(ranks)] if ranks else []
        done = subprocess.run([*before, bench.program, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300)
        print(f"on {ranks} ranks:\n{done.stdout}")
        expect(done.returncode == 0, f"on {ranks} ranks it ended with {done.returncode}")
        expect(done.stdout.count("written to") == 1, "it is not one rank that prints")
        contents.append(pathlib.Path(file).read_bytes())
        expect(contents[0] and contents[-1] == contents[0], f"on {ranks} ranks it has written another file")


def main():
    mpirun, program, folder, case, *more = sys.argv[1:]
    bench = Bench(mpirun, program, folder)
    try:
        if case == "same":
            same(bench, more[0], more[2:])
        else:
            CASES[case](bench)
    except (Wrong, subprocess.TimeoutExpired) as e:
        sys.exit(f"{case}: {e}")
    print(f"{case}: as it must be")


if __name__ == "__main__":
    main()
