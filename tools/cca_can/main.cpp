// cca-can: CAN buses and the drives on them, by hand. docs/cca_can.md; `cca-can help`.
#include <exception>
#include <iostream>

#include <unistd.h>

#include <cca/hardware/socket_can.hpp>

#include "commands.hpp"

int main(int count, char** arguments) {
  cca_can::wall_pace time;
  cca_can::console say{std::cout, std::cerr, std::cin, false, isatty(STDIN_FILENO) == 1};
  const auto open = [](const std::string& name, bool fd) {
    return cca::hardware::socket_can(name, {.fd = fd, .most_in_flight = 64});
  };
  try {
    return cca_can::run_and_tell({arguments + 1, arguments + count}, open, time, say);
  } catch (const std::exception& e) {
    std::cerr << "cca-can: " << e.what() << '\n';
    return cca_can::refused;
  }
}
