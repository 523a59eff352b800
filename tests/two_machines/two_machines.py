#!/usr/bin/env python3
"""Runs two programs on two machines: network namespaces with a virtual cable between them, see cable.cpp.

    two_machines.py [OPTION...] CABLE -- PROGRAM [WORD...] -- PROGRAM [WORD...]

The first program runs at 10.77.0.1, the second at 10.77.0.2; ROBOT and MIND in their words are these addresses. Both must end
by themselves with exit code 0; what they print is printed here, too.

    --loss %, --delay MS, --jitter MS, --twice %   of the cable
    --cut TEXT      cuts the cable when the first program has printed a line with TEXT, for a second
    --after S       that many seconds after that line (0.5)
    --go-on TEXT    after the cut the first program must print a line with TEXT; then it gets a line, and must end
    --within S      TEXT must come within so many seconds after the cut
    --seconds S     the most that all may take (120)

Without the right to make namespaces it says so and ends with 77.
"""
import argparse
import contextlib
import faulthandler
import os
import pathlib
import queue
import re
import subprocess
import sys
import threading
import time

MACHINES = {"a": "10.77.0.1", "b": "10.77.0.2"}
NOT_RUN = 77


def new_namespace():
    """The words before a command that runs in a network of its own; None if this machine does not allow that."""
    for words in (["unshare", "--net"], ["unshare", "--user", "--map-root-user", "--net"]):
        if subprocess.run(words + ["true"], stderr=subprocess.DEVNULL).returncode == 0:
            return words
    return None


def call(*words):
    subprocess.run(words, check=True)


