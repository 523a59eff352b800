#!/usr/bin/env python3
"""How short a beat may be between two machines: runs beats.cpp over the cable for each beat, delay and loss, and prints the
table of docs/two_machines.md.

    beats.py CABLE PROGRAM [--way MS] [--jitter MS] [--beats N] [--delays N...] [--ms MS...] [--losses %...]

It takes about ten minutes. Where the machine does other things as well, run it by `chrt --fifo 10`: these wall-clock runs
need a small part of a core.
"""
import argparse
import pathlib
import re
import subprocess
import sys

SCRIPT = pathlib.Path(__file__).resolve().parent / "two_machines.py"


def late_beats(o, delay, ms, loss):
    """Of 100: how many were late, and the longest row of late ones."""
    options = ["--loss", loss, "--delay", o.way, "--jitter", o.jitter, "--seconds", 60]
    words = [delay, ms, o.beats] + (["--loses"] if loss > 0 else [])
    command = [sys.executable, SCRIPT, *options, o.cable, "--", o.program, "robot", "ROBOT", "MIND", *words,
               "--", o.program, "mind", "MIND", "ROBOT", *words]
    ran = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    found = re.search(r"(\d+) of (\d+) beats late, at most (\d+) in a row", ran.stdout)
    if ran.returncode != 0 or not found:
        return "failed"
    late, of, row = (int(number) for number in found.groups())
    return "0" if late == 0 else f"{100 * late / of:.1f} % ({row})"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cable")
    parser.add_argument("program")
    parser.add_argument("--way", type=float, default=0.2)
    parser.add_argument("--jitter", type=float, default=0.1)
    parser.add_argument("--beats", type=int, default=900)
    parser.add_argument("--delays", type=int, nargs="+", default=[1, 2, 3, 4, 5])
    parser.add_argument("--ms", type=float, nargs="+", default=[10, 5, 2, 1])
    parser.add_argument("--losses", type=float, nargs="+", default=[0, 1, 5])
    o = parser.parse_args()
    print("| loses | beats of |" + "".join(f" `delayed<{n}>` |" for n in o.delays))
    print("|---|---|" + "---|" * len(o.delays))
    for loss in o.losses:
        for ms in o.ms:
            cells = [late_beats(o, delay, ms, loss) for delay in o.delays]
            print(f"| {loss:g} % | {ms:g} ms | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
