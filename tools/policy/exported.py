#!/usr/bin/env python3
"""Checks that an ONNX file and its map are what a contract of a header says.

usage: exported.py CONTRACT.py FILE without its ending
"""
import pathlib
import runpy
import sys

contract = runpy.run_path(sys.argv[1])
file = pathlib.Path(sys.argv[2])
onnx, written = file.with_suffix(".onnx").read_bytes(), file.with_suffix(".toml").read_text()
said = contract["map_text"](relative_to_default=["joint_pos", "action"])
if said != written:
    sys.exit(f"{file}.toml differs from map_text:\n{said}")
said = contract["metadata"]([0] * 8, [1] * 8, [1] * 8, [1] * 8)
for key in ("joint_names", "observation_names"):
    if said[key].encode() not in onnx:
        sys.exit(f"{file}.onnx has no {key} {said[key]}")
try:
    contract["metadata"]([0] * 7, [1] * 8)
except ValueError as wrong:
    if str(wrong) != "default_joint_pos has 7 numbers, and there are 8 joints":
        sys.exit(f"another message: {wrong}")
else:
    sys.exit("a number is missing, and metadata takes it")
try:
    contract["map_text"](relative_to_default=["joint_position"])
except ValueError as wrong:
    print(wrong)
else:
    sys.exit("an unknown observation, and map_text takes it")
print(f"{file.name}.onnx has this contract: {len(contract['JOINTS'])} joints at {contract['RATE']} Hz")
