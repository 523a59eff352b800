#pragma once
// Writes a file, or says that it can't be written: then an older one stays.
#include <ostream>
#include <sstream>
#include <string>

#include <cca/base/system/output_file.hpp>

namespace trot {

template <class Write>
void write(const std::string& name, Write content) {
  std::ostringstream text;
  content(text);
  cca::output_file file(name);
  try {
    file.write(text.view());
    file.keep();
  } catch (...) {
    file.discard();
    throw;
  }
}

}  // namespace trot
