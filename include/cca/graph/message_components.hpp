// Messages about a node alone: its name, its functions, hooks, parameters, spaces and strategy.
#pragma once

#include <cca/graph/names.hpp>
#include <cca/graph/telling.hpp>

namespace cca::detail {

constexpr void tell_unknown_item(auto& t) {
  t.where << t.graph().name;
  t.say() << "`" << t.item().unknown_type << "` in " << t.graph().name
          << " is no item of a graph, so it would be passed over: write cca::node<`name`, type> for a "
             "component or graph; the others are cca::wire, "
             "cca::expose, cca::observe, cca::rate and cca::require<cca::latency<...>, cca::beats<N>>";
}

constexpr void tell_bad_name(auto& t) {
  t.at_node();
  if (t.where.size == 0) t.where << t.graph().name;
  auto name = t.found().a == 2 ? t.item().to : t.item().from;
  for (int which = 0; t.found().a == 1 && which < 3; ++which) {
    const auto function = telling::function(*t.item().component, which);
    for (int i = 0; function && i < function->input_count + function->output_count; ++i) {
      const auto& port =
          i < function->input_count ? function->inputs[i] : function->outputs[i - function->input_count];
      if (!port.space || is_name(port.name)) continue;
      name = port.name;
    }
  }
  if (t.found().a == 0) t.say() << "a node of " << t.graph().name;
  if (t.found().a == 2) t.say() << "a port that " << t.graph().name << " exposes";
  if (t.found().a == 1) {
    t.say() << "a port of ";
    t.node();
  }
  if (name.empty()) t.say() << " has no name, so no wire could name it: give it one";
  else
    t.say()
        << " is named `" << name
        << "`, but names are joined by dots to paths, and `*` stands for any of them: use neither in a name";
}

constexpr void tell_no_fires(auto& t) {
  t.at_node();
  t.node();
  t.say() << " has the strategy `" << t.item().unknown_type
          << "`, which cannot say when it fires: use one like cca::timed<10> or cca::moderate, or give it "
             "`template <class Inputs> static bool "
             "fires(cca::beat, const Inputs&)`";
}

constexpr void tell_duplicate_name(auto& t) {
  t.at_node();
  if (t.found().a == 1) {
    t.say() << "two outputs are exposed as `" << t.item().to << "` by " << t.graph().name
            << ": give one of them another name";
    return;
  }
  t.say() << "two nodes of " << t.graph().name << " are named `" << t.item().from << "`";
  const char* separator = " (";
  for (int i = 0; i < t.graph().count; ++i) {
    const auto& other = t.graph().items[i];
    if (other.from != t.item().from || (!other.component && !other.inner)) continue;
    t.say() << separator << (other.component ? other.component->name() : other.inner->name);
    separator = ", ";
  }
  t.say() << "), so a path to them has two meanings: give one of them another name";
}

constexpr void tell_arity(auto& t) {
  t.at_node();
  t.node();
  t.say() << " " << t.item().component->wrong_arity;
}

constexpr void tell_no_process(auto& t) {
  t.at_node();
  t.node();
  if (t.found().a == 1)
    t.say() << " has both `process` and `" << (t.item().component->also_sense ? "sense" : "act")
            << "`: a component has `process`, a resource node has `sense` and `act`; make two nodes of it";
  else if (t.found().a == 2)
    t.say() << " is const, and what a component holds changes as it runs: leave the `const` out";
  else
    t.say() << " has no `process` from which its ports could be read: give it one, public, neither "
               "overloaded nor a template, as in "
               "`auto process(cca::in<...>) -> cca::out<...>`; a resource node has `sense` and `act` instead";
}

// Of the inputs or the outputs of all its functions, the first name that stands twice.
constexpr std::string_view repeated_port(const component_info& c, bool outputs) {
  const auto ports = [&](const function_info& h) { return outputs ? h.outputs : h.inputs; };
  const auto count = [&](const function_info& h) { return outputs ? h.output_count : h.input_count; };
  for (int h = 0; h < 3; ++h)
    for (int earlier = 0; earlier <= h; ++earlier) {
      const function_info *a = telling::function(c, h), *b = telling::function(c, earlier);
      for (int i = 0; a && b && i < count(*a); ++i)
        for (int j = 0; j < (a == b ? i : count(*b)); ++j)
          if (ports(*a)[i].name == ports(*b)[j].name) return ports(*a)[i].name;
    }
  return {};
}

constexpr void tell_bad_signature(auto& t, bool parameter) {
  const auto& c = *t.item().component;
  t.at_node();
  t.node();
  if (t.found().b == 1) {
    t.say() << " has two " << (parameter ? "inputs" : "outputs") << " named `" << repeated_port(c, !parameter)
            << "`, so a wire to it would have two meanings: give one of them another name";
    return;
  }
  constexpr std::string_view functions[] = {"sense", "process", "act"};
  for (int which = 0; which < 3; ++which) {
    const auto function = telling::function(c, which);
    if (!function || (parameter ? function->bad_parameter : function->bad_result).empty()) continue;
    t.say() << ": `" << functions[which] << (parameter ? "` takes `" : "` returns `")
            << (parameter ? function->bad_parameter : function->bad_result);
    if (parameter)
      t.say() << "`, but it may take only ports (cca::in, cca::optional_in, cca::observe) and the cca::beat, "
                 "each by value or by reference to "
                 "const; give constants as `parameters`, and data of other components by a wire";
    else
      t.say() << "`, but it may return only ports (cca::out, cca::maybe) and a cca::fault, one or several in "
                 "a std::tuple, or void";
    return;
  }
}

constexpr void tell_hook(auto& t) {
  t.at_node();
  t.node();
  const auto hook = t.item().component->bad_hook;
  t.say() << " has a hook `" << hook << "` that would never be called, for it is not `void " << hook
          << "()`: make it a public function of that signature, or give it another name";
}

constexpr void tell_parameters(auto& t) {
  t.at_node();
  t.node();
  const auto& c = *t.item().component;
  if (c.forgot_parameters) {
    t.say() << " has a struct `parameters` but no public member `parameters p`, so nothing would ever set "
               "them: add `parameters p{...};` with the "
               "default values";
    return;
  }
  t.say() << ": its parameter `" << c.bad_field << "` is a `" << c.bad_field_type << "`";
  if (c.bad_field == "p")
    t.say() << ", of which nothing is known: name its fields in it with BOOST_HANA_DEFINE_STRUCT, and let it "
               "be copied";
  else
    t.say() << ", which no file can hold: use a number, bool, enum class, cca::bounded, cca::quantity, "
               "cca::text, a std::array or Eigen "
               "vector of fixed size of these, or a struct with BOOST_HANA_DEFINE_STRUCT";
}

constexpr void tell_duplicate_axis(auto& t) {
  const auto one = [&](const auto& port) {
    t.at(port);
    const auto& space = t.space(port);
    t.say() << "the space " << space.name << " of ";
    t.port(port);
    t.say() << " has the axis `" << space.axes[space.duplicate_axis]
            << "` twice, so reading along it has two meanings: name each axis once in cca::axes<...>";
  };
  if (t.found().b == 1) one(t.g.outputs[t.found().a]);
  else one(t.g.inputs[t.found().a]);
}

constexpr void tell_unknown_trigger(auto& t) {
  t.at_node();
  t.node();
  t.say() << " is cca::port_triggered by `" << t.unknown_trigger << "`, but it has no such input";
  std::string_view best;
  std::size_t least = 64;
  for (int which = 0; which < 3; ++which) {
    const auto function = telling::function(*t.item().component, which);
    for (int p = 0; function && p < function->input_count; ++p)
      if (const auto distance = edit_distance(t.unknown_trigger, function->inputs[p].name);
          distance < least) {
        least = distance;
        best = function->inputs[p].name;
      }
  }
  if (!best.empty()) t.say() << "; did you mean `" << best << "`?";
  else t.say() << ": it has none at all";
}

constexpr void tell_misplaced(auto& t) {
  t.at_node();
  t.node();
  if (t.item().inner)
    t.say() << " is a graph, and a strategy stands on components: give it to the nodes inside";
  else
    t.say() << " is a resource node, which runs at fixed beats: it may be cca::timed, cca::full_speed or "
               "cca::inactive";
}

}  // namespace cca::detail
