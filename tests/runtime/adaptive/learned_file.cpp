// A learned value goes to a file and back bit for bit, or the file is refused.
#include "rig.hpp"

using namespace adaptive_test;

namespace {

template <int N>
using module_of = cca::dmp_rhythmic_module<leg, stride, N>;
using module = module_of<8>;

struct inputs {
  auto process(cca::beat now) -> std::tuple<cca::out<"phase", cca::over<cca::phase, stride>>,
                                            cca::out<"one", cca::over<cca::amplitude, stride>>,
                                            cca::out<"centre", leg>> {
    return {1e-9 * static_cast<double>(now.time()), 1.0, Eigen::Vector2d(0.1, -0.2)};
  }
};
template <class Module>
struct alone : cca::graph<cca::rate<1000>,
                          cca::node<"in", inputs>,
                          cca::node<"dmp", Module, cca::timed<1>>,
                          cca::wire<"in.phase", "dmp.phase">,
                          cca::wire<"in.one", "dmp.amplitude">,
                          cca::wire<"in.centre", "dmp.reference">> {};

module::learner::learned taught() {
  module::learner::learned known;
  for (int i = 0; i < 200; ++i) {
    const double f = 0.1 * i;
    module::learner::step(known, {f, 0.7}, {std::sin(f) / 3, -1e-7 * std::cos(f)}, {});
  }
  return known;
}

std::string saved(const temporary& file) {
  cca::controller<alone<module>> c;
  c.load();
  c.get<"dmp">().learning.hand_over(taught());
  c.get<"dmp">().p.files = {"", ""};
  REQUIRE(c.get<"dmp">().p.files.save.assign(file.path));
  c.save();
  CHECK(c.state() == cca::state::created);
  return file.text();
}

template <class Module>
std::string refusal_by(const std::string& path, double stiffness = 25) {
  cca::controller<alone<Module>> c;
  auto& dmp = c.template get<"dmp">();
  dmp.p.stiffness = stiffness;
  REQUIRE(dmp.p.files.load.assign(path));
  const auto before = dmp.learning.get().function.weights;
  const auto words = words_of([&] { c.load(); });
  CHECK((c.state() == (words.empty() ? cca::state::loaded : cca::state::created)));
  if (!words.empty()) {
    CHECK(dmp.learning.get().function.weights == before);
    CHECK(dmp.learning.state() == cca::learning::idle);
    dmp.p.files.load = {};
    c.load();  // works again after the refusal
    CHECK(c.state() == cca::state::loaded);
  }
  return words;
}

void replace(std::string& text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  REQUIRE(at != text.npos);
  text.replace(at, what.size(), by);
  const auto end = text.rfind("checksum ");
  text = text.substr(0, end) + "checksum " + cca::detail::checksum_of(text.substr(0, end)) + "\n";
}

}  // namespace

TEST_CASE("a saved value comes back bit for bit and is written again with the same text") {
  const temporary file("shape"), again("shape_again");
  const auto text = saved(file);
  CHECK(
      text.starts_with("cca learned 1\nmodel rhythmic_shape over hip, knee with 8 functions\nlearner "
                       "locally_weighted_regression\nconstant stiffness 25\n"));
  cca::controller<alone<module>> c;
  auto& dmp = c.get<"dmp">();
  REQUIRE(dmp.p.files.load.assign(file.path));
  REQUIRE(dmp.p.files.save.assign(again.path));
  c.load();
  const auto known = taught();
  CHECK(dmp.learning.state() == cca::learning::trained);
  CHECK(dmp.learning.get().function.weights == known.function.weights);
  CHECK(dmp.learning.get().evidence == known.evidence);
  CHECK(dmp.learning.get().seen == known.seen);
  c.save();
  CHECK(again.text() == text);
}

