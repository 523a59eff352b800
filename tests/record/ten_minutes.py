#!/usr/bin/env python3
"""Ten minutes at 1 kHz on the wall clock, all of it recorded: no beat may be lost. Run it by hand; it takes a quarter of an hour.

usage: ten_minutes.py PROGRAM FILE.mcap [SECONDS]     (build/test/examples/trot, on a disk with 4 GB)

Says how busy the machine was, and replays the file: every sample is there and is compared.
"""
import os
import pathlib
import re
import resource
import subprocess
import sys
import time

FLAT = pathlib.Path(__file__).resolve().parents[2] / "examples/trot/trot.toml"


def busy_and_all():
    """Seconds of all cores since the machine began: not idle, and all."""
    numbers = [int(n) for n in open("/proc/stat").readline().split()[1:9]]
    return (sum(numbers) - numbers[3] - numbers[4]) / os.sysconf("SC_CLK_TCK"), sum(numbers) / os.sysconf("SC_CLK_TCK")


def main():
    program, file = sys.argv[1], pathlib.Path(sys.argv[2])
    seconds = float(sys.argv[3]) if len(sys.argv) > 3 else 600
    busy, whole = busy_and_all()
    began = time.monotonic()
    done = subprocess.run([program, "--seconds", str(seconds), "--terrain", "flat", "--pace", "wall-clock", "--config", str(FLAT),
                           "--record", str(file)], capture_output=True, text=True)
    taken = time.monotonic() - began
    own = resource.getrusage(resource.RUSAGE_CHILDREN)
    busy_after, whole_after = busy_and_all()
    of_others = busy_after - busy - own.ru_utime - own.ru_stime
    print(done.stdout[-1500:] + done.stderr)
    print(f"{seconds:.0f} s of virtual time in {taken:.0f} s; {file.stat().st_size / 1e6:.0f} MB; "
          f"this program used {(own.ru_utime + own.ru_stime) / taken:.2f} cores, others {of_others / taken:.2f} "
          f"of {(whole_after - whole) / taken:.1f}", flush=True)
    if done.returncode != 0 or "lost" in done.stderr:
        sys.exit(f"exit code {done.returncode}")
    replayed = subprocess.run([program, "--replay", str(file)], capture_output=True, text=True)
    print(replayed.stdout + replayed.stderr)
    beats = re.search(r"samples of (\d+) beats, bit for bit as recorded\n$", replayed.stdout)
    if not beats or int(beats[1]) < seconds * 1000:
        sys.exit("the replay does not have all beats")
    file.unlink()


if __name__ == "__main__":
    main()
