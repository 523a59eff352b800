#!/usr/bin/env python3
"""Checks that every component is under the laws of finite numbers (tests/laws/finite_laws.hpp).

usage: finite.py [ROOT of the repository]

Each header directly in a folder of FOLDERS has a TEST_CASE of its name in tests/runtime/finite, or a reason in WITHOUT.
"""
import pathlib
import re
import sys

FOLDERS = ["adaptive", "mapping", "motor", "robot"]
TESTS = "tests/runtime/finite"
FUNCTION = "functions and data, no component"
PART = "a graph of components that are tested by themselves"
WITHOUT = {
    "adaptive/adaptive_component.hpp": PART,
    "adaptive/criterion.hpp": "the base of the criteria, which are tested",
    "adaptive/extreme_learning_machine.hpp": "a learner: tested within adaptive_mapping",
    "adaptive/learned_file.hpp": FUNCTION,
    "adaptive/learner.hpp": FUNCTION,
    "adaptive/locally_weighted_regression.hpp": "a learner: tested within dmp_rhythmic_module",
    "adaptive/module_status.hpp": FUNCTION,
    "adaptive/ode.hpp": FUNCTION,
    "adaptive/ode_odeint.hpp": "an integrator",
    "adaptive/ode_solver.hpp": "tested within the components of motor/",
    "adaptive/ode_status.hpp": FUNCTION,
    "adaptive/recursive_least_squares.hpp": "a learner: tested within adaptive_mapping",
    "adaptive/sampling.hpp": "runs between beats",
    "adaptive/sequence.hpp": "compares numbers and keeps none",
    "adaptive/sequencer.hpp": "compares numbers and keeps none",
    "adaptive/training.hpp": "tested within dmp_rhythmic_module and adaptive_mapping",
    "mapping/damped_least_squares.hpp": "tested within inverse_kinematics",
    "mapping/kinematics.hpp": FUNCTION,
    "mapping/many_starts.hpp": "tested within inverse_kinematics",
    "mapping/pantograph.hpp": FUNCTION,
    "mapping/placement.hpp": FUNCTION,
    "mapping/reaching.hpp": FUNCTION,
    "mapping/serial_chain.hpp": FUNCTION,
    "mapping/tip_task.hpp": FUNCTION,
    "motor/dmp_shapes.hpp": FUNCTION,
    "motor/gait.hpp": FUNCTION,
    "motor/gaussian_mixture_learning.hpp": "learns between beats",
    "motor/spaces.hpp": FUNCTION,
    "robot/unreadable_fault.hpp": "reads a status and keeps a count",
    "robot/body.hpp": FUNCTION,
    "robot/body_components.hpp": "without a state: NaN passes",
    "robot/body_dynamics.hpp": FUNCTION,
    "robot/body_pose.hpp": FUNCTION,
    "robot/watchdog.hpp": "looks at times only",
}


def problems(root):
    tested = set()
    for file in sorted((root / TESTS).glob("*.cpp")):
        tested |= set(re.findall(r'TEST_CASE\("([\w/]+\.hpp)"\)', file.read_text()))
    headers = {f"{folder}/{header.name}" for folder in FOLDERS for header in (root / "include/cca" / folder).glob("*.hpp")}
    for header in sorted(headers - tested - set(WITHOUT)):
        yield f"include/cca/{header}: no test of its name in {TESTS}: add one, or a reason to WITHOUT in tests/scripts/finite.py"
    for header in sorted((tested | set(WITHOUT)) - headers):
        yield f"{TESTS} or tests/scripts/finite.py names {header}, which does not exist"
    for header in sorted(tested & set(WITHOUT)):
        yield f"tests/scripts/finite.py: {header} has a test, so it needs no reason"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    found = list(problems(root))
    print("\n".join(found) if found else "every component is under the laws of finite numbers")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
