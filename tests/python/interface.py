#!/usr/bin/env python3
"""Tests of a Python module with worlds (docs/python.md), on the pole of pole.hpp.

usage: interface.py FOLDER of the module [TEST...]
"""
import gc
import pathlib
import sys
import tempfile
import threading
import unittest

import numpy

sys.path.insert(0, sys.argv[1])
import cca_test_pole  # noqa: E402


def hold(observations):
    """Keeps the pole upright."""
    return -20 * observations[:, :1] - 6 * observations[:, 1:]


def walk(env, steps, seed=5, act=hold):
    """Everything that an environment says, as bytes, for comparison."""
    observations, _ = env.reset(seed=seed)
    said = [observations.tobytes()]
    for _ in range(steps):
        observations, rewards, terminations, truncations, infos = env.step(act(observations))
        said += [x.tobytes() for x in (observations, rewards, terminations, truncations, infos["seed"])]
        said += [infos["final_obs"][infos["_final_obs"]].tobytes()] if "final_obs" in infos else []
    return said


class Spaces(unittest.TestCase):
    def test_names_units_and_limits(self):
        env = cca_test_pole.pole(3)
        seen = env.single_observation_space
        self.assertEqual(seen.names, ["angle.joint", "velocity.joint"])
        self.assertEqual(seen.units, ["rad", "rad/s"])
        self.assertEqual(seen.low.tolist(), [-3, -20])
        self.assertEqual(seen.high.tolist(), [3, 20])
        self.assertEqual((seen.shape, seen.dtype), ((2,), numpy.float64))
        act = env.single_action_space
        self.assertEqual((act.names, act.units, act.low.tolist(), act.high.tolist()), (["joint"], ["N m"], [-2], [2]))
        self.assertEqual(env.action_space.shape, (3, 1))
        self.assertEqual(env.observation_space.low.shape, (3, 2))
        self.assertIn("angle.joint [rad] -3.0 to 3.0", repr(seen))

    def test_contains(self):
        space = cca_test_pole.pole(2).action_space
        self.assertTrue(space.contains(numpy.zeros((2, 1))))
        for x in (numpy.full((2, 1), 2.5), numpy.full((2, 1), numpy.nan), numpy.zeros((1, 2)), numpy.zeros((2, 1), int), [[0], [0]]):
            self.assertFalse(space.contains(x))

    def test_times(self):
        env = cca_test_pole.pole()
        self.assertEqual((env.num_envs, env.beats_per_step, env.episode_steps), (1, 4, 50))
        self.assertAlmostEqual(env.step_seconds, 0.04)
        self.assertIn("pole.pull", env.parameter_paths)
        self.assertEqual((env.spec, env.render_mode), (None, None))


class Steps(unittest.TestCase):
    def test_first_observation(self):
        observations, infos = cca_test_pole.pole(4).reset(seed=[7, 8, 7, 9])
        self.assertEqual(observations.shape, (4, 2))
        self.assertEqual(infos["seed"].tolist(), [7, 8, 7, 9])
        numpy.testing.assert_array_equal(observations[0], observations[2])
        self.assertTrue((numpy.abs(observations) <= 0.2).all() and observations.any())
        self.assertFalse((observations[0] == observations[1]).any())

    def test_an_action_counts_in_the_beat_of_its_observation(self):
        env = cca_test_pole.pole(1)
        (at, speed), = env.reset(seed=1, options={"pole.pull": 0.0})[0].copy()
        observations, rewards, *_ = env.step(numpy.array([[1.0]]))
        passed = []
        for _ in range(4):
            speed += 0.01
            at += 0.01 * speed
            passed.append(1 - abs(at))
        numpy.testing.assert_allclose(observations[0], [at, speed], rtol=1e-12)
        self.assertAlmostEqual(rewards[0], sum(passed), 12)  # of the four beats after the action

    def test_actions_are_within_the_limits(self):
        env = cca_test_pole.pole(2)
        env.reset(seed=[1, 1])
        observations = env.step(numpy.array([[2.0], [50.0]]))[0]
        numpy.testing.assert_array_equal(observations[0], observations[1])

    def test_float32_and_strides(self):
        env = cca_test_pole.pole(3)
        env.reset(seed=[1, 1, 1])
        a = env.step(numpy.full((3, 1), 0.5))[0].copy()
        env.reset(seed=[1, 1, 1])
        numpy.testing.assert_array_equal(env.step(numpy.full((3, 1), 0.5, numpy.float32))[0], a)
        env.reset(seed=[1, 1, 1])
        numpy.testing.assert_array_equal(env.step(numpy.full((6, 2), 0.5)[::2, :1])[0], a)

    def test_results_are_views_and_hold_for_a_step(self):
        env = cca_test_pole.pole(2)
        first, _ = env.reset(seed=1)
        kept = first.copy()
        second = env.step(hold(first))[0]
        self.assertFalse(first.flags.owndata)
        numpy.testing.assert_array_equal(first, kept)  # still
        self.assertIs(type(second), numpy.ndarray)
        self.assertFalse(numpy.shares_memory(first, second))
        self.assertTrue(numpy.shares_memory(env.step(hold(second))[0], first))

    def test_results_outlive_the_environment(self):
        observations, rewards, *_ = (env := cca_test_pole.pole(1000)).reset(seed=1) + (None,)
        kept = observations.copy()
        del env, rewards
        gc.collect()
        others = [cca_test_pole.pole(1000) for _ in range(3)]
        for other in others:
            other.reset(seed=9)
        numpy.testing.assert_array_equal(observations, kept)


