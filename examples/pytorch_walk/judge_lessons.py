#!/usr/bin/env python3
"""Whether the robot walks if what the teacher says is done: what train.py begins with, without PyTorch."""
import sys

import numpy

import oncilla_lessons


def main():
    env = oncilla_lessons.lessons(4, autoreset="disabled", episode_steps=0)
    joints = env.single_action_space.shape[0]
    names = env.single_observation_space.names
    if [n.split(".")[1] for n in names[-joints:]] != list(env.single_action_space.names):
        sys.exit(f"the lesson is not of the joints that are commanded: {names[-joints:]}")
    numbers, _ = env.reset(seed=7)
    moved, fell = numpy.zeros(4), numpy.zeros(4, bool)
    for _ in range(300):
        numbers, reward, ended, _, _ = env.step(numbers[:, -joints:].copy())
        moved += reward
        fell |= ended
    walk = (moved > 1) & ~fell
    print(f"{walk.sum()} of 4 walk by the lessons: {moved.min():.2f} to {moved.max():.2f} m in 3 s")


if __name__ == "__main__":
    main()
