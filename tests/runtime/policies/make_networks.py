#!/usr/bin/env python3
"""Makes the networks that the tests of policies read: small ONNX files, as exporters write them.

usage: make_networks.py FOLDER of this program

Needs Debian's python3-onnx. The files in networks/ and walk/ were made by it; the same numbers each time.
"""
import pathlib
import sys

import numpy as np
import onnx
from onnx import TensorProto as T
from onnx import helper as h
from onnx import numpy_helper as n

JOINTS = ["left_hip", "left_knee", "right_hip", "right_knee"]
# What the tests' robot has: gyro 3, gravity 3, command 2, angles 4, velocities 4, last action 4.
OBSERVED, ACTIONS = 20, 4


class Net:
    def __init__(self, seed, opset=11):
        self.r = np.random.default_rng(seed)
        self.opset, self.nodes, self.tensors, self.inputs, self.outputs, self.count = opset, [], [], [], [], 0

    def tensor(self, array, kind=np.float32):
        self.count += 1
        name = f"t{self.count}"
        self.tensors.append(n.from_array(np.asarray(array).astype(kind), name))
        return name

    def random(self, *shape, scale=None):
        return self.tensor(self.r.standard_normal(shape) * (scale or shape[-1] ** -0.5))

    def op(self, kind, *inputs, outputs=1, name=None, **attributes):
        self.count += 1
        out = [f"x{self.count}_{i}" for i in range(outputs)] if name is None else ([name] if isinstance(name, str) else name)
        self.nodes.append(h.make_node(kind, list(inputs), out, **attributes))
        return out[0] if outputs == 1 and (name is None or isinstance(name, str)) else out

    def gemm(self, x, size_in, size_out, name=None, **attributes):
        return self.op("Gemm", x, self.random(size_out, size_in), self.random(size_out, scale=0.1), name=name, transB=1, **attributes)

    def value(self, name, *shape):
        return h.make_tensor_value_info(name, T.FLOAT, shape)

    def save(self, file, meta=None, inputs=None, outputs=None, beside=False):
        inputs = inputs or [self.value("obs", 1, OBSERVED)]
        outputs = outputs or [self.value("actions", 1, ACTIONS)]
        graph = h.make_graph(self.nodes, "policy", inputs, outputs, self.tensors)
        model = h.make_model(graph, opset_imports=[h.make_opsetid("", self.opset)])
        model.ir_version = 7
        h.set_model_props(model, meta or {})
        if self.opset <= 17:
            onnx.checker.check_model(model)
        file.with_name(f"{file.name}.data").unlink(missing_ok=True)  # onnx.save writes behind what is there
        onnx.save(model, str(file), save_as_external_data=beside, location=f"{file.name}.data", size_threshold=0)


def mlp(net, x, sizes, activation, **attributes):
    for k in range(len(sizes) - 1):
        last = k + 2 == len(sizes)
        x = net.gemm(x, sizes[k], sizes[k + 1], name="actions" if last else None)
        if not last:
            x = net.op(activation, x, **attributes)
    return x


def normalised(net, x, size):
    x = net.op("Sub", x, net.random(1, size, scale=1.0))
    return net.op("Div", x, net.tensor(np.abs(net.r.standard_normal((1, size))) + 0.5))


META = {"joint_names": ",".join(JOINTS), "default_joint_pos": "0.100,-0.800,-0.100,-0.800", "action_scale": "0.250,0.250,0.250,0.250",
        "joint_stiffness": "25.000,25.000,25.000,25.000", "joint_damping": "0.500,0.500,0.500,0.500",
        "observation_names": "base_ang_vel,projected_gravity,velocity_commands,joint_pos,joint_vel,actions",
        "command_names": "base_velocity", "run_path": "none"}


