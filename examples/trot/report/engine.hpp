#pragma once
// The option --engine: in which physics the robot is. A controller is a type, so the engine is chosen before
// the options are read; a word that names none is refused when they are.
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <cca/main/command_line.hpp>

namespace trot {

enum class engine : std::uint8_t { ode, compiled };
inline constexpr std::array<std::string_view, 2> engine_names{"ode", "compiled"};

inline std::string name_of(engine e) { return std::string(engine_names[static_cast<std::size_t>(e)]); }

// `--engine E` or `--engine=E`.
inline engine engine_in(int count, const char* const* words) {
  constexpr std::string_view option = "--engine";
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    if (!word.starts_with(option)) continue;
    const std::string_view rest = word.substr(option.size());
    const std::string_view name = !rest.empty()   ? rest.substr(rest[0] == '=' ? 1 : 0)
                                  : i + 1 < count ? std::string_view(words[i + 1])
                                                  : std::string_view();
    for (std::size_t e = 0; e < engine_names.size(); ++e)
      if (name == engine_names[e]) return static_cast<engine>(e);
  }
  return engine::ode;
}

template <class Into>
void offer_engine(cca::command_line& line, Into&& into) {
  line.one_of("--engine E", into, engine_names,
              "the physics: ode, the Open Dynamics Engine, or compiled (ode)");
}
inline void offer_engine(cca::command_line& line) {  // for a program that engine_in() has chosen
  offer_engine(line, [](std::size_t) {});
}

}  // namespace trot