class Episodes(unittest.TestCase):
    def fallen(self, **options):
        """An environment of two poles: the second one falls, and the step at which it does."""
        env = cca_test_pole.pole(2, **options)
        observations, _ = env.reset(seed=[2, 2])
        for k in range(50):
            actions = hold(observations)
            actions[1] = 2
            results = env.step(actions)
            observations = results[0]
            if results[2].any():
                return env, k + 1, results
        self.fail("it does not fall")

    def test_same_step(self):
        env, steps, (observations, rewards, terminations, truncations, infos) = self.fallen()
        self.assertEqual(env.metadata["autoreset_mode"], "SameStep")
        self.assertEqual(terminations.tolist(), [False, True])
        self.assertEqual(truncations.tolist(), [False, False])
        self.assertEqual(infos["_final_obs"].tolist(), [False, True])
        self.assertGreater(infos["final_obs"][1, 0], 0.5)
        self.assertLess(abs(observations[1, 0]), 0.2)
        self.assertEqual(infos["episode"]["l"][1], steps)
        self.assertNotEqual(infos["seed"][1], 2)
        self.assertEqual(infos["seed"][0], 2)
        begun = cca_test_pole.pole(1).reset(seed=[int(infos["seed"][1])])[0]
        numpy.testing.assert_array_equal(begun[0], observations[1])

    def test_next_step(self):
        env, steps, (observations, *_, infos) = self.fallen(autoreset="next_step")
        self.assertEqual(env.metadata["autoreset_mode"], "NextStep")
        self.assertGreater(observations[1, 0], 0.5)
        self.assertNotIn("final_obs", infos)
        self.assertEqual(infos["episode"]["l"][1], steps)
        observations, rewards, terminations, truncations, infos = env.step(numpy.full((2, 1), 1.0))
        self.assertEqual((rewards[1], terminations[1], truncations[1]), (0, False, False))
        self.assertLess(abs(observations[1, 0]), 0.2)

    def test_disabled(self):
        env, _, (observations, *_) = self.fallen(autoreset="disabled")
        self.assertEqual(env.metadata["autoreset_mode"], "Disabled")
        at = observations[1].copy()
        observations, rewards, terminations, _, infos = env.step(numpy.full((2, 1), -2.0))
        self.assertEqual((rewards[1], terminations.tolist()), (0, [False, True]))
        self.assertNotIn("episode", infos)
        numpy.testing.assert_array_equal(observations[1], at)
        other = observations[0].copy()
        observations, infos = env.reset(seed=[4, 4], options={"reset_mask": numpy.array([False, True])})
        numpy.testing.assert_array_equal(observations[0], other)
        self.assertEqual(infos["seed"].tolist(), [2, 4])
        self.assertFalse(env.step(numpy.zeros((2, 1)))[2].any())

    def test_an_episode_is_cut(self):
        env = cca_test_pole.pole(1, episode_steps=3)
        observations, _ = env.reset(seed=1)
        cuts, rewards = [], []
        for _ in range(4):
            observations, reward, terminations, truncations, infos = env.step(hold(observations))
            cuts.append(bool(truncations[0]))
            rewards.append(float(reward[0]))
            self.assertFalse(terminations[0])
            if truncations[0]:
                self.assertAlmostEqual(infos["episode"]["r"][0], sum(rewards))
        self.assertEqual(cuts, [False, False, True, False])

    def test_a_fault_ends_an_episode(self):
        env = cca_test_pole.pole(1, autoreset="disabled")
        env.reset(seed=1, options={"pole.breaks_at": 0.3})
        for _ in range(20):
            *_, terminations, _, infos = env.step(numpy.full((1, 1), 2.0))
            if terminations[0]:
                break
        self.assertEqual(infos["fault"], ["pole: the pole is too fast"])

    def test_parameters_stay(self):
        env = cca_test_pole.pole(2, episode_steps=1)
        env.reset(seed=[3, 3], options={"pole.pull": numpy.array([0.0, 50.0])})
        for _ in range(3):
            self.assertTrue(env.step(numpy.zeros((2, 1)))[3].all())
        env.reset(seed=[3, 3])
        observations = env.step(numpy.zeros((2, 1)))[4]["final_obs"]
        self.assertNotEqual(observations[0, 1], observations[1, 1])

    def test_seeds_go_on(self):
        env = cca_test_pole.pole(2)
        first = env.reset(seed=6)[1]["seed"].tolist()
        second = env.reset()[1]["seed"].tolist()
        self.assertEqual(first, [6, 7])
        self.assertNotIn(second[0], first)
        env.reset(seed=6)
        self.assertEqual(env.reset()[1]["seed"].tolist(), second)


