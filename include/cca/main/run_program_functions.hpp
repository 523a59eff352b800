// What each program does around its work. run_program.hpp includes this, unless they are compiled
// once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/main/run_program.hpp>
#include <cca/version.hpp>

namespace cca {

CCA_MAIN_INLINE std::string program_name(int count, char** words) {
  const std::string path = count > 0 ? words[0] : "program";
  return path.substr(path.rfind('/') + 1);
}

CCA_MAIN_INLINE int detail::run_program(int count,
                                        char** words,
                                        command_line& line,
                                        function_ref<int()> act) {
  const std::string name = program_name(count, words);
  const std::vector<std::string> arguments(words + std::min(count, 1), words + count);
  const auto asks_for = [&](const char* word) {
    return std::ranges::find(arguments, word) != arguments.end();
  };
  if (asks_for("--help") || asks_for("-h")) return std::cout << line.help(name), exit_code::done;
  if (asks_for("--version")) {
    std::cout << name << " (cca " << version_major << '.' << version_minor << '.' << version_patch << ")\n";
    return exit_code::done;
  }
  const auto tell = [&name](const std::exception& e) { std::cerr << name << ": " << e.what() << '\n'; };
  const auto acted = [&] {
    const int code = line.work_instead() ? line.work_instead()() : act();
    std::cout.flush();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      std::cerr << name + ": what it printed is not complete: its standard output is closed or full\n";
    return code;
  };
  try {
    line.parse(arguments);
    return acted();
  } catch (const command_line_error& e) {
    return tell(e), exit_code::refused;
  } catch (const cca::refused& e) { return tell(e), exit_code::refused; } catch (const std::exception& e) {
    return tell(e), exit_code::error;
  }
}

}  // namespace cca
