#pragma once
// Writes a file, or says that it can't be written.
#include <fstream>
#include <stdexcept>
#include <string>

namespace trot {

template <class Write>
void write(const std::string& name, Write content) {
  std::ofstream file(name);
  if (file) content(file);
  file.close();
  if (!file) throw std::runtime_error(name + ": cannot be written");
}

}  // namespace trot
