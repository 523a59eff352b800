// A recording in a page: one HTML file, which opens in a browser without server and network.
//
//   cca::recording::write_page("trot.html", "trot.mcap", cca::recording::page_without_recording());
//
// The page without a recording is page/recording.html of cca. It is where the target cca::record says, in the
// sources of cca or in the folder share/cca of an installed one; else, on a robot that has only the program,
// it is the file cca_page.html beside that. Errors: cca::refused if it is missing or is none,
// std::system_error if a file can't be read or written. An HTML file of this name is replaced when the new
// one is complete. Tests: tests/runtime/record/page.cpp, tests/consumers/page.cmake; docs/page.md.
#pragma once

#include <string>

#include <cca/base/separate/compiled.hpp>

namespace cca::recording {

// The page without a recording. `page_of_cca` is empty where there is none, the other throws cca::refused.
std::string page_of_cca();
std::string page_without_recording();

void write_page(const std::string& page, const std::string& recording, const std::string& from);

}  // namespace cca::recording

#if !CCA_HAS_COMPILED_RECORD
#include <cca/record/page_functions.hpp>
#endif
