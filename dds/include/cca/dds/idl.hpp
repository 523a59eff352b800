// The types of spaces as IDL, for programs that share no code with cca.
//
//   std::ofstream("leg.idl") << cca::idl<leg_angles, trunk_pose>();
//
// From this text a code generator, such as Cyclone's `idlc`, makes the types of a program in C, C++, Python
// or another language. The program exchanges samples with `cca::dds::publisher` and `cca::dds::subscriber` of
// these spaces. Page: docs/dds.md.
//
// A space `robot::leg_angles` becomes the struct `cca::robot_leg_angles_sample`, and its number the constant
// `cca::robot_leg_angles_space`. A coordinate `hip` becomes the field `hip_`, so that none can be a word of a
// language. Where coordinates have no names, or more than 64, or two that differ only in case, there is one
// field `values` instead. Units and limits stand in comments.
#pragma once

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/refused.hpp>
#include <cca/base/type_name.hpp>
#include <cca/dds/space_message.hpp>
#include <cca/version.hpp>

namespace cca {

namespace dds::detail {

// Letters, digits and single underscores between them.
inline std::string identifier(std::string_view text) {
  std::string word;
  for (const char c : text) {
    const bool is_letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (is_letter) word += c;
    else if (!word.empty() && word.back() != '_') word += '_';
  }
  while (word.ends_with('_')) word.pop_back();
  return word;
}

// Up to the next `::` that is outside of brackets.
inline std::size_t end_of_name(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '<' || text[i] == '(') ++depth;
    if (text[i] == '>' || text[i] == ')') --depth;
    if (depth == 0 && text.substr(i).starts_with("::")) return i;
  }
  return text.size();
}
// As every compiler spells it: without namespaces that have no name, and a text as argument is its letters.
// `of<left::leg, -1>` still differs from `of<right::leg, 1>`, because their samples must not meet.
inline std::string plain_spelling(std::string_view spelled) {
  std::string all(spelled);
  const auto replace = [&](std::string_view what, std::string_view by) {
    for (std::size_t at; (at = all.find(what)) != all.npos;) all.replace(at, what.size(), by);
  };
  for (const std::string_view nameless : {"(anonymous namespace)::", "{anonymous}::"}) replace(nameless, "");
  replace("-", " minus ");
  constexpr std::string_view text = "cca::fixed_string<";
  for (std::size_t at; (at = all.find(text)) != all.npos;) all.erase(at, all.find('>', at) + 1 - at);
  return all;
}
// A space's name with its namespaces, with `between` between them.
inline std::string joined_name(std::string_view spelled, const char* between) {
  const std::string plain = plain_spelling(spelled);
  const std::string_view last = cca::detail::without_namespaces(plain);
  std::string all;
  for (std::string_view rest = std::string_view(plain).substr(0, plain.size() - last.size());
       !rest.empty();) {
    const std::size_t end = end_of_name(rest);
    all += identifier(rest.substr(0, end)) + between;
    rest.remove_prefix(std::min(end + 2, rest.size()));
  }
  return all + identifier(last);
}
template <class Space>
std::string name_in_idl() {
  return joined_name(cca::detail::spelled<Space>(), "_");
}
template <class Space>
std::string type_in_dds() {
  return "cca::" + name_in_idl<Space>() + "_sample";
}
// The topic of a space's samples, unless another one is named.
template <class Space>
std::string topic_of_space() {
  return joined_name(cca::detail::spelled<Space>(), "/");
}

inline std::string field_in_idl(std::string_view name) {
  const bool begins_well = std::isalpha(static_cast<unsigned char>(name.front())) != 0;
  return (begins_well ? "" : "c") + std::string(name) + "_";
}

// Whether each coordinate gets a field of its own.
inline bool has_fields(const space_schema& of, bool has_names) {
  constexpr int most_fields = 64;
  if (!has_names || of.field_count() > most_fields) return false;
  std::set<std::string> known;
  for (int i = 0; i < of.field_count(); ++i) {
    std::string name = field_in_idl(of.field(i).name());
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!known.insert(name).second) return false;
  }
  return true;
}

