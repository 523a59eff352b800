#!/usr/bin/env python3
"""Teaches a network of PyTorch to walk as the trot does, and exports it with its contract.

    cca-policy contract robot.hpp --policy pytorch_walk::learner --python --out build/walk_contract.py
    PYTHONPATH=build:build/release/examples python3 train.py --out build/walk.onnx

The network drives the simulated robot, more and more; the trot says in each step what it would do (Ross, Gordon and Bagnell, A reduction
of imitation learning and structured prediction to no-regret online learning, AISTATS 2011). Needs PyTorch and onnx: Debian's
python3-torch and python3-onnx, or those of pip.
"""
import argparse
import pathlib
import time

import numpy
import onnx
import torch

import oncilla_lessons
import walk_contract

# [pose]
# What the robot's types do not say, and the training chooses.
DEFAULT = dict(front_hip=0.794, hind_hip=0.630, front_knee=1.627, hind_knee=1.518)  # rad: where the trot stands
SCALE = 0.25  # rad
STIFFNESS, DAMPING = [30] * 4 + [80] * 4, [0.375] * 4 + [0.4] * 4  # of the drives of hips and knees, N m/rad and N m s/rad


def default_of(joint):
    return DEFAULT[joint.replace("left_", "").replace("right_", "")]
# [pose end]


# [network]
class Policy(torch.nn.Module):
    """Normalises, then three layers. Its numbers are (target - default) / SCALE."""

    def __init__(self, inputs, outputs, units=64):
        super().__init__()
        self.register_buffer("mean", torch.zeros(inputs))
        self.register_buffer("deviation", torch.ones(inputs))
        self.layers = torch.nn.Sequential(
            torch.nn.Linear(inputs, units), torch.nn.ELU(), torch.nn.Linear(units, units), torch.nn.ELU(), torch.nn.Linear(units, outputs))

    def forward(self, obs):
        return self.layers((obs - self.mean) / self.deviation)
# [network end]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", default="walk.onnx")
    parser.add_argument("--worlds", type=int, default=32)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--threads", type=int, default=0, help="0: all cores")
    parser.add_argument("--seconds", type=float, default=3, help="of each round")
    parser.add_argument("--seed", type=int, default=0)
    a = parser.parse_args()
    torch.manual_seed(a.seed)
    torch.set_num_threads(1)  # so small a network is not faster on more
    draw = numpy.random.default_rng(a.seed)

    joints, seen = walk_contract.JOINTS, walk_contract.CONTRACT["inputs"]
    default = numpy.array([default_of(j) for j in joints])
    env = oncilla_lessons.lessons(a.worlds, threads=a.threads, episode_steps=0)
    net = Policy(seen, len(joints))

    def observed(numbers):  # joint_pos, the last term, is relative to the default pose
        x = numbers[:, :seen].copy()
        x[:, -len(joints):] -= default
        return x

    def targets(x):
        with torch.no_grad():
            return default + SCALE * net(torch.tensor(x, dtype=torch.float32)).numpy().astype(float)

    # [training]
    x, y, begun = [], [], time.monotonic()
    for k in range(a.rounds):
        by_teacher = 1 if k == 0 else 0.5 ** k
        numbers, _ = env.reset(seed=1 + 1000 * k + 100000 * a.seed)
        moved = 0.0
        for _ in range(int(a.seconds / env.step_seconds)):
            now, lesson = observed(numbers), numbers[:, seen:].copy()
            drives = draw.random((a.worlds, 1)) < by_teacher
            numbers, reward, fell, _, _ = env.step(numpy.where(drives, lesson, targets(now)))
            moved += reward.mean()
            x.append(now[~fell])  # a target is reached when the next one comes, so the next lesson is the answer
            y.append((numbers[~fell, seen:] - default) / SCALE)
        all_x = torch.tensor(numpy.concatenate(x), dtype=torch.float32)
        all_y = torch.tensor(numpy.concatenate(y), dtype=torch.float32)
        if k == 0:
            net.mean.copy_(all_x.mean(0)), net.deviation.copy_(all_x.std(0).clamp(min=1e-2))
        steps = torch.optim.Adam(net.parameters(), lr=2e-3)
        for _ in range(4):
            for some in torch.randperm(len(all_x)).split(256):
                loss = torch.nn.functional.mse_loss(net(all_x[some]), all_y[some])
                steps.zero_grad(), loss.backward(), steps.step()
        print(f"round {k}: {moved:.2f} m in {a.seconds:g} s; {len(all_x)} lessons, {SCALE * loss.item() ** 0.5:.4f} rad off, {time.monotonic() - begun:.0f} s", flush=True)
    # [training end]

    # [export]
    torch.onnx.export(net, torch.zeros(1, seen), a.out, input_names=["obs"], output_names=["actions"], opset_version=11)
    model = onnx.load(a.out)
    onnx.helper.set_model_props(model, walk_contract.metadata(
        default_joint_pos=default, action_scale=[SCALE] * len(joints), joint_stiffness=STIFFNESS, joint_damping=DAMPING))
    onnx.save(model, a.out)
    pathlib.Path(a.out).with_suffix(".toml").write_text(walk_contract.map_text(relative_to_default=["joint_pos", "action"]))
    # [export end]
    print(f"{a.out} and its map: {len(model.SerializeToString())} bytes")


if __name__ == "__main__":
    main()
