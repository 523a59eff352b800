#!/usr/bin/env python3
"""Checks the summary that examples/deployed writes: which forms it lists, and what it says of each.

    deployed_summary.py FILE
"""
import json
import numbers
import sys

FORMS = ("loop", "threads", "shared_memory", "dds")
PACES = ("as_fast_as_possible", "wall_clock")
COUNTS = ("samples_compared", "different", "late")
OF_WALL_CLOCK = ("overruns", "wake_p99_us")


def problems(summary):
    if not isinstance(summary, list):
        yield "it is no list"
        return
    expected = [("loop", PACES[0])] + [(form, pace) for form in FORMS[1:] for pace in PACES]
    found = [(one.get("form"), one.get("pace")) for one in summary]
    if found != expected:
        yield f"it lists {found}, expected {expected}"
    for one in summary:
        where = f"{one.get('form')}, {one.get('pace')}"
        timed = OF_WALL_CLOCK if one.get("pace") == "wall_clock" else ()
        for key in (*COUNTS, *timed):
            value = one.get(key)
            if not isinstance(value, numbers.Real) or value < 0:
                yield f"{where}: `{key}` is {value!r}, no number from 0 on"
        if "reach_error_mm" not in one:  # null: no paw was near
            yield f"{where}: `reach_error_mm` is missing"
        if one.get("different") != 0 or not one.get("samples_compared"):
            yield f"{where}: {one.get('different')} of {one.get('samples_compared')} samples differ"
        if timed and not one.get("wake_p99_us"):
            yield f"{where}: no environment told how it wakes"
        if not timed:
            for key in OF_WALL_CLOCK:
                if key in one:
                    yield f"{where}: has `{key}`, but no clock"


if __name__ == "__main__":
    with open(sys.argv[1]) as file:
        found = list(problems(json.load(file)))
    print("\n".join(found) or "the summary says of each form what it should")
    sys.exit(1 if found else 0)
