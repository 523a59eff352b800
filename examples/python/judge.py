#!/usr/bin/env python3
"""Judges weights on disturbances that no training has used: whether the robot walks as commanded in compiled physics.

    judge.py --weights walk.policy

Exit code 0: none has fallen, and each has earned --least a second, of at most 1 for a robot at the commanded speed without slip and yaw.
"""
import argparse
import sys

import numpy

import oncilla_walk
import policy


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--weights", required=True)
    parser.add_argument("--first", type=int, default=1000, help="seed")
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seconds", type=float, default=20)
    parser.add_argument("--speed", type=float, default=0.4, help="m/s")
    parser.add_argument("--least", type=float, default=0.5, help="reward a second")
    a = parser.parse_args()

    env = oncilla_walk.walk(a.count, autoreset="disabled", episode_steps=0)
    net = env.load_policy(a.weights)
    observations, _ = env.reset(seed=a.first, options={"gait.throttle.speed": a.speed, "judge.speed": a.speed})
    earned, fell, seconds = numpy.zeros(a.count), numpy.zeros(a.count, bool), 0.0
    while seconds < a.seconds:
        actions = net["offset"] + net["gain"] * policy.answer(net["layers"], (observations - net["centre"]) * net["scale"])
        observations, rewards, terminations, _, _ = env.step(actions)
        earned += rewards
        fell |= terminations
        seconds += env.step_seconds
    print(f"{a.count - fell.sum()} of {a.count} seeds walk {a.seconds:g} s; reward a second {numpy.mean(earned) / a.seconds:+.3f}, least {earned.min() / a.seconds:+.3f}")
    sys.exit(0 if not fell.any() and earned.min() >= a.least * a.seconds else 1)


if __name__ == "__main__":
    main()
