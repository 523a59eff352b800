#!/usr/bin/env python3
"""The figures of an independent implementation of Baum and Welch, for hidden_markov.cpp: pomegranate 0.14.8.

    apt-get install python3-pomegranate        Debian 12
    /usr/bin/python3 tests/runtime/motor/hidden_markov.py

Three demonstrations of 60, 50 and 40 samples, three states; it begins, as ours, with each demonstration cut into three parts of
equal length. `max_iterations=20` makes 21 steps after that.
"""
import math

import numpy
import pomegranate

K, UNSEEN = 3, 0.1
shown = [numpy.array([[math.sin(0.11 * t) + 0.05 * math.sin(1.7 * t + i), math.cos(0.23 * t + 0.1 * i) + 0.04 * math.cos(2.3 * t)]
                      for t in range(n)]) for i, n in enumerate((60, 50, 40))]
passages, points = numpy.zeros((K, K)), [[] for _ in range(K)]
for samples in shown:
    parts = [K * t // len(samples) for t in range(len(samples))]
    for t, part in enumerate(parts):
        points[part].append(samples[t])
        if t > 0:
            passages[parts[t - 1], part] += 1
for row in passages:
    row += UNSEEN * max(1.0, row.sum())
passages /= passages.sum(1, keepdims=True)
beginnings = numpy.array([1.0 + UNSEEN, UNSEEN, UNSEEN])
states = []
for some in map(numpy.array, points):
    off = some - some.mean(0)
    states.append(pomegranate.MultivariateGaussianDistribution(some.mean(0), off.T @ off / len(some)))
model = pomegranate.HiddenMarkovModel.from_matrix(passages, states, beginnings / beginnings.sum(), merge="None")
model.fit(shown, algorithm="baum-welch", max_iterations=20, stop_threshold=-1e300, distribution_inertia=0.0, edge_inertia=0.0,
          use_pseudocount=False)
print("likelihood", sum(map(model.log_probability, shown)))
emitting = [i for i, state in enumerate(model.states) if state.distribution is not None]
table = model.dense_transition_matrix()
print("transitions", [[float(table[i][j]) for j in emitting] for i in emitting])
for i in emitting:
    print("state", *model.states[i].distribution.parameters)
