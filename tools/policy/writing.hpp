// Writes what was imported: the header of the contract and the network, and the file of the weights.
#pragma once

#include <cca/adaptive/learned_file.hpp>

#include "import.hpp"

namespace cca_policy {

// A text of C++ or of JSON.
inline std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') all += '\\';
    all += static_cast<unsigned char>(c) < 32 ? ' ' : c;
  }
  return all + "\"";
}

inline std::string in_words(const range& r) {
  return r.is_none() ? "none" : text_of(r.lower) + " to " + text_of(r.upper);
}

inline std::string number_text_of(double w, bool in_double) {
  if (in_double) return text_of(w);
  std::array<char, 40> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<float>(w)).ptr;
  return {digits.data(), end};
}

inline std::string weights_text(const imported& p) {
  std::string all;
  for (std::size_t i = 0; i < p.net.weights.size(); ++i)
    all += number_text_of(p.net.weights[i], p.in_double) +
           (i % 10 == 9 || i + 1 == p.net.weights.size() ? "\n" : " ");
  return all;
}

// What header and weights both say, line by line. The first one that differs is the message.
inline std::vector<std::string> contract_lines(const imported& p) {
  const contract& c = p.terms;
  std::vector<std::string> all;
  all.push_back("rate " + text_of(c.rate) + " Hz");
  all.push_back("history " + std::to_string(c.history) +
                (c.history > 1 ? " " + c.layout + " " + c.order + " " + c.start : ""));
  const auto add_term = [&](const term& t, const std::string& kind) {
    all.push_back(kind + " " + t.name + " is " + t.is + ", clip " + in_words(t.clip) +
                  (t.clip.is_none() ? ""
                   : t.clips_scaled ? " after the scale"
                                    : " before the scale"));
    for (const auto& n : t.numbers)
      all.push_back(t.name + ": " + n.name + " rest " + text_of(n.rest) + " scale " + text_of(n.scale) +
                    (n.sign < 0 ? " reversed" : ""));
  };
  for (const term& t : c.terms) add_term(t, "observation");
  add_term(c.action, "action");
  all.push_back("target clip " + in_words(c.action.target_clip) + ", last action " +
                (c.observes_clipped ? "clipped" : "raw"));
  for (std::size_t i = 0; i < c.joints.size(); ++i)
    all.push_back("gains of " + c.joints[i] + ": " + text_of(c.stiffness[i]) + " " + text_of(c.damping[i]));
  all.push_back("network " + std::to_string(p.net.inputs) + " to " + std::to_string(p.net.outputs) +
                " with memory " + std::to_string(p.net.memory) + ", code " +
                cca::detail::checksum_of(p.net.code));
  all.push_back("weights " + cca::detail::checksum_of(weights_text(p)));
  return all;
}

inline std::string weights_file(const imported& p) {
  std::string all = "cca learned 1\nlearner policy " + p.terms.name + "\n";
  for (const std::string& line : contract_lines(p)) all += "contract: " + line + "\n";
  all += "numbers weights " + std::to_string(p.net.weights.size()) + "\n" + weights_text(p);
  return all + "checksum " + cca::detail::checksum_of(all) + "\n";
}

// A policy may have the name of a function, as elu.
inline std::string qualified(const std::string& code) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  std::string all;
  for (std::size_t i = 0; i < code.size();) {
    std::size_t end = i;
    while (end < code.size() && is_letter(code[end])) ++end;
    if (end > i && end < code.size() && (code[end] == '(' || code[end] == '<')) all += "neural::";
    if (end == i) ++end;
    all += code.substr(i, end - i);
    i = end;
  }
  return all;
}

class header {
public:
  explicit header(const imported& p) : p_(p), c_(p.terms) {}

