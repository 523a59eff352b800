// The network of a file: which inputs it has, what each node does, and what comes out.
#pragma once

#include "operators.hpp"

namespace cca_policy {

using operator_list = std::map<std::string, std::function<void(operators&)>>;

// Every operator that can be read. docs/policies.md lists them.
inline const operator_list& all_operators() {
  static const operator_list list{
      {"Abs", [](operators& o) { o.unary("magnitude"); }},
      {"Add", [](operators& o) { o.sum(); }},
      {"BatchNormalization", [](operators& o) { o.batch_norm(); }},
      {"Cast", [](operators& o) { o.cast(); }},
      {"Clip", [](operators& o) { o.clip(); }},
      {"Concat", [](operators& o) { o.concat(); }},
      {"Constant", [](operators& o) { o.constant(); }},
      {"Div", [](operators& o) { o.arithmetic("over", std::divides<>()); }},
      {"Dropout", [](operators& o) { o.identity(); }},
      {"Elu", [](operators& o) { o.unary("elu", ", " + text_of(o.real("alpha", 1))); }},
      {"Flatten", [](operators& o) { o.flatten(); }},
      {"GRU", [](operators& o) { o.recurrent(3); }},
      {"Gather", [](operators& o) { o.gather(); }},
      {"Gemm", [](operators& o) { o.gemm(); }},
      {"Identity", [](operators& o) { o.identity(); }},
      {"LSTM", [](operators& o) { o.recurrent(4); }},
      {"LayerNormalization", [](operators& o) { o.layer_norm(); }},
      {"LeakyRelu", [](operators& o) { o.unary("leaky_relu", ", " + text_of(o.real("alpha", 0.01))); }},
      {"LpNormalization", [](operators& o) { o.lp_norm(); }},
      {"MatMul", [](operators& o) { o.matmul(); }},
      {"Mul", [](operators& o) { o.arithmetic("times", std::multiplies<>()); }},
      {"Neg", [](operators& o) { o.unary("negative"); }},
      {"Pow", [](operators& o) { o.power(); }},
      {"ReduceL2", [](operators& o) { o.reduce("length"); }},
      {"ReduceMean", [](operators& o) { o.reduce("mean"); }},
      {"ReduceSum", [](operators& o) { o.reduce("total"); }},
      {"Relu", [](operators& o) { o.unary("relu"); }},
      {"Reshape", [](operators& o) { o.reshape(); }},
      {"Shape", [](operators& o) { o.shape_of(); }},
      {"Sigmoid", [](operators& o) { o.unary("sigmoid"); }},
      {"Slice", [](operators& o) { o.slice(); }},
      {"Softmax", [](operators& o) { o.softmax(); }},
      {"Split", [](operators& o) { o.split(); }},
      {"Sqrt", [](operators& o) { o.unary("root"); }},
      {"Squeeze", [](operators& o) { o.squeeze(); }},
      {"Sub", [](operators& o) { o.arithmetic("minus", std::minus<>()); }},
      {"Swish", [](operators& o) { o.unary("silu"); }},
      {"Tanh", [](operators& o) { o.unary("tangent"); }},
      {"Transpose", [](operators& o) { o.transpose(); }},
      {"Unsqueeze", [](operators& o) { o.unsqueeze(); }},
  };
  return list;
}

inline void lowering::node_by_name() {
  const node& n = *here_;
  if (!n.domain.empty() && n.domain != "ai.onnx")
    refuse("the operator " + n.domain.substr(0, 80) + "." + n.op.substr(0, 80) + " (node " +
           std::to_string(at_) + ") is not one of ONNX: export with its operators alone");
  const auto found = all_operators().find(n.op);
  if (found == all_operators().end())
    refuse("the operator " + n.op.substr(0, 80) + " (node " + std::to_string(at_) +
           ") is not known here; docs/policies.md lists those that are");
  if (n.has_graph) refuse_here("it contains a graph, which is not possible");
  operators run{*this};
  found->second(run);
  made_.operators.push_back(n.op);
}

inline std::string lowering::memory_output(const std::string& input) const {
  for (const auto& [in, out] : options_.memory)
    if (in == input) return out;
  if (!input.ends_with("_in")) return {};
  const std::string out = input.substr(0, input.size() - 2) + "out";
  return std::ranges::any_of(model_.outputs, [&](const value_info& o) { return o.name == out; })
             ? out
             : std::string();
}

inline void lowering::graph_inputs() {
  std::set<std::string> constants;
  for (const tensor& t : model_.initializers) constants.insert(t.name);
  std::int64_t kept = 0;
  for (const value_info& i : model_.inputs) {
    if (constants.contains(i.name)) continue;  // older exporters list them as inputs, too
    value v;
    v.dims = i.dims;
    for (std::size_t d = 0; d < v.dims.size(); ++d) {
      if (v.dims[d] == -1 && d == 0) v.dims[d] = 1;  // a batch of any size is of one
      if (v.dims[d] < 1) refuse("the input `" + i.name + "` has no fixed shape: export it with one");
    }
    if (i.type != 1 && i.type != 11)
      refuse("the input `" + i.name + "` has no numbers of type float or double");
    const std::int64_t count = count_of(v.dims);
    if (count < 1 || count > most_computed) refuse("the input `" + i.name + "` is " + in_words(v.dims));
    if (const std::string out = memory_output(i.name); !out.empty() && i.name != options_.observations) {
      v.variable = "v" + std::to_string(++variables_);
      lines_.push_back(
          {v.variable, "part<" + std::to_string(kept) + ", " + std::to_string(count) + ">(kept)"});
      memory_.push_back({out, count});
      kept += count;
    } else if (options_.observations.empty() ? made_.observations.empty() : i.name == options_.observations) {
      made_.observations = i.name;
      made_.inputs = static_cast<int>(count);
      v.variable = "observed";
      if (!options_.mean.empty()) {
        if (static_cast<std::int64_t>(options_.mean.size()) != count ||
            options_.deviation.size() != options_.mean.size())
          refuse("the normaliser of the map has " + std::to_string(options_.mean.size()) +
                 " numbers, and the input `" + i.name + "` " + std::to_string(count));
        v.variable = "v" + std::to_string(++variables_);
        here_ = &model_.nodes.front();
        const std::string size = std::to_string(count), mean = stored(options_.mean),
                          by = stored(options_.deviation);
        lines_.push_back({v.variable, "over(minus(observed, vector<" + size + ">(" + mean + ")), vector<" +
                                          size + ">(" + by + "))"});
      }
    } else {
      refuse("the input `" + i.name + "` is neither the observation" +
             (made_.observations.empty() ? "" : " `" + made_.observations + "`") +
             " nor a memory with an output of its own: name the observation in the map "
             "(network.observations), or the "
             "output that gives the memory of the next beat (memory." +
             i.name + ")");
    }
    if (!values_.emplace(i.name, std::move(v)).second) refuse("two inputs are named `" + i.name + "`");
  }
  if (made_.observations.empty())
    refuse(options_.observations.empty() ? "the network has no input"
                                         : "the network has no input `" + options_.observations + "`");
  made_.memory = static_cast<int>(kept);
}

// The first operation on the observation has a constant for each of its numbers.
inline void lowering::find_normaliser() {
  std::string name = made_.observations;
  for (const node& n : model_.nodes) {
    if (std::ranges::find(n.inputs, name) == n.inputs.end()) continue;
    if ((n.op == "Identity" || n.op == "Flatten" || n.op == "Reshape" || n.op == "Cast" ||
         n.op == "Squeeze" || n.op == "Unsqueeze") &&
        !n.outputs.empty() && n.inputs[0] == name) {
      name = n.outputs[0];
      continue;
    }
    const auto is_for_each = [&](const std::string& other) {
      const auto found = values_.find(other);
      return found != values_.end() && found->second.is_constant && found->second.count() == made_.inputs;
    };
    made_.begins_with_normaliser =
        n.op == "BatchNormalization" || ((n.op == "Sub" || n.op == "Div" || n.op == "Mul" || n.op == "Add") &&
                                         std::ranges::any_of(n.inputs, is_for_each));
    return;
  }
}

inline network lowering::run() {
  if (model_.nodes.size() > 10000) refuse("the network has more than 10,000 nodes");
  graph_inputs();
  for (const tensor& t : model_.initializers) {
    made_.is_double = made_.is_double || t.is_double;
    if (!values_.emplace(t.name, operators::of(t)).second) refuse("two tensors are named `" + t.name + "`");
  }
  for (const node& n : model_.nodes) {
    here_ = &n;
    node_by_name();
    ++at_;
  }
  std::set<std::string> remembered;
  for (const auto& one : memory_) remembered.insert(one.first);
  for (const value_info& o : model_.outputs)
    if (!remembered.contains(o.name)) {
      if (!options_.actions.empty() ? o.name != options_.actions : !made_.actions.empty()) {
        if (!options_.actions.empty()) continue;
        refuse("the outputs `" + made_.actions + "` and `" + o.name +
               "` may both be the actions: name them in the map (network.actions)");
      }
      made_.actions = o.name;
    }
  if (made_.actions.empty()) refuse("the network has no output for the actions");
  const auto result = [&](const std::string& name) -> const value& {
    const auto found = values_.find(name);
    if (found == values_.end() || found->second.is_constant)
      refuse("the output `" + name + "` does not depend on the observation");
    return found->second;
  };
  const value& actions = result(made_.actions);
  made_.outputs = static_cast<int>(actions.count());
  for (const line& one : lines_) made_.code += "    const auto " + one.left + " = " + one.right + ";\n";
  if (!memory_.empty()) {
    std::string text;
    for (const auto& [name, count] : memory_) {
      if (result(name).count() != count)
        refuse("the memory `" + name + "` goes out larger or smaller than it comes in");
      text += (text.empty() ? "" : ", ") + result(name).variable;
    }
    made_.code += "    kept = joined(" + text + ");\n";
  }
  made_.code += "    return " + actions.variable + ";\n";
  for (const double w : weights_)
    if (!std::isfinite(w)) refuse("a weight is no finite number");
  made_.weights = weights_;
  find_normaliser();
  return made_;
}

}  // namespace cca_policy
