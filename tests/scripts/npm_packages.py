"""Packages from npm that judge the library, in the versions that a folder's lock file states."""
import pathlib
import shutil
import subprocess
import sys


def install(here, folder, package):
    """Installs what here/package-lock.json states into the folder, unless `package` is there."""
    for program in ("node", "npm"):
        if not shutil.which(program):
            sys.exit(f"{program} is missing: this test judges with {package}; ./bootstrap installs it")
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("package.json", "package-lock.json"):
        shutil.copy(pathlib.Path(here) / name, folder)
    if not (folder / "node_modules" / package).is_dir():
        subprocess.run(["npm", "ci", "--no-audit", "--no-fund", "--ignore-scripts"], cwd=folder, check=True)
