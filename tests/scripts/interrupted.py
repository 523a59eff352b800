#!/usr/bin/env python3
"""Sends a signal to a program in the middle of its work: it must end in order, with its files written.

    interrupted.py [--says TEXT]... SIGINT 130 [FILE...] -- PROGRAM [ARGUMENT...]

Exit code 0: the program ended with this code, each file exists and is not empty, and the program has printed each TEXT.
The signal is sent once the program catches it (/proc/PID/status), so a slow machine changes nothing.
"""
import os
import signal
import subprocess
import sys
import time


def catches(pid, number):
    with open(f"/proc/{pid}/status") as status:
        for line in status:
            if line.startswith("SigCgt:"):
                return int(line.split()[1], 16) >> (number - 1) & 1
    return 0


def main():
    words, command = sys.argv[1:sys.argv.index("--")], sys.argv[sys.argv.index("--") + 1:]
    expected = []
    while words[0] == "--says":
        expected.append(words[1])
        words = words[2:]
    number, code, files = getattr(signal, words[0]), int(words[1]), words[2:]
    for file in files:
        if os.path.exists(file):
            os.remove(file)
    program = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    while program.poll() is None and not catches(program.pid, number):
        time.sleep(0.05)
    time.sleep(0.5)  # it is at work
    if program.poll() is not None:
        return f"it ended by itself, with {program.returncode}:\n{program.stdout.read()}"
    program.send_signal(number)
    try:
        printed, _ = program.communicate(timeout=120)
    except subprocess.TimeoutExpired:
        program.kill()
        return "it did not end within two minutes"
    print(printed, end="")
    if program.returncode != code:
        return f"it ended with {program.returncode}, not with {code}"
    for file in files:
        if not os.path.exists(file) or os.path.getsize(file) == 0:
            return f"{file} is not written"
    for text in expected:
        if text not in printed:
            return f"it did not say: {text}"
    return None


if __name__ == "__main__":
    sys.exit(main())
