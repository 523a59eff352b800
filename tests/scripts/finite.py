#!/usr/bin/env python3
"""Checks that every component is under the laws of finite numbers (tests/laws/finite_laws.hpp), and that its header says so.

usage: finite.py [ROOT of the repository]

Each header directly in a folder of FOLDERS has a TEST_CASE of its name in tests/runtime/finite, or a reason in WITHOUT.
The comment at its beginning states what holds while an input is NaN or infinite, or it has a reason in SILENT.
"""
import pathlib
import re
import sys

FOLDERS = ["adaptive", "adaptive/module", "mapping", "mapping/network", "motor", "motor/modules", "robot", "robot/compliance", "robot/dynamics"]
TESTS = "tests/runtime/finite"
FUNCTION = "functions and data, no component"
MESSAGES = "messages of the compiler, nothing that runs"
PART = "a graph of components that are tested by themselves"
WITHOUT = {
    "adaptive/adaptive_component.hpp": PART,
    "adaptive/criterion.hpp": "the base of the criteria, which are tested",
    "adaptive/extreme_learning_machine.hpp": "a learner: tested within adaptive_mapping",
    "adaptive/learned_file.hpp": FUNCTION,
    "adaptive/learner.hpp": FUNCTION,
    "adaptive/locally_weighted_regression.hpp": "a learner: tested within dmp_rhythmic_module",
    "adaptive/module/adaptive_module.hpp": "tested as the modules of motor/",
    "adaptive/module/three_in_a_row.hpp": "tested within the modules of motor/",
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
    "mapping/network/activations.hpp": FUNCTION,
    "mapping/network/operators.hpp": FUNCTION,
    "mapping/network/recurrent.hpp": FUNCTION,
    "mapping/network/weighted_sums.hpp": FUNCTION,
    "mapping/many_starts.hpp": "tested within inverse_kinematics",
    "mapping/pantograph.hpp": FUNCTION,
    "mapping/placement.hpp": FUNCTION,
    "mapping/reaching.hpp": FUNCTION,
    "mapping/serial_chain.hpp": FUNCTION,
    "mapping/tip_task.hpp": FUNCTION,
    "motor/dmp_shapes.hpp": FUNCTION,
    "motor/gait.hpp": FUNCTION,
    "mapping/network/feed_forward.hpp": "tested within policy",
    "motor/modules/attractor_parameters.hpp": FUNCTION,
    "motor/modules/discrete_motion.hpp": "tested as dmp_discrete_module and dmp_pose_module",
    "motor/gaussian_mixture_learning.hpp": "learns between beats",
    "motor/hidden_markov_learning.hpp": "learns between beats",
    "motor/spaces.hpp": FUNCTION,
    "robot/unreadable_fault.hpp": "reads a status and keeps a count",
    "robot/body.hpp": FUNCTION,
    "robot/body_mistakes.hpp": MESSAGES,
    "robot/limiter_mistakes.hpp": MESSAGES,
    "robot/body_components.hpp": "without a state: NaN passes",
    "robot/body_dynamics.hpp": FUNCTION,
    "robot/body_pose.hpp": FUNCTION,
    "robot/body_tree.hpp": FUNCTION,
    "robot/dynamics/derivatives.hpp": FUNCTION,
    "robot/dynamics/floating_derivatives.hpp": FUNCTION,
    "robot/dynamics/derived_mass.hpp": FUNCTION,
    "robot/derived_of_body.hpp": FUNCTION,
    "robot/bounded_motion.hpp": "tested within limiter",
    "robot/command_limits.hpp": FUNCTION,
    "robot/compliance/cartesian_spring.hpp": FUNCTION,
    "robot/compliance/beat_stability.hpp": FUNCTION,
    "robot/compliance/compliance_spaces.hpp": FUNCTION,
    "robot/compliance/damping_design.hpp": FUNCTION,
    "robot/compliance/energy_tank.hpp": "tested within passivity_guard",
    "robot/compliance/symmetric_eigen.hpp": FUNCTION,
    "robot/compliance/tip_dynamics.hpp": FUNCTION,
    "robot/dynamics/coriolis_matrix.hpp": FUNCTION,
    "robot/dynamics/forward_dynamics.hpp": FUNCTION,
    "robot/dynamics/inverse_of_mass.hpp": FUNCTION,
    "robot/dynamics/mass_matrix.hpp": FUNCTION,
    "robot/dynamics/momentum.hpp": FUNCTION,
    "robot/dynamics/momentum_observer.hpp": "tested in tests/runtime/body/momentum_observer.cpp, with its arm",
    "robot/dynamics/operational_space.hpp": FUNCTION,
    "robot/dynamics/positive_matrix.hpp": "forwards to base/math/positive_matrix.hpp",
    "robot/dynamics/spatial_inertia.hpp": FUNCTION,
    "robot/watchdog.hpp": "looks at times only",
}
STATES = re.compile(r"\bNaN\b|\bnot finite\b")
CONSTANTS = "constants of the program"
SILENT = {
    "adaptive/learned_file.hpp": "files; it refuses what is no finite number",
    "adaptive/module_status.hpp": "names of states",
    "adaptive/ode.hpp": "what a model is; the solver says what it does with NaN",
    "mapping/placement.hpp": CONSTANTS,
    "mapping/serial_chain.hpp": CONSTANTS,
    "motor/dmp_shapes.hpp": "what a learner adapts; the learner says what NaN does",
    "motor/gait.hpp": CONSTANTS,
    "motor/modules/attractor_parameters.hpp": CONSTANTS,
    "motor/spaces.hpp": CONSTANTS,
    "robot/body.hpp": CONSTANTS,
    "robot/body_mistakes.hpp": MESSAGES,
    "robot/limiter_mistakes.hpp": MESSAGES,
    "robot/command_limits.hpp": CONSTANTS,
    "robot/watchdog.hpp": "looks at times only",
}


def problems(root):
    yield from problems_of_tests(root)
    yield from problems_of_sentences(root)


def problems_of_sentences(root):
    for folder in FOLDERS:
        for file in sorted((root / "include/cca" / folder).glob("*.hpp")):
            header = f"{folder}/{file.name}"
            states = bool(STATES.search(file.read_text().partition("#pragma once")[0]))
            if not states and header not in SILENT:
                yield f"include/cca/{header}: its first comment does not say what holds while an input is NaN or infinite: output, status and fault"
            if states and header in SILENT:
                yield f"tests/scripts/finite.py: {header} speaks of NaN, so it needs no reason"
    for header in sorted(SILENT):
        if not (root / "include/cca" / header).exists():
            yield f"tests/scripts/finite.py names {header}, which does not exist"


def problems_of_tests(root):
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
    print("\n".join(found) if found else "every component is under the laws of finite numbers, and its header says what NaN does")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
