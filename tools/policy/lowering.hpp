// Reads the nodes one after the other: each becomes constants, another name, or a line of the function.
// An operator that is not here is refused by its name.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "values.hpp"

namespace cca_policy {

inline std::string text_of(double number) {
  std::array<char, 40> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  return {digits.data(), end};
}

class lowering {
public:
  lowering(const onnx_model& of, const network_options& how) : model_(of), options_(how) {}

  network run();

private:
  friend struct operators;

  // -- names and values
  [[noreturn]] void refuse_here(const std::string& why) const {
    refuse("node " + std::to_string(at_) + ", " + here_->op +
           (here_->name.empty() ? "" : " `" + here_->name.substr(0, 80) + "`") + ": " + why);
  }
  bool has(std::size_t i) const { return i < here_->inputs.size() && !here_->inputs[i].empty(); }
  const value& input(std::size_t i) const {
    if (!has(i)) refuse_here("input " + std::to_string(i) + " is missing");
    const auto found = values_.find(here_->inputs[i]);
    if (found == values_.end())
      refuse_here("its input `" + here_->inputs[i].substr(0, 80) + "` is computed by no node before it");
    return found->second;
  }
  const value& constant(std::size_t i, const char* what) const {
    const value& v = input(i);
    if (!v.is_constant) refuse_here(std::string(what) + " is computed; only constants are possible");
    return v;
  }
  places whole_list(std::size_t i, const char* what) const {
    const value& v = constant(i, what);
    if (!v.is_whole) refuse_here(std::string(what) + " has no integers");
    places all;
    for (const double n : v.numbers) all.push_back(static_cast<std::int64_t>(n));
    return all;
  }
  double real(const char* name, double otherwise) const {
    const auto found = here_->reals.find(name);
    return found == here_->reals.end() ? otherwise : found->second;
  }
  std::int64_t whole(const char* name, std::int64_t otherwise) const {
    const auto found = here_->wholes.find(name);
    return found == here_->wholes.end() ? otherwise : found->second;
  }

  // -- results
  void set(std::size_t output, value v) {
    if (output >= here_->outputs.size() || here_->outputs[output].empty()) return;
    if (v.count() < 0 || v.dims.size() > 8 || (!v.is_constant && v.count() > most_computed))
      refuse_here("its result is " + in_words(v.dims) + ", which is too large");
    if (!values_.emplace(here_->outputs[output], std::move(v)).second)
      refuse_here("`" + here_->outputs[output] + "` is computed twice");
  }
  value computed(const shape& dims, const std::string& text) {
    if (count_of(dims) < 1 || count_of(dims) > most_computed)
      refuse_here("its result is " + in_words(dims) + ", which has no numbers or too many");
    value v;
    v.dims = dims;
    v.variable = "v" + std::to_string(++variables_);
    lines_.push_back({v.variable, text});
    return v;
  }
  std::string stored(const std::vector<double>& numbers) {
    if (weights_.size() + numbers.size() > static_cast<std::size_t>(most_numbers))
      refuse_here("the network has too many weights");
    const std::string at = "w + " + std::to_string(weights_.size());
    weights_.insert(weights_.end(), numbers.begin(), numbers.end());
    return at;
  }
  std::string text_of_value(const value& v) {
    if (!v.is_constant) return v.variable;
    if (v.numbers.empty()) refuse_here("an input has no numbers");
    return "vector<" + std::to_string(v.numbers.size()) + ">(" + stored(v.numbers) + ")";
  }
  void alias(const shape& dims) {
    value v = input(0);
    if (count_of(dims) != v.count()) refuse_here("it makes " + in_words(dims) + " of " + in_words(v.dims));
    v.dims = dims;
    set(0, std::move(v));
  }
  // Some numbers of an input, in another shape.
  void pick(std::size_t output, const value& from, const shape& dims, const places& kept) {
    value v;
    v.dims = dims;
    if (count_of(dims) != static_cast<std::int64_t>(kept.size())) refuse_here("its shapes do not fit");
    if (from.is_constant) {
      v.is_constant = true;
      v.is_whole = from.is_whole;
      for (const std::int64_t k : kept) v.numbers.push_back(from.numbers.at(static_cast<std::size_t>(k)));
      return set(output, std::move(v));
    }
    if (kept.empty()) refuse_here("it takes no numbers");
    const auto size = static_cast<std::int64_t>(kept.size());
    bool in_steps = true;
    const std::int64_t step = size > 1 ? kept[1] - kept[0] : 1;
    for (std::size_t i = 1; i < kept.size(); ++i) in_steps = in_steps && kept[i] - kept[i - 1] == step;
    if (in_steps && step == 1 && size == from.count()) {
      v.variable = from.variable;
      return set(output, std::move(v));
    }
    std::string text;
    if (in_steps && step == 1) text = "part<" + std::to_string(kept[0]) + ", " + std::to_string(size) + ">";
    else if (in_steps)
      text = "every<" + std::to_string(kept[0]) + ", " + std::to_string(step) + ", " + std::to_string(size) +
             ">";
    else {
      if (size > 4096) refuse_here("it takes more than 4096 numbers that do not follow each other");
      for (const std::int64_t k : kept) text += (text.empty() ? "chosen<" : ", ") + std::to_string(k);
      text += ">";
    }
    set(output, computed(dims, text + "(" + from.variable + ")"));
  }
  // How many nodes and outputs read what this variable holds.
  int uses(const std::string& variable) const {
    int count = 0;
    const auto is_it = [&](const std::string& name) {
      const auto found = values_.find(name);
      return found != values_.end() && found->second.variable == variable;
    };
    for (const node& n : model_.nodes)
      for (const std::string& i : n.inputs) count += is_it(i);
    for (const value_info& o : model_.outputs) count += is_it(o.name);
    return count;
  }
  void unary(const std::string& function, const std::string& more = "") {
    const value& x = input(0);
    if (x.is_constant) refuse_here("its input is a constant, which is not expected here");
    set(0, computed(x.dims, function + "(" + x.variable + more + ")"));
  }

  // -- operators, in operators.hpp
  void node_by_name();
  void graph_inputs();
  std::string memory_output(const std::string& input) const;
  void find_normaliser();

  struct line {
    std::string left, right;
  };
  const onnx_model& model_;
  const network_options& options_;
  std::map<std::string, value> values_;
  std::vector<line> lines_;
  std::vector<double> weights_;
  std::vector<std::pair<std::string, std::int64_t>> memory_;  // output of each input, and numbers
  network made_;
  const node* here_ = nullptr;
  std::size_t at_ = 0;
  int variables_ = 0;
};

}  // namespace cca_policy
