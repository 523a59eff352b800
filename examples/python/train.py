#!/usr/bin/env python3
"""Trains a policy that makes the simulated Oncilla walk, with numpy alone, from nothing: evolution strategies.

    train.py --out walk.policy                  some minutes on two cores
    train.py --minutes 0.2 --out try.policy     to see that it runs

The module oncilla_walk has to be on PYTHONPATH (docs/python.md). The file is what the robot's program loads:
walking_policy --weights walk.policy --config walk.toml. The same seed and --generations give the same bits on any number of cores of one machine.

Each generation tries pairs of weights around the mean, one robot for each, all with the same disturbance, and goes along those that
are worth more, by their ranks, with the steps of Adam. Source: Salimans et al., Evolution strategies as a scalable alternative to
reinforcement learning, 2017; Kingma and Ba, Adam, ICLR 2015.
"""
import argparse
import sys
import time

import numpy

import oncilla_walk
import policy

STAND = numpy.radians([45.5, 45.5, 36.1, 36.1, 93.2, 93.2, 87.0, 87.0])  # hips, then knees: where the robot is put down
REACH = 0.5  # rad that an output of 1 is away from it
FIRST_JUDGED = 1000  # seeds from here on are those of the judges: no training takes them


class policies:
    """As many policies side by side as there are rows of weights."""

    def __init__(self, sizes):
        self.shapes = list(zip(sizes[1:], sizes[:-1]))
        self.count = sum(rows * (columns + 1) for rows, columns in self.shapes)

    def first(self, random):
        """Layers that keep the size of what passes; the last one says nothing yet."""
        parts = []
        for i, (rows, columns) in enumerate(self.shapes):
            last = i + 1 == len(self.shapes)
            parts += [numpy.zeros(rows * columns) if last else random.standard_normal(rows * columns) / numpy.sqrt(columns), numpy.zeros(rows)]
        return numpy.concatenate(parts)

    def layers(self, weights):
        """[(matrices, biases), ...] of each row of weights, or of a single one."""
        at, all_layers = 0, []
        for rows, columns in self.shapes:
            matrix = weights[..., at:at + rows * columns].reshape(*weights.shape[:-1], rows, columns)
            at += rows * columns
            all_layers.append((matrix, weights[..., at:at + rows]))
            at += rows
        return all_layers


def centred_ranks(values):
    ranks = numpy.empty(len(values))
    ranks[numpy.argsort(values, kind="stable")] = numpy.arange(len(values))
    return ranks / (len(values) - 1) - 0.5


def returns(env, layers, seed, options, steps):
    """What each policy earns in an episode of the same seed. `env` leaves robots that have fallen alone."""
    observations, _ = env.reset(seed=[seed] * env.num_envs, options=options)
    earned, lost = numpy.zeros(env.num_envs), numpy.zeros(env.num_envs, bool)
    for _ in range(steps):
        observations, rewards, terminations, _, _ = env.step(STAND + REACH * policy.answer(layers, observations))
        earned += rewards
        lost |= terminations
        if lost.all():
            break
    return earned - lost  # a fall costs as much as a second


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", required=True, help="file of the weights")
    parser.add_argument("--minutes", type=float, default=6)
    parser.add_argument("--generations", type=int, help="instead of minutes")
    parser.add_argument("--pairs", type=int, default=32, help="of weights in a generation")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--noise", type=float, default=0.06, help="of each weight")
    parser.add_argument("--rate", type=float, default=0.02, help="of Adam")
    parser.add_argument("--speed", type=float, default=0.4, help="m/s")
    parser.add_argument("--threads", type=int, default=0)
    a = parser.parse_args()

    random = numpy.random.default_rng(a.seed)
    env = oncilla_walk.walk(2 * a.pairs, autoreset="disabled", episode_steps=0, threads=a.threads)
    net = policies(env.policy_layers)
    options = {"gait.throttle.speed": a.speed, "judge.speed": a.speed}
    mean = net.first(random)
    first, second = numpy.zeros(net.count), numpy.zeros(net.count)
    begin, steps = time.monotonic(), 0
    generation = 0
    while generation < a.generations if a.generations else time.monotonic() - begin < 60 * a.minutes:
        generation += 1
        length = min(500, 150 + 2 * generation)  # steps: longer episodes once it stands
        directions = random.standard_normal((a.pairs, net.count))
        tried = mean + a.noise * numpy.concatenate([directions, -directions])
        earned = returns(env, net.layers(tried), generation % (FIRST_JUDGED - 1) + 1, options, length)
        steps += length * env.num_envs
        worth = centred_ranks(earned)
        slope = (worth[:a.pairs] - worth[a.pairs:]) @ directions / (2 * a.pairs * a.noise) - 0.002 * mean  # small weights are worth more, too
        first += 0.1 * (slope - first)
        second += 0.01 * (slope ** 2 - second)
        mean = mean + a.rate * (first / (1 - 0.9 ** generation)) / (numpy.sqrt(second / (1 - 0.99 ** generation)) + 1e-8)
        if generation % 10 == 0:
            seconds = time.monotonic() - begin
            print(f"generation {generation}, {seconds:.0f} s: reward a second {numpy.median(earned) / length / env.step_seconds:+.2f}, best "
                  f"{earned.max() / length / env.step_seconds:+.2f}; {steps / seconds:.0f} steps a second", file=sys.stderr, flush=True)
    env.save_policy(a.out, net.layers(mean), offset=STAND, gain=numpy.full(len(STAND), REACH))
    print(f"{a.out}: {generation} generations, {steps} steps")


if __name__ == "__main__":
    main()
