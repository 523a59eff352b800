// The contract as JSON and as a module of Python, for the program that trains.
#pragma once

#include <cca/mapping/imported/policy_description.hpp>

#include "writing.hpp"

namespace cca_policy {

inline std::string contract_json(const imported& p) {
  const contract& c = p.terms;
  const auto of_range = [](const range& r) { return cca::policy_range{r.lower, r.upper}; };
  const auto of_term = [&](const term& t) {
    cca::described_term d{t.name, t.is, {}, of_range(t.clip), of_range(t.target_clip), t.clips_scaled};
    for (const auto& n : t.numbers) d.numbers.push_back({n.name, "", n.rest, n.scale, n.sign, {}});
    return d;
  };
  cca::policy_description d{c.name,       c.rate,       c.joints, c.stiffness, c.damping, c.history,
                            c.layout,     c.order,      c.start,  {},          {},        c.observes_clipped,
                            p.net.inputs, p.net.outputs};
  for (const term& t : c.terms) d.terms.push_back(of_term(t));
  d.action = of_term(c.action);
  return cca::json_of(d);
}

// What a trainer needs beside the numbers: the metadata of its ONNX file, and the map that says the rest.
inline constexpr const char* python_functions = R"py(
JOINTS = CONTRACT["joints"]
OBSERVATIONS = [one["name"] for one in CONTRACT["observations"]]
RATE = CONTRACT["rate"]  # Hz


def _texts(numbers):
    return ",".join(repr(float(n)) for n in numbers)


def metadata(default_joint_pos, action_scale, joint_stiffness=None, joint_damping=None):
    """The metadata of an ONNX file, for onnx.helper.set_model_props: each number in the order of JOINTS."""
    numbers = {
        "default_joint_pos": default_joint_pos, "action_scale": action_scale,
        "joint_stiffness": CONTRACT["stiffness"] if joint_stiffness is None else joint_stiffness,
        "joint_damping": CONTRACT["damping"] if joint_damping is None else joint_damping}
    for name, all_numbers in numbers.items():
        if len(all_numbers) != len(JOINTS):
            raise ValueError(f"{name} has {len(all_numbers)} numbers, and there are {len(JOINTS)} joints")
    return {"joint_names": ",".join(JOINTS), "observation_names": ",".join(OBSERVATIONS), **{name: _texts(n) for name, n in numbers.items()}}


def map_text(relative_to_default=(), normaliser="inside", last_action="raw", scale=None, clip=None):
    """The map for `cca-policy import`: what the robot's types say, and how the training saw it.

    relative_to_default: names of observations from which the default positions are subtracted, and "action".
    scale, clip: a number, and [lower, upper], of an observation by its name; 1 and none if not said.
    """
    def clip_of(name, said):
        found = (clip or {}).get(name, said)
        return f"[{float(found[0])!r}, {float(found[1])!r}]" if len(found) else '"none"'

    def relative(name, what):
        return [f'relative_to = "{"default" if name in relative_to_default else "zero"}"'] if what == "joint_angles" else []

    unknown = set(relative_to_default) - set(OBSERVATIONS) - {"action"} | set(scale or {}) - set(OBSERVATIONS) | set(clip or {}) - set(OBSERVATIONS) - {"action"}
    if unknown:
        raise ValueError(f"there is no observation {', '.join(sorted(unknown))}; there are {', '.join(OBSERVATIONS)}")
    history = CONTRACT["history"]
    lines = [f"rate = {RATE!r}", "", "[history]", f'length = {history["length"]}']
    lines += [f'{key} = "{history[key]}"' for key in ("layout", "order", "start")]
    for one in CONTRACT["observations"]:
        lines += ["", f'[observation.{one["name"]}]', f'is = "{one["is"]}"']
        if one["is"] == "last_action":
            pass
        elif one["is"].startswith("orientation"):
            lines.append(f'quaternion = "{"".join(n[1:] for n in one["numbers"])}"')
        elif not one["is"].startswith("joint_"):
            lines.append("numbers = [" + ", ".join(f'"{n}"' for n in one["numbers"]) + "]")
        lines += relative(one["name"], one["is"])
        own = (scale or {}).get(one["name"])
        lines.append(f"scale = {float(own)!r}" if own is not None else f'scale = [{_texts(one["scale"])}]')
        lines.append(f'clip = {clip_of(one["name"], one["clip"])}')
        if clip_of(one["name"], one["clip"]) != '"none"':
            lines.append(f'clips = "{one["clips"]}"')
    action = CONTRACT["action"]
    lines += ["", "[action]", f'is = "{action["is"]}"', *relative("action", action["is"]), f'clip = {clip_of("action", action["clip"])}', f'last_action = "{last_action}"']
    lines += ["", "[network]", f'normaliser = "{normaliser}"', ""]
    return "\n".join(lines)
)py";

inline std::string contract_python(const std::string& name,
                                   const std::string& made_from,
                                   const std::string& json) {
  return "\"\"\"The contract of the policy '" + name + "', from " + made_from +
         " by cca-policy. A term's number is sign * (q - rest), clipped, times scale.\"\"\"\n\nCONTRACT = " +
         json + python_functions;
}

}  // namespace cca_policy