// ", rad, -0.9 to 0.9"
inline std::string about_field(const schema_field& f) {
  std::ostringstream text;
  if (!f.unit.empty()) text << ", " << f.unit;
  if (f.lower > -std::numeric_limits<double>::infinity() || f.upper < std::numeric_limits<double>::infinity())
    text << ", " << f.lower << " to " << f.upper;
  return text.str();
}

template <class Space>
std::string idl_of_space() {
  const space_schema schema(cca::detail::space_of<Space>);  // of a picture, too long for constexpr
  constexpr bool has_names =
      Space::size == Space::axes::count || requires { Space::domain::coordinates.data(); };
  const std::string name = name_in_idl<Space>();
  std::ostringstream all;
  all << "// " << cca::detail::type_name<Space>() << ": " << schema.domain();
  if (schema.hz() > 0) all << ", " << schema.hz() << " Hz";
  all << "; topic \"" << topic_of_space<Space>()
      << "\", if the node names no other\nmodule cca {\n  const long long " << name
      << "_space = " << space_number<Space>()
      << ";  // domain type, names, units, limits and rate\n  @final struct " << name
      << "_sample {\n    long long space;  // " << name
      << "_space, else it is refused\n    long long age;  // ns from its origin until it is sent\n";
  const bool each = has_fields(schema, has_names);
  constexpr int most_lines = 256;
  for (int i = 0; has_names && i < schema.field_count() && schema.field_count() <= most_lines; ++i) {
    const schema_field f = schema.field(i);
    const std::string about = about_field(f);
    if (!each) all << "    // " << i << ": " << f.name() << about << "\n";
    else if (about.empty()) all << "    double " << field_in_idl(f.name()) << ";\n";
    else all << "    double " << field_in_idl(f.name()) << ";  // " << about.substr(2) << "\n";
  }
  if (!each) all << "    double values[" << schema.field_count() << "];\n";
  all << "  };\n};\n";
  return all.str();
}

// The spaces of one text.
class spaces_in_idl {
public:
  // False: it is there.
  template <class Space>
  bool add() {
    const std::string own{cca::detail::spelled<Space>()};
    std::string name = name_in_idl<Space>();
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const auto [one, is_new] = spelled.emplace(name, own);
    if (!is_new && one->second != own)
      throw refused("cca::idl: `" + one->second + "` and `" + own + "` have one name in IDL, `" +
                    name_in_idl<Space>() + "_sample`: write them into two files, or rename one");
    return is_new;
  }

private:
  std::map<std::string, std::string> spelled;  // by their names in IDL, in small letters
};

template <class Type>
struct no_space {
  static constexpr void tell(auto& m) {
    m << "cca::idl: `" << cca::detail::type_name<Type>()
      << "` is no space: give it a struct derived from cca::space<...>";
  }
};

}  // namespace dds::detail

// A space that is named twice stands there once. Refused: two spaces whose names are one in IDL, which knows
// no difference between `Leg` and `leg`; write them into two files.
template <class... Spaces>
std::string idl() {
  static_assert(sizeof...(Spaces) > 0,
                "cca::idl: name the spaces, as in `cca::idl<leg_angles, trunk_pose>()`");
  static_assert((detail::holds_or_tells<Space<Spaces>, dds::detail::no_space<Spaces>>::value && ...));
  dds::detail::spaces_in_idl known;
  std::string all = "// Written by cca::idl of cca " + std::to_string(version_major) + "." +
                    std::to_string(version_minor) + "." + std::to_string(version_patch) +
                    ". The messages are XCDR1, the publishers reliable and volatile.\n";
  if constexpr ((Space<Spaces> && ...))
    ((known.add<Spaces>() ? void(all += "\n" + dds::detail::idl_of_space<Spaces>()) : void()), ...);
  return all;
}

}  // namespace cca