  std::string text() const {
    std::string all = "// The policy '" + c_.name + "', from " + p_.made_from +
                      " by cca-policy. Change these files and import again.\n//\n// observes ";
    for (std::size_t i = 0; i < c_.terms.size(); ++i) all += (i ? ", " : "") + c_.terms[i].name;
    all += "\n// commands " + std::to_string(c_.joints.size()) + " joints at " + text_of(c_.rate) +
           " Hz\n#pragma once\n\n#include <array>\n#include <string_view>\n\n"
           "#include <cca/mapping/imported/imported_policy.hpp>\n#include "
           "<cca/mapping/network/recurrent.hpp>\n\nnamespace " +
           c_.name + " {\n\n";
    return all + network_text() + terms_text() + contract_text() + "}  // namespace " + c_.name + "\n";
  }

private:
  std::string network_text() const {
    const network& n = p_.net;
    const bool uses_weights = n.code.find("w + ") != std::string::npos;
    return "struct network {\n  static constexpr int inputs = " + std::to_string(n.inputs) +
           ", outputs = " + std::to_string(n.outputs) + ", memory = " + std::to_string(n.memory) +
           ", weights = " + std::to_string(n.weights.size()) + ";\n\n" +
           "  template <class Number>\n  static cca::neural::numbers<Number, outputs> answer(\n      " +
           (uses_weights ? "" : "[[maybe_unused]] ") +
           "const Number* w,\n      const cca::neural::numbers<Number, inputs>& observed,\n      " +
           (n.memory > 0 ? "" : "[[maybe_unused]] ") +
           "cca::neural::numbers<Number, memory>& kept) {\n    namespace neural = cca::neural;\n" +
           qualified(n.code) + "  }\n};\n\n";
  }
  static std::string range_text(const char* name, const range& r) {
    return r.is_none() ? ""
                       : std::string("  static constexpr cca::policy_range ") + name + "{" +
                             text_of(r.lower) + ", " + text_of(r.upper) + "};\n";
  }
  static std::string term_text(const term& t, const std::string& id) {
    std::string numbers;
    for (const auto& n : t.numbers)
      numbers +=
          (numbers.empty() ? "" : ",\n      ") + ("{" + quoted(n.name) + ", " + text_of(n.rest) + ", " +
                                                  text_of(n.scale) + ", " + std::to_string(n.sign) + "}");
    return "struct " + id + " {\n  static constexpr std::string_view name = " + quoted(t.name) +
           ", is = " + quoted(t.is) + ";\n  static constexpr std::array<cca::policy_number, " +
           std::to_string(t.numbers.size()) + "> numbers{{  // name, rest, scale, sign\n      " + numbers +
           "}};\n" + range_text("clip", t.clip) +
           (t.clips_scaled ? "  static constexpr bool clips_scaled = true;\n" : "") +
           range_text("seen", t.seen) + range_text("target_clip", t.target_clip);
  }
  static std::string id_of(std::size_t i, const term& t) {
    return "term_" + std::to_string(i) + "_" + cca_urdf::identifier_of(t.name);
  }
  std::string terms_text() const {
    std::string all;
    for (std::size_t i = 0; i < c_.terms.size(); ++i)
      all += term_text(c_.terms[i], id_of(i, c_.terms[i])) + "};\n";
    return all + term_text(c_.action, "action") +
           "  static constexpr bool observed_clipped = " + (c_.observes_clipped ? "true" : "false") +
           ";\n};\n\n";
  }
  std::string contract_text() const {
    std::string names, gains, lines;
    for (std::size_t i = 0; i < c_.terms.size(); ++i) names += (i ? ", " : "") + id_of(i, c_.terms[i]);
    for (std::size_t i = 0; i < c_.joints.size(); ++i)
      gains += (i ? ",\n      " : "") +
               ("{" + quoted(c_.action.numbers[i].name) + ", " + text_of(c_.stiffness[c_.moved[i]]) + ", " +
                text_of(c_.damping[c_.moved[i]]) + "}");
    const auto said = contract_lines(p_);
    for (const std::string& line : said) lines += (lines.empty() ? "" : ",\n      ") + quoted(line);
    return "struct contract {\n  static constexpr std::string_view name = " + quoted(c_.name) +
           ";\n  static constexpr double rate = " + text_of(c_.rate) +
           ";  // Hz\n  using number = " + (p_.in_double ? "double" : "float") +
           ";\n  using network = " + c_.name + "::network;\n  using terms = cca::policy_terms<" + names +
           ">;\n  using action = " + c_.name +
           "::action;\n  static constexpr int history = " + std::to_string(c_.history) +
           ";\n  static constexpr cca::history_layout layout = cca::history_layout::" + c_.layout +
           ";\n  static constexpr cca::history_order order = cca::history_order::" + c_.order +
           ";\n  static constexpr cca::history_start start = cca::history_start::" + c_.start +
           ";\n  static constexpr double oldest = " + (c_.oldest > 0 ? text_of(c_.oldest) : "1e9") +
           ";  // s\n" + "  static constexpr std::array<cca::policy_gains, " +
           std::to_string(c_.joints.size()) + "> gains{{  // name, N m/rad, N m s/rad\n      " + gains +
           "}};\n  static constexpr std::array<std::string_view, " + std::to_string(said.size()) +
           "> lines{\n      " + lines + "};\n};\n\n";
  }

  const imported& p_;
  const contract& c_;
};

// What was imported, for a reader who knows the robot.
inline std::string summary(const imported& p) {
  const contract& c = p.terms;
  std::string joints, seen;
  for (const std::size_t i : c.moved) joints += (joints.empty() ? "" : ", ") + c.joints[i];
  for (const term& t : c.terms)
    seen += (seen.empty() ? "" : ", ") + t.name + " " + std::to_string(t.numbers.size());
  return "the policy `" + c.name + "` at " + text_of(c.rate) + " Hz, from " + p.made_from + "\n  commands " +
         std::to_string(c.joints.size()) + " joints: " + joints + "\n  observes " +
         std::to_string(p.net.inputs / c.history) + " numbers" +
         (c.history > 1 ? ", " + std::to_string(c.history) + " times" : "") + ": " + seen + "\n";
}

}  // namespace cca_policy