class Machine:
    """A network of its own, with one end of the cable in it. It is gone when its process is, and that ends with this one,
    however this one ends: it waits for the end of a pipe, and holds nothing else. A test ends when its output is closed."""

    def __init__(self, name):
        self.holder = subprocess.Popen(["unshare", "--net", "cat"], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
        own = os.readlink("/proc/self/ns/net")
        while os.readlink(f"/proc/{self.holder.pid}/ns/net") == own:
            if self.holder.poll() is not None:
                sys.exit(f"no network for a machine: unshare ended with {self.holder.returncode}")
            time.sleep(0.01)
        self.inside = ["nsenter", "--net", "--target", str(self.holder.pid), "--"]
        end, other = f"end_{name}", f"cable_{name}"
        call("ip", "link", "add", end, "type", "veth", "peer", "name", other)
        call("ip", "link", "set", end, "netns", str(self.holder.pid))
        call("ip", "link", "set", other, "up")
        call(*self.inside, "ip", "link", "set", "lo", "up")
        call(*self.inside, "ip", "address", "add", MACHINES[name] + "/24", "dev", end)
        call(*self.inside, "ip", "link", "set", end, "up")
        self.port, self.cable = end, other

    def start(self, words):
        words = [MACHINES["a"] if w == "ROBOT" else MACHINES["b"] if w == "MIND" else w for w in words]
        return subprocess.Popen(self.inside + words, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True)

    def end(self):
        self.holder.kill()
        self.holder.wait()


class Lines:
    """What a program prints, line by line."""

    def __init__(self, name, program):
        self.all, self.new = [], queue.Queue()
        self.thread = threading.Thread(target=self.read, args=(name, program), daemon=True)
        self.thread.start()

    def read(self, name, program):
        for line in program.stdout:
            print(f"{name}: {line}", end="", flush=True)
            self.all.append(line)
            self.new.put(line)
        self.new.put(None)

    def wait_for(self, text, until):
        """The next line with this text; None if the program ends or the time is over."""
        while True:
            try:
                line = self.new.get(timeout=max(0, until - time.monotonic()))
            except queue.Empty:
                return None
            if line is None or text in line:
                return line


def seconds_in(line):
    return float(re.search(r"at ([0-9.]+) s", line)[1])


def cut_and_mend(o, cable, cable_lines, robot, lines, until):
    """The partition. Returns the problems."""
    if not lines.wait_for(o.cut, until):
        return [f"no line with `{o.cut}` came"]
    time.sleep(o.after)
    cable.stdin.write("cut\n")
    cable.stdin.flush()
    cut = seconds_in(cable_lines.wait_for("cut", until))
    time.sleep(1)
    cable.stdin.write("mend\n")
    cable.stdin.flush()
    if not o.go_on:
        return []
    told = lines.wait_for(o.go_on, until)
    if not told:
        return [f"no line with `{o.go_on}` came"]
    passed = seconds_in(told) - cut
    print(f"{o.go_on}: {passed:.3f} s after the cable was cut", flush=True)
    time.sleep(1.5)  # so the cable is whole again
    robot.stdin.write("\n")
    robot.stdin.flush()
    return [] if 0 <= passed <= o.within else [f"that is not within {o.within} s"]


def where_it_stands(program):
    """Of a program that does not end: what each of its threads waits for in the kernel."""
    threads = []
    for thread in pathlib.Path(f"/proc/{program.pid}/task").glob("*"):
        with contextlib.suppress(OSError):  # it has just ended
            state = (thread / "stat").read_text().rsplit(")", 1)[1].split()[0]
            threads.append(f"{(thread / 'comm').read_text().strip()} {state} {(thread / 'wchan').read_text()}")
    return ", ".join(threads)


def run_inside(o, commands):
    faulthandler.dump_traceback_later(o.seconds + 30, exit=True)
    with contextlib.ExitStack() as at_end:
        call("ip", "link", "set", "lo", "up")
        machines = {}
        for name in MACHINES:
            machines[name] = Machine(name)
            at_end.callback(machines[name].end)
        for machine in machines.values():
            call(*machine.inside, o.cable, "--checksums", machine.port)
        words = [o.cable] + [machine.cable for machine in machines.values()]
        for option in ("loss", "delay", "jitter", "twice"):
            words += [f"--{option}", str(getattr(o, option))]
        cable = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        cable_lines = Lines("cable", cable)
        at_end.callback(cable_lines.thread.join)
        at_end.callback(cable.wait)
        at_end.callback(cable.stdin.close)
        programs, lines = [], []
        for name, machine, command in zip(("robot", "mind"), machines.values(), commands):
            programs.append(machine.start(command))
            lines.append(Lines(name, programs[-1]))
            at_end.callback(lines[-1].thread.join)
            at_end.callback(programs[-1].kill)
        until, problems = time.monotonic() + o.seconds, []
        if o.cut:
            problems += cut_and_mend(o, cable, cable_lines, programs[0], lines[0], until)
        for name, program in zip(("robot", "mind"), programs):
            try:
                if program.wait(timeout=max(0, until - time.monotonic())) != 0:
                    problems.append(f"the {name}'s program ended with {program.returncode}")
            except subprocess.TimeoutExpired:
                problems.append(f"the {name}'s program did not end within {o.seconds} s: {where_it_stands(program)}")
    return problems


def main():
    split = [i for i, word in enumerate(sys.argv) if word == "--"]
    if len(split) != 2:
        sys.exit(__doc__)
    commands = [sys.argv[split[0] + 1:split[1]], sys.argv[split[1] + 1:]]
    parser = argparse.ArgumentParser(add_help=False)
    for option in ("loss", "delay", "jitter", "twice"):
        parser.add_argument(f"--{option}", type=float, default=0)
    parser.add_argument("--cut")
    parser.add_argument("--after", type=float, default=0.5)
    parser.add_argument("--go-on")
    parser.add_argument("--within", type=float, default=1)
    parser.add_argument("--seconds", type=float, default=120)
    parser.add_argument("--inside", action="store_true")
    parser.add_argument("cable")
    o = parser.parse_args(sys.argv[1:split[0]])
    if not o.inside:
        words = new_namespace()
        if words is None:
            print("NOT RUN: this machine does not allow network namespaces, neither to this user nor in a user namespace of "
                  "its own.\nRun it as root, or allow `unshare --user --net` (kernel.unprivileged_userns_clone=1).")
            return NOT_RUN
        script = str(pathlib.Path(__file__).resolve())
        os.execvp(words[0], words + [sys.executable, script, "--inside", *sys.argv[1:]])
    problems = run_inside(o, commands)
    print("\n".join(problems) or "both ended in order")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
