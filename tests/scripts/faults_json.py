#!/usr/bin/env python3
"""Checks the format of faults.json, which programs outside of the repository read: that of version 0.1.0.

usage: faults_json.py FILE

A list of rows. Each has the keys of KEYS, in this order, with these types. There are at least 40 rows, each of another fault.
"""
import json
import pathlib
import sys

NUMBER = (int, float)
KEYS = {
    "fault": str,
    "first_cause": str,
    "detected_by": str,
    "beats_to_detect": (int, type(None)),  # null: it needed no reaction
    "beats_to_safe": int,
    "max_excursion_rad": NUMBER,
    "max_torque_nm": NUMBER,
    "set_points_sent": int,
    "sent_outside_limits": int,
    "recovered": bool,
}
FEWEST_ROWS = 40


def problems(text):
    rows = json.loads(text)
    if not isinstance(rows, list):
        yield "is no list"
        return
    for row in rows:
        name = row.get("fault", row)
        if list(row) != list(KEYS):
            yield f"{name}: has the keys {list(row)}, expected {list(KEYS)}"
            continue
        for key, kind in KEYS.items():
            is_number_too = isinstance(row[key], bool) and kind is not bool
            if is_number_too or not isinstance(row[key], kind):
                yield f"{name}: {key} is {row[key]!r}"
    if len(rows) < FEWEST_ROWS:
        yield f"has {len(rows)} rows, expected at least {FEWEST_ROWS}"
    if len({row.get("fault") for row in rows}) != len(rows):
        yield "has two rows of one fault"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    found = list(problems(pathlib.Path(sys.argv[1]).read_text()))
    print("\n".join(f"{sys.argv[1]}: {what}" for what in found) if found else "the format is that of 0.1.0")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