def networks():
    """(name, net, arguments of save)"""
    net = Net(1)
    mlp(net, normalised(net, "obs", OBSERVED), [OBSERVED, 64, 32, ACTIONS], "Elu", alpha=1.0)
    yield "elu", net, {"meta": META}
    for seed, (name, kind, attributes) in enumerate([("relu", "Relu", {}), ("leaky_relu", "LeakyRelu", {"alpha": 0.02}), ("tangent", "Tanh", {}),
                                                     ("sigmoid", "Sigmoid", {}), ("elu_alpha", "Elu", {"alpha": 0.5})], 2):
        net = Net(seed)
        mlp(net, "obs", [OBSERVED, 33, 17, ACTIONS], kind, **attributes)
        yield name, net, {}
    net = Net(10)  # MatMul, Add, SiLU as Mul of Sigmoid
    x = net.op("Add", net.op("MatMul", "obs", net.random(OBSERVED, 40, scale=0.2)), net.random(40, scale=0.1))
    x = net.op("Mul", x, net.op("Sigmoid", x))
    net.op("Add", net.random(ACTIONS, scale=0.1), net.op("MatMul", x, net.random(40, ACTIONS, scale=0.2)), name="actions")
    yield "silu", net, {}
    net = Net(11, 13)
    x = net.gemm("obs", OBSERVED, 24)
    net.op("Mul", net.gemm(net.op("Softmax", x, axis=-1), 24, ACTIONS), net.tensor([3.0]), name="actions")
    yield "softmax", net, {}
    net = Net(12)
    x = net.gemm("obs", OBSERVED, 24)
    net.gemm(net.op("Softmax", x, axis=1), 24, ACTIONS, name="actions")
    yield "softmax_old", net, {}
    net = Net(13, 17)
    x = net.gemm("obs", OBSERVED, 32)
    x = net.op("LayerNormalization", x, net.random(32, scale=1.0), net.random(32, scale=0.2), axis=-1, epsilon=1e-5)
    net.gemm(net.op("Elu", x), 32, ACTIONS, name="actions")
    yield "layer_norm", net, {}
    net = Net(14, 13)  # as exporters before opset 17 write it
    x = net.gemm("obs", OBSERVED, 32)
    off = net.op("Sub", x, net.op("ReduceMean", x, axes=[-1], keepdims=1))
    variance = net.op("ReduceMean", net.op("Pow", off, net.tensor(2.0)), axes=[-1], keepdims=1)
    y = net.op("Div", off, net.op("Sqrt", net.op("Add", variance, net.tensor(1e-5))))
    y = net.op("Add", net.op("Mul", y, net.random(32, scale=1.0)), net.random(32, scale=0.2))
    net.gemm(net.op("Relu", y), 32, ACTIONS, name="actions")
    yield "layer_norm_parts", net, {}
    net = Net(15, 13)
    x = net.op("BatchNormalization", "obs", net.random(OBSERVED, scale=1.0), net.random(OBSERVED, scale=1.0), net.random(OBSERVED, scale=1.0),
               net.tensor(np.abs(net.r.standard_normal(OBSERVED)) + 0.3), epsilon=1e-5)
    mlp(net, x, [OBSERVED, 16, ACTIONS], "Tanh")
    yield "batch_norm", net, {}
    net = Net(16, 13)  # an encoder of the velocities, with a norm of its latent, beside the rest
    a = net.op("Slice", "obs", net.tensor([8], np.int64), net.tensor([16], np.int64), net.tensor([-1], np.int64))
    z = net.gemm(net.op("Elu", net.gemm(a, 8, 24)), 24, 8)
    length = net.op("Clip", net.op("ReduceL2", z, axes=[-1], keepdims=1), net.tensor(1e-12))
    z = net.op("Div", z, length)
    mlp(net, net.op("Concat", "obs", z, axis=-1), [OBSERVED + 8, 32, ACTIONS], "Elu")
    yield "encoder", net, {}
    net = Net(17, 11)
    a = net.op("LpNormalization", net.gemm("obs", OBSERVED, 12), axis=-1, p=2)
    b, c = net.op("Split", net.gemm("obs", OBSERVED, 12), outputs=2, axis=1, split=[5, 7])
    d = net.op("Gather", "obs", net.tensor([3, 1, 2, 19, 0], np.int64), axis=1)
    e = net.op("Slice", "obs", net.tensor([18], np.int64), net.tensor([0], np.int64), net.tensor([1], np.int64), net.tensor([-4], np.int64))
    x = net.op("Concat", a, c, b, d, e, net.random(1, 3, scale=1.0), axis=1)
    mlp(net, x, [12 + 7 + 5 + 5 + 5 + 3, 16, ACTIONS], "LeakyRelu", alpha=0.1)
    yield "pieces", net, {}
    net = Net(18, 13)  # layout only: history as a picture, turned
    x = net.op("Reshape", "obs", net.tensor([1, 5, 4], np.int64))
    x = net.op("Transpose", x, perm=[0, 2, 1])
    x = net.op("Flatten", net.op("Identity", x), axis=1)
    x = net.op("Unsqueeze", x, net.tensor([0], np.int64))
    x = net.op("Squeeze", x, net.tensor([0], np.int64))
    x = net.op("Abs", net.op("Neg", net.op("Cast", x, to=1)))
    mlp(net, net.op("Dropout", x), [OBSERVED, 16, ACTIONS], "Tanh")
    yield "layout", net, {}
    net = Net(19, 13)  # constants as nodes, shapes that are computed, bounds
    one = net.op("Constant", value=n.from_array(np.array([1], np.int64)))
    batch = net.op("Gather", net.op("Shape", "obs"), net.tensor(0, np.int64), axis=0)
    where = net.op("Concat", net.op("Unsqueeze", batch, net.tensor([0], np.int64)), net.op("Sub", net.tensor([0], np.int64), one), axis=0)
    x = net.op("Reshape", "obs", where)
    x = net.op("Clip", x, net.tensor(-1.5), net.tensor(1.5))
    x = net.op("Mul", x, net.op("Constant", value=n.from_array(np.array(0.7, np.float32))))
    x = net.op("Sub", net.op("Constant", value=n.from_array(np.array(1.0, np.float32))), x)
    x = net.op("Add", x, net.op("Mul", net.op("ReduceSum", x, net.tensor([1], np.int64), keepdims=1), net.tensor([0.05])))
    mlp(net, x, [OBSERVED, 16, ACTIONS], "Elu")
    yield "constants", net, {}
    net = Net(20)
    net.op("Gemm", net.op("Tanh", net.op("Gemm", "obs", net.random(OBSERVED, 10, scale=0.3), net.random(1, scale=1.0), alpha=0.5, beta=2.0)),
           net.random(10, ACTIONS, scale=0.3), name="actions", alpha=1.5)
    yield "gemm", net, {}
    net = Net(26, 17)  # four layers of SiLU, with the weights in a file beside it
    x = "obs"
    for size_in, size_out in [(OBSERVED, 64), (64, 64), (64, 32), (32, 32)]:
        x = net.gemm(x, size_in, size_out)
        x = net.op("Mul", x, net.op("Sigmoid", x))
    net.gemm(x, 32, ACTIONS, name="actions")
    yield "beside", net, {"beside": True}
    net = Net(41)  # a wide layer of SiLU on raw observations, far outside of those that its normaliser knows, and bounded commands
    x = net.op("Sub", "obs", net.random(1, OBSERVED, scale=1.0))
    x = net.op("Mul", x, net.tensor(np.exp(net.r.uniform(0, np.log(50), (1, OBSERVED)))))
    for size_in, size_out in [(OBSERVED, 384), (384, 24)]:
        x = net.gemm(x, size_in, size_out)
        x = net.op("Mul", x, net.op("Sigmoid", x))
    x = net.op("Gemm", x, net.random(ACTIONS, 24, scale=0.03), net.random(ACTIONS, scale=0.1), transB=1)
    net.op("Tanh", x, name="actions")
    yield "silu_raw", net, {}
    H = 16
    for seed, (name, normal) in enumerate([("lstm", False), ("lstm_normalised", True)], 21):
        net = Net(seed)
        x = normalised(net, "obs", OBSERVED) if normal else "obs"
        x = net.op("Unsqueeze", x, axes=[0])
        y, hn, cn = net.op("LSTM", x, net.random(1, 4 * H, OBSERVED), net.random(1, 4 * H, H), net.random(1, 8 * H, scale=0.1), "", "h_in", "c_in",
                           name=["y", "h_out", "c_out"], hidden_size=H)
        mlp(net, net.op("Squeeze", y, axes=[0, 1]), [H, 16, ACTIONS], "Elu")
        yield name, net, {"inputs": [net.value("obs", 1, OBSERVED), net.value("h_in", 1, 1, H), net.value("c_in", 1, 1, H)],
                          "outputs": [net.value("actions", 1, ACTIONS), net.value("h_out", 1, 1, H), net.value("c_out", 1, 1, H)]}
    for seed, (name, after) in enumerate([("gru", 1), ("gru_reset_before", 0)], 23):
        net = Net(seed)
        x = net.op("Unsqueeze", net.op("Elu", net.gemm("obs", OBSERVED, 12)), axes=[0])
        y, hn = net.op("GRU", x, net.random(1, 3 * H, 12), net.random(1, 3 * H, H), net.random(1, 6 * H, scale=0.2), "", "h_in",
                       name=["y", "h_out"], hidden_size=H, linear_before_reset=after)
        net.gemm(net.op("Squeeze", hn, axes=[0]), H, ACTIONS, name="actions")
        yield name, net, {"inputs": [net.value("obs", 1, OBSERVED), net.value("h_in", 1, 1, H)],
                          "outputs": [net.value("actions", 1, ACTIONS), net.value("h_out", 1, 1, H)]}
    net = Net(25, 13)  # two layers, whose states come and go in one tensor
    x = net.op("Unsqueeze", "obs", net.tensor([0], np.int64))
    states = []
    for k, size in enumerate([OBSERVED, H]):
        s = [net.op("Slice", m, net.tensor([k], np.int64), net.tensor([k + 1], np.int64), net.tensor([0], np.int64)) for m in ("h_in", "c_in")]
        y, hn, cn = net.op("LSTM", x, net.random(1, 4 * H, size), net.random(1, 4 * H, H), net.random(1, 8 * H, scale=0.1), "", *s,
                           outputs=3, hidden_size=H)
        x = net.op("Squeeze", y, net.tensor([1], np.int64))
        states.append((hn, cn))
    net.op("Concat", *[s[0] for s in states], name="h_out", axis=0)
    net.op("Concat", *[s[1] for s in states], name="c_out", axis=0)
    net.gemm(net.op("Squeeze", x, net.tensor([0], np.int64)), H, ACTIONS, name="actions")
    yield "lstm_two_layers", net, {"inputs": [net.value("obs", 1, OBSERVED), net.value("h_in", 2, 1, H), net.value("c_in", 2, 1, H)],
                                   "outputs": [net.value("actions", 1, ACTIONS), net.value("h_out", 2, 1, H), net.value("c_out", 2, 1, H)]}


def walk():
    """With a history of three, a quaternion and a normaliser: beside a deploy.yaml and a map."""
    net, observed = Net(40), 3 * 21
    mlp(net, normalised(net, "obs", observed), [observed, 32, 16, ACTIONS], "Elu", alpha=1.0)
    names = "base_ang_vel,attitude,velocity_commands,joint_pos_rel,joint_vel_rel,last_action"
    return net, {"meta": META | {"observation_names": names}, "inputs": [net.value("obs", 1, observed)]}


def main():
    here = pathlib.Path(sys.argv[1])
    for name, net, arguments in networks():
        net.save(here / "networks" / f"{name}.onnx", **arguments)
    net, arguments = walk()
    net.save(here / "walk" / "walk.onnx", **arguments)


if __name__ == "__main__":
    main()
