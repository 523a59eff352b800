"""Two machines for mpirun: network namespaces with a host name of their own, and a cable between them."""
import os
import pathlib
import stat
import subprocess
import time

ADDRESSES = {"first": "10.77.1.1", "second": "10.77.1.2"}


def are_allowed():
    return subprocess.run(["unshare", "--net", "--uts", "true"], stderr=subprocess.DEVNULL).returncode == 0


class Machines:
    """Each ends with its process, which waits for the end of a pipe: so it is gone however this program ends."""

    def __init__(self, folder):
        self.holders = {name: subprocess.Popen(["unshare", "--net", "--uts", "cat"], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
                        for name in ADDRESSES}
        own = os.readlink("/proc/self/ns/uts")  # the last that unshare makes new
        for holder in self.holders.values():
            while os.readlink(f"/proc/{holder.pid}/ns/uts") == own:
                time.sleep(0.01)
        pids = [str(holder.pid) for holder in self.holders.values()]
        subprocess.run(["ip", "link", "add", "cable", "netns", pids[0], "type", "veth", "peer", "name", "cable", "netns", pids[1]], check=True)
        for name, address in ADDRESSES.items():
            for words in (["hostname", name], ["ip", "link", "set", "lo", "up"], ["ip", "address", "add", f"{address}/24", "dev", "cable"],
                          ["ip", "link", "set", "cable", "up"]):
                subprocess.run([*self.inside(name), *words], check=True)
        # Stands for ssh: mpirun calls it with an address and a command.
        self.agent = pathlib.Path(folder).with_suffix(".agent")
        cases = "".join(f"{address}) exec {' '.join(self.inside(name))} /bin/sh -c \"$*\" ;;\n" for name, address in ADDRESSES.items())
        self.agent.write_text(f"#!/bin/sh\nhost=$1\nshift\ncase $host in\n{cases}esac\nexit 1\n")
        self.agent.chmod(self.agent.stat().st_mode | stat.S_IXUSR)

    def inside(self, name):
        return ["nsenter", "--net", "--uts", "--target", str(self.holders[name].pid), "--"]

    def words(self):
        """Before mpirun, and its options: the ranks 0 and 1 are on the first machine, 2 and 3 on the second."""
        hosts = ",".join(f"{address}:2" for address in ADDRESSES.values())
        return self.inside("first"), ["--mca", "plm_rsh_agent", str(self.agent), "--host", hosts]

    def cut(self):
        subprocess.run([*self.inside("first"), "ip", "link", "set", "cable", "down"], check=True)

    def end(self):
        for holder in self.holders.values():
            holder.kill()
            holder.wait()
