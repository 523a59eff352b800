// cca-urdf: from a URDF file to the description of a robot, a header. docs/urdf.md; `cca-urdf --help`.
#include <iostream>
#include <string>
#include <vector>

#include <cca/base/file.hpp>
#include <cca/main/run_program.hpp>
#include <cca/main/one_file.hpp>

#include "conversion.hpp"

namespace {

struct settings {
  std::vector<std::string> files;
  std::string out;
  cca_urdf::options options;
};

int convert(settings& s) {
  if (s.files.empty()) throw cca::command_line_error("expected a URDF file; see --help");
  const std::string& file = s.files[0];
  s.options.header.source = file.substr(file.rfind('/') + 1);
  if (!s.options.header.name_space.empty() && !cca_urdf::is_namespace(s.options.header.name_space))
    throw cca::command_line_error("--namespace " + s.options.header.name_space +
                                  ": expected names of C++ with :: between them, which C does not declare");
  if (!s.out.empty() && cca::is_one_file(s.out, file))
    throw cca::refused("FILE " + file + " and --out " + s.out + " name one file: give the header its own");
  const auto made = cca_urdf::convert(cca::detail::read_file(file), s.options);
  std::cerr << cca_urdf::text_of(made.said, file);
  if (made.header.empty())
    throw cca::refused(file + ": no header is written" +
                       (s.options.strict ? ", since with --strict a note counts as an error" : ""));
  if (s.out.empty()) std::cout << made.header;
  else cca::detail::write_file(s.out, made.header);
  return std::cout.flush() ? cca::exit_code::done : cca::exit_code::error;
}

}  // namespace

int main(int count, char** words) {
  settings s;
  cca::command_line line("writes the robot of a URDF file as the header of its description");
  line.words("FILE", s.files, 1, "the URDF file");
  line.text("--out FILE", s.out, "the header (standard output)");
  line.text("--namespace NAME", s.options.header.name_space, "of the description (the name of the robot)");
  line.flag("--floats", s.options.floats, "nothing holds the base, as of a walking robot");
  line.flag("--touches-itself", s.options.header.touches_itself,
            "its shapes touch each other, but for those of neighbours");
  line.number("--rate HZ", s.options.header.rate, 1, 1e6, "of the ports (1000)");
  line.texts("--end LINK", s.options.ends, "a part ends in this link; may be given again");
  line.flag("--accept-inertia", s.options.accept_inertia,
            "an inertia that no body has becomes the nearest sound one");
  line.flag("--strict", s.options.strict, "writes nothing if something is left out");
  return cca::run_program(count, words, line, [&] { return convert(s); });
}