TEST_CASE("a file of another model, learner, version or constant is refused, with the expected text") {
  const temporary file("other");
  auto text = saved(file);
  CHECK(refusal_by<module>(file.path).empty());
  CHECK(refusal_by<module_of<9>>(file.path) ==
        file.path +
            ":2: the file belongs to another model; name the file of this one, or learn again: found `model "
            "rhythmic_shape over hip, knee with 8 "
            "functions`, expected `model rhythmic_shape over hip, knee with 9 functions`");
  CHECK(refusal_by<module>(file.path, 30) ==
        file.path +
            ":4: it was learned with another value; set the old value, or learn again: found `constant "
            "stiffness 25`, expected `constant stiffness 30`");
  const auto changed = [&](const std::string& what, const std::string& by) {
    auto other = text;
    replace(other, what, by);
    file.write(other);
    return refusal_by<module>(file.path);
  };
  CHECK(changed("cca learned 1", "cca learned 2")
            .starts_with(file.path +
                         ":1: the file has another version of the format: `cca learned 2`, expected `cca "
                         "learned 1`"));
  CHECK(changed("locally_weighted", "globally_weighted")
            .starts_with(file.path + ":3: the file belongs to another learner"));
  CHECK(changed("numbers function.weights 16", "numbers function.weights 17")
            .starts_with(file.path + ":5: the file has other fields"));
  CHECK(changed("numbers seen 8\n", "numbers seen 8\nnan ") ==
        file.path + ":11: seen[0]: expected a finite number, got `nan`");
  CHECK(changed("cca learned 1", "[cpg]\nfrequency")
            .starts_with(file.path + ":1: this is not a file of a learned module"));
}

TEST_CASE("a damaged file is refused, wherever the damage is") {
  const temporary file("damaged");
  const auto text = saved(file);
  for (std::size_t at = 0; at < text.size(); at += 7) {
    auto broken = text;
    broken[at] = static_cast<char>(broken[at] ^ 1);
    file.write(broken);
    CHECK(!refusal_by<module>(file.path).empty());
    file.write(text.substr(0, at));
    CHECK(!refusal_by<module>(file.path).empty());
  }
  file.write(text + "0");
  CHECK(refusal_by<module>(file.path).find("damaged") != std::string::npos);
  CHECK(refusal_by<module>(file.path + ".missing").find("cannot be read") != std::string::npos);
}

TEST_CASE("a value that cannot be saved leaves the state unchanged") {
  cca::controller<alone<module>> c;
  c.load();
  REQUIRE(c.get<"dmp">().p.files.save.assign("/nowhere/shape"));
  CHECK(words_of([&] { c.save(); }) == "/nowhere/shape: not written: the module has learned nothing");
  c.get<"dmp">().learning.hand_over(taught());
  CHECK(words_of([&] { c.save(); }).find("/nowhere/shape: cannot be written") == 0);
  CHECK(c.state() == cca::state::loaded);
}

namespace {

enum class side { left, right };
struct counts {
  BOOST_HANA_DEFINE_STRUCT(counts,
                           (std::int8_t, small),
                           (std::int64_t, large),
                           (bool, on),
                           (side, way),
                           (float, half),
                           (double, whole));
};
const cca::detail::schema& counts_schema = cca::detail::schema_of<counts>;

// The text of a file with this number in the place of a field's.
std::string with(std::string_view field, std::string_view number) {
  const counts written{3, 9007199254740993, true, side::right, 0.5f, 1e300};
  std::string text = cca::detail::learned_text({"m", "l"}, counts_schema, &written);
  const std::string head = "numbers " + std::string(field) + " 1\n";
  const auto from = text.find(head) + head.size();
  text.replace(from, text.find('\n', from) - from, number);
  text.resize(text.rfind("checksum "));
  return text + "checksum " + cca::detail::checksum_of(text) + "\n";
}
counts read_counts(const std::string& text) {
  counts read{};
  cca::detail::read_learned(text, "f", {"m", "l"}, counts_schema, &read);
  return read;
}
std::string refusal_of_number(std::string_view field, std::string_view number) {
  return words_of([&] { read_counts(with(field, number)); });
}

}  // namespace

TEST_CASE("an integer comes back exactly, and one that does not fit its field is refused") {
  const counts read = read_counts(with("small", "3"));
  CHECK(read.large == 9007199254740993);  // no double has it
  CHECK(read.way == side::right);
  CHECK(read_counts(with("large", "1e+05")).large == 100'000);  // as older versions wrote it
  CHECK(refusal_of_number("large", "1e+300") == "f:7: large[0]: expected an integer, got `1e+300`");
  CHECK(refusal_of_number("large", "0.5") == "f:7: large[0]: expected an integer, got `0.5`");
  CHECK(refusal_of_number("small", "300") == "f:5: small[0]: 300 is out of range, expected -128 to 127");
  CHECK(refusal_of_number("on", "2") == "f:9: on[0]: expected 0 or 1, got `2`");
  CHECK(refusal_of_number("way", "-1") == "f:11: way[0]: expected the number of left or right, got `-1`");
  CHECK(refusal_of_number("half", "1e300") == "f:13: half[0]: 1e300 is too large for a float");
  CHECK(refusal_of_number("whole", "1 2") == "f:15: whole: more numbers in this line than expected");
  CHECK(refusal_of_number("whole", "1\n7") == "f:16: expected the checksum: the file has more fields");
}
