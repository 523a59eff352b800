#!/usr/bin/env python3
"""page/recording.html, which is in the repository, must be what its sources in page/web give, byte for byte.

usage: recording_page.py FOLDER for node_modules [--write]

--write replaces it. It needs node, npm and, once, a network. page/web/known.json, the robots and plans that the page
knows, comes from the programs of the pages: the preset `page` compares it with them.
"""

import shutil
import subprocess
import sys
from pathlib import Path

repository = Path(__file__).resolve().parents[2]
web = repository / "page/web"
released = repository / "page/recording.html"


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[1].startswith("-") or sys.argv[2:] not in ([], ["--write"]):
        sys.exit(__doc__)
    for program in ("node", "npm"):
        if not shutil.which(program):
            sys.exit(f"{program} is missing: ./bootstrap installs it")
    folder = Path(sys.argv[1]) / "recording_page"
    shutil.copytree(web, folder, dirs_exist_ok=True)
    lock = folder / "node_modules/.package-lock.json"
    if not lock.is_file() or lock.stat().st_mtime < (web / "package-lock.json").stat().st_mtime:
        subprocess.run(["npm", "ci", "--no-audit", "--no-fund", "--ignore-scripts"], cwd=folder, check=True)
    made = folder / "recording.html"
    subprocess.run(["node", folder / "build.mjs", folder, "--knows", "recording", made, folder / "known.json"], check=True)
    if sys.argv[2:] == ["--write"]:
        shutil.copyfile(made, released)
        print(f"written: {released}")
    elif not released.is_file() or released.read_bytes() != made.read_bytes():
        sys.exit(f"{released} is not what page/web gives: run `python3 {__file__} {sys.argv[1]} --write`")
    else:
        print(f"{released} is what page/web gives, {len(made.read_bytes())} bytes")


if __name__ == "__main__":
    main()