class Bits(unittest.TestCase):
    def test_any_number_of_threads(self):
        def act(observations):  # some poles fall
            return hold(observations) * numpy.linspace(-0.4, 1, len(observations))[:, None]
        all_said = [walk(cca_test_pole.pole(33, threads=t), 80, act=act) for t in (1, 2, 7, 0)]
        self.assertTrue(all(said == all_said[0] for said in all_said))
        self.assertNotEqual(walk(cca_test_pole.pole(33, threads=2), 80, seed=6, act=act), all_said[0])

    def test_other_threads_run_meanwhile(self):
        env = cca_test_pole.pole(2, threads=1)
        other = threading.Timer(0.2, cca_test_pole.may_begin)  # while the worlds wait for it
        other.start()
        env.reset(seed=60_000_000)
        other.join()

    def test_two_threads_take_turns(self):
        env = cca_test_pole.pole(64, episode_steps=0)
        env.reset(seed=1)
        wrong = []

        def many():
            try:
                for _ in range(200):
                    env.step(numpy.zeros((64, 1)))
            except Exception as e:  # noqa: BLE001
                wrong.append(e)
        threads = [threading.Thread(target=many) for _ in range(3)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        self.assertEqual(wrong, [])


class Mistakes(unittest.TestCase):
    def refuses(self, error, text, call, *arguments, **named):
        with self.assertRaisesRegex(error, text):
            call(*arguments, **named)

    def test_actions(self):
        env = cca_test_pole.pole(2)
        before = env.reset(seed=1)[0].copy()
        for error, text, actions in (
                (ValueError, r"actions has the shape \(3, 1\), and \(2, 1\) is expected", numpy.zeros((3, 1))),
                (ValueError, r"actions has the shape \(2,\), and \(2, 1\)", numpy.zeros(2)),
                (TypeError, "actions is an array of int64, not of float64 or float32", numpy.zeros((2, 1), int)),
                (TypeError, "actions is an array of object", numpy.array([[None], [1]])),
                (TypeError, "actions is a list, not a numpy array", [[0.0], [0.0]]),
                (TypeError, "actions is a NoneType", None),
                (ValueError, "the action `joint` of world 1 is nan: actions are finite", numpy.array([[0.0], [numpy.nan]])),
                (ValueError, "the action `joint` of world 0 is -inf", numpy.array([[-numpy.inf], [0.0]]))):
            self.refuses(error, text, env.step, actions)
        numpy.testing.assert_array_equal(env.reset(seed=1)[0], before)

    def test_nothing_moves_for_refused_actions(self):
        env, other = cca_test_pole.pole(2), cca_test_pole.pole(2)
        env.reset(seed=1), other.reset(seed=1)
        self.refuses(ValueError, "nan", env.step, numpy.array([[1.0], [numpy.nan]]))
        numpy.testing.assert_array_equal(env.step(numpy.zeros((2, 1)))[0], other.step(numpy.zeros((2, 1)))[0])

    def test_step_before_reset(self):
        env = cca_test_pole.pole(2)
        self.refuses(RuntimeError, r"step\(\) before reset\(\)", env.step, numpy.zeros((2, 1)))
        self.refuses(RuntimeError, "the first reset has to reset all worlds", env.reset, options={"reset_mask": numpy.array([True, False])})

    def test_seeds(self):
        env = cca_test_pole.pole(2)
        self.refuses(ValueError, "3 seeds for 2 worlds", env.reset, seed=[1, 2, 3])
        self.refuses(ValueError, r"a seed is from 0 to 2\^53 - 1, and this one is -1", env.reset, seed=-1)
        self.refuses(ValueError, "and this one is 9007199254740992", env.reset, seed=[2 ** 53, 1])
        self.refuses(ValueError, "and this one is 1" + 30 * "0", env.reset, seed=10 ** 30)
        self.refuses(TypeError, "a seed is a whole number, not a float", env.reset, seed=1.5)
        self.refuses(TypeError, "a seed is a whole number, not a str", env.reset, seed=["a", "b"])
        self.refuses(ValueError, r"a seed is below 2\^53|from 0 to", env.reset, seed=2 ** 53 - 1)

    def test_options(self):
        env = cca_test_pole.pole(2)
        before = env.reset(seed=1)[0].copy()
        for error, text, options in (
                (ValueError, "pole.pul: unknown parameter, did you mean `pole.pull`", {"pole.pul": 1.0}),
                (ValueError, "pole.pull: -1", {"pole.pull": -1.0}),
                (ValueError, "pole.pull", {"pole.pull": numpy.array([1.0, -1.0])}),
                (ValueError, r"the option 'pole.pull' has the shape \(3,\), and \(2,\) is expected", {"pole.pull": numpy.zeros(3)}),
                (TypeError, "the option 'pole.pull' is a dict", {"pole.pull": {}}),
                (TypeError, "options is no dictionary", [1]),
                (TypeError, "a key of options is no text", {1: 2}),
                (TypeError, "reset_mask is no numpy array of bool", {"reset_mask": [True, False]}),
                (ValueError, r"reset_mask has the shape \(3,\), and \(2,\)", {"reset_mask": numpy.zeros(3, bool)})):
            self.refuses(error, text, env.reset, seed=1, options=options)
        numpy.testing.assert_array_equal(env.reset(seed=1)[0], before)

    def test_what_a_task_throws(self):
        env = cca_test_pole.pole(3)
        self.refuses(ValueError, "world 1: there is no such pole", env.reset, seed=49_999_999)
        self.refuses(RuntimeError, r"step\(\) before reset\(\)", env.step, numpy.zeros((3, 1)))
        env.reset(seed=20)
        env.step(numpy.zeros((3, 1)))

    def test_construction(self):
        make = cca_test_pole.pole
        self.refuses(ValueError, "num_envs is 0: it is at least 1", make, 0)
        self.refuses(ValueError, "threads is -1", make, 1, threads=-1)
        self.refuses(ValueError, "autoreset is 'never': there are same_step, next_step and disabled", make, 1, autoreset="never")
        self.refuses(ValueError, "episode_steps is -5", make, 1, episode_steps=-5)
        self.refuses(TypeError, "", make, "two")

    def test_close(self):
        with cca_test_pole.pole(1) as env:
            env.reset(seed=1)
            self.assertFalse(env.closed)
        self.assertTrue(env.closed)
        self.refuses(RuntimeError, "this environment is closed", env.reset)
        env.close()


class Weights(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = str(pathlib.Path(folder.name) / "pole.policy")
        self.layers = [(numpy.arange(6.0).reshape(3, 2), numpy.array([6.0, 7, 8])), (numpy.array([[0.5, 1.5, 2.5]]), numpy.array([9.0]))]

    def test_round_trip(self):
        env = cca_test_pole.pole
        self.assertEqual((env.policy_layers, env.policy_activation), ((2, 3, 1), "tanh"))
        env.save_policy(self.file, self.layers, scale=numpy.array([2.0, 3.0]), offset=numpy.array([0.1]))
        back = env.load_policy(self.file)
        for (matrix, bias), (a, b) in zip(self.layers, back["layers"]):
            numpy.testing.assert_array_equal(matrix, a)
            numpy.testing.assert_array_equal(bias, b)
        self.assertEqual([back[k].tolist() for k in ("centre", "scale", "offset", "gain")], [[0, 0], [2, 3], [0.1], [1]])
        env.save_policy(pathlib.Path(self.file), self.layers)
        numpy.testing.assert_array_equal(env.load_policy(pathlib.Path(self.file))["layers"][1][1], [9.0])
        self.assertIn("number 0, joint, rad from -3 to 3", pathlib.Path(self.file).read_text())

    def test_mistakes(self):
        save = cca_test_pole.pole.save_policy
        (first, bias), last = self.layers
        for error, text, layers in (
                (ValueError, "this policy has 2 layers, not 1", [last]),
                (ValueError, r"the matrix of layer 0 has the shape \(2, 3\), and \(3, 2\) is expected", [(first.T, bias), last]),
                (ValueError, r"the bias of layer 0 has the shape \(1,\), and \(3,\)", [(first, bias[:1]), last]),
                (ValueError, "layer 1 is no pair", [(first, bias), (bias,)]),
                (ValueError, "not written", [(first * numpy.nan, bias), last]),
                (TypeError, "the matrix of layer 0 is an array of int64", [(first.astype(int), bias), last])):
            with self.assertRaisesRegex(error, text):
                save(self.file, layers)
        self.assertFalse(pathlib.Path(self.file).exists())
        with self.assertRaisesRegex(ValueError, "none.policy"):
            cca_test_pole.pole.load_policy(self.file.replace("pole", "none"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
