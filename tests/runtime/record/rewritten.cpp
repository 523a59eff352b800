// Recordings that other tools have rewritten are replayed as the original; what can't be is refused for its
// true reason, and no number in a file makes a replay endless or large.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <cca/record/mcap/lz4.hpp>

#include "graphs.hpp"
#include "rewriting.hpp"

using namespace record_test;

namespace {

struct bounded_filter : filter {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (cca::bounded<double, 0.01, 0.5>, gain), (cca::text<8>, name));
  };
  parameters p{0.1, "fast"};
  auto process(cca::in<"x", leg_angles> x) -> cca::out<"y", slow_angles> {
    s += p.gain * (x.vector() - s);
    return s;
  }
};
struct graph : walking<bounded_filter> {};

// A file of 2000 beats.
struct recorded {
  temporary_file file{"original"}, other{"rewritten"};
  explicit recorded(int beats = 2000) {
    cca::controller<graph> c;
    cca::recording::recorder recording(c, file.path, {.waits = true});
    c.load();
    c.start();
    c.run(cca::for_beats<500>{});
    c.set<"filter">({0.3, "slow"});
    for (int i = 500; i < beats; ++i) c.step();
    c.stop();
  }
  cca::recording::replay_result replayed(const rewriting& how) const {
    rewrite(file.path, other.path, how);
    return cca::recording::replay<graph>(other.path);
  }
  std::string refusal(const rewriting& how) const {
    try {
      const auto result = replayed(how);
      return "not refused: " + result.difference + result.ended_early;
    } catch (const cca::refused& e) { return std::string(e.what()).substr(other.path.size()); }
  }
};

std::int64_t beat_in(const bytes& data) {
  std::int64_t beat = 0;
  std::memcpy(&beat, &data[4], sizeof beat);
  return beat;
}
bool is_sample(const std::string& topic) { return !topic.starts_with("/cca") && !topic.starts_with("/ros2"); }
// The samples from beat 100 on are of that beat.
auto moved_to(std::int64_t beat) {
  return [beat](const std::string& topic, bytes& data) {
    if (!is_sample(topic) || beat_in(data) < 100) return !is_sample(topic) || beat_in(data) < 100;
    if (beat_in(data) > 100) return false;
    std::memcpy(&data[4], &beat, sizeof beat);
    return true;
  };
}

bytes from_hex(std::string_view hex) {
  bytes all;
  for (; hex.size() > 1; hex.remove_prefix(2))
    all.push_back(static_cast<unsigned char>(std::stoi(std::string(hex.substr(0, 2)), nullptr, 16)));
  return all;
}

}  // namespace

TEST_CASE("a recording is replayed however its messages are stored") {
  const recorded r;
  const auto original = cca::recording::replay<graph>(r.file.path);
  REQUIRE(original);
  for (const std::string compression : {"none", "lz4", ""})
    for (const bool lazy : {false, true}) {
      CAPTURE(compression);
      CAPTURE(lazy);
      const auto result = r.replayed({.compression = compression, .lazy = lazy});
      INFO(result);
      CHECK(result);
      CHECK(result.beats == original.beats);
      CHECK(result.samples == original.samples);
    }
}

TEST_CASE("lz4, as its own program writes it") {
  std::string text;
  for (int i = 0; i < 3; ++i)
    text += "the leg swings, the leg swings, the leg swings, the leg swings, and the leg stops\n";
  const std::string start = "ff01746865206c6567207377696e67732c2010001d36616e64",
                    with_sums =
                        "04224d186440a7"
                        "31000000" +
                        start +
                        "34005f746f70730a42001d0c30000f52004c50746f70730a"
                        "00000000d666d8e9",
                    linked =
                        "04224d186c40f60000000000000031"
                        "2a000000" +
                        start +
                        "14005f746f70730a52008c50746f70730a"
                        "00000000d666d8e9",
                    summed_blocks =
                        "04224d187040ad"
                        "31000000" +
                        start +
                        "34005f746f70730a42001d0c30000f52004c50746f70730a"
                        "467f92ae00000000",
                    skipped = "502a4d1803000000abcdef";
  const auto unpacked = [](const std::string& hex, std::size_t size) {
    bytes to(size);
    return mcap::decompress_lz4(from_hex(hex), to) ? std::string(to.begin(), to.end())
                                                   : std::string("damaged");
  };
  CHECK(unpacked(with_sums, 246) == text);
  CHECK(unpacked(linked, 246) == text);
  CHECK(unpacked(summed_blocks, 246) == text);
  CHECK(unpacked(skipped + with_sums + linked, 492) == text + text);
  CHECK(unpacked("04224d186440a706000080783179327a33000000003ecd1d0e", 6) == "x1y2z3");  // not compressed
  CHECK(unpacked(with_sums, 245) == "damaged");
  CHECK(unpacked(with_sums, 247) == "damaged");
  // Cut anywhere, and each byte changed: never beyond its memory (the presets with sanitizers look at that).
  const bytes whole = from_hex(with_sums);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    bytes to(246);
    CHECK_FALSE(mcap::decompress_lz4(mcap::byte_view(whole).first(i), to));
    for (unsigned char bit = 1; bit != 0; bit = static_cast<unsigned char>(bit << 1)) {
      bytes broken = whole;
      broken[i] ^= bit;
      (void)mcap::decompress_lz4(broken, to);
    }
  }
}

TEST_CASE("a file that can't be replayed is refused for its true reason") {
  const recorded r(600);
  CHECK(r.refusal({.compression = "bz2"})
            .find(" can't be read: a chunk compressed with `bz2`, which is not read here "
                  "(rewrite the file with zstd") == 0);
  CHECK(r.refusal({.keeps = [](const std::string& topic) {
           return topic != "/cca/state";
         }}).find(": the topic /cca/state is missing") == 0);
  CHECK(r.refusal({.keeps = [](const std::string& topic) { return topic != "/leg/angles"; }}) ==
        ": what `leg.angles` sensed was not recorded: record it to replay");
  CHECK(r.refusal({.change = [](const std::string& topic, bytes& data) {
    if (topic == "/leg/angles" && beat_in(data) == 7) data.pop_back();
    return true;
  }}) == ": a message of /leg/angles can't be read");
  const auto seventh_becomes = [&](unsigned char beat) {
    return r.refusal({.change = [=](const std::string& topic, bytes& data) {
      if (topic == "/swing/angles" && beat_in(data) == 7) data[4] = beat;
      return true;
    }});
  };
  CHECK(seventh_becomes(5) ==
        ": a sample of `swing.angles` of beat 5 comes after samples of beat 6: another tool has changed the "
        "order of messages");
  CHECK(seventh_becomes(6) ==
        ": a sample of `swing.angles` of beat 6 is there twice: are two recordings merged in this file?");
  const auto gap = [&](bool whole) {
    return r.refusal({.change = [=](const std::string& topic, bytes& data) {
      return topic != "/leg/angles" || (!whole && beat_in(data) != 7);
    }});
  };
  constexpr auto left_out = " is missing: another tool has left out or moved messages";
  CHECK(gap(false) == std::string("not refused: what `leg.angles` sensed in beat 7") + left_out);
  CHECK(gap(true) == std::string("not refused: what `leg.angles` sensed in beat 0") + left_out);
  const auto no_parameters = ": no parameters are recorded of `filter`: keep the topics /cca/parameters/*";
  CHECK(r.refusal({.keeps = [](const std::string& topic) {
           return !topic.starts_with("/cca/parameters/");
         }}).find(no_parameters) == 0);
  CHECK(r.refusal({.change = [](const std::string& topic, bytes&) {
           return !topic.starts_with("/cca/parameters/");
         }}).find(no_parameters) == 0);
  CHECK(r.refusal({.without = "cca.end"}) ==
        "not refused: the recording does not say that it ended: it is a part of another one");
  // Before the first whole chunk.
  std::filesystem::resize_file(r.file.path, 3000);
  CHECK_THROWS_WITH_AS(cca::recording::replay<graph>(r.file.path),
                       doctest::Contains(" can't be read: the file ends within a record, before byte "),
                       cca::refused);
}

TEST_CASE("a file that ends too soon was cut off, and one with wrong bytes is damaged") {
  const recorded r(600);
  rewrite(r.file.path, r.other.path, {.compression = "none"});
  const auto size = std::filesystem::file_size(r.other.path);
  const auto ended_early = [&] { return cca::recording::replay<graph>(r.other.path).ended_early; };
  const auto set_byte = [&](std::uint64_t at, char value) {
    std::fstream file(r.other.path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(static_cast<std::streamoff>(at));
    file.put(value);
  };
  const std::uint64_t after_data = 8 + 9 + 20, end_of_data = size - after_data - 9 - 4;
  CHECK(ended_early() == "");
  set_byte(26, 'T');  // of the name of the tool in the header
  CHECK(ended_early() == "the recording is damaged: a wrong checksum of all data, before byte " +
                             std::to_string(size - after_data));
  // A length of which the last bytes fall short, in a file that has its end.
  rewrite(r.file.path, r.other.path, {.compression = "none"});
  set_byte(end_of_data + 8, 1);
  CHECK(ended_early().starts_with("the recording is damaged: the file ends within a record, before byte "));
  rewrite(r.file.path, r.other.path, {.compression = "none"});
  std::filesystem::resize_file(r.other.path, size - 20);
  CHECK(ended_early() == "");  // all data are there
  std::filesystem::resize_file(r.other.path, size / 2);
  CHECK(ended_early().starts_with("the recording is cut off: the file ends within a record, before byte "));
}

TEST_CASE("a file without a beginning is named for what it is") {
  const temporary_file file("beginning");
  const auto refusal_of = [&](std::string_view content) {
    std::ofstream(file.path, std::ios::binary) << content;
    try {
      cca::recording::replay<graph>(file.path);
    } catch (const cca::refused& e) { return std::string(e.what()).substr(file.path.size()); }
    return std::string("not refused");
  };
  CHECK(refusal_of("") == " is empty");
  CHECK(refusal_of("\x89MCA") == " is cut off: it has only 4 bytes");
  CHECK(refusal_of("MCAP") == " is not an MCAP file");
  CHECK(refusal_of("# nothing of the kind") == " is not an MCAP file");
  CHECK_THROWS_WITH_AS(cca::recording::replay<graph>("/tmp"), doctest::Contains("Is a directory"),
                       std::system_error);
}

TEST_CASE("no byte of a file reaches a terminal as a control byte") {
  using mcap::printable;
  CHECK(printable("leg \xc2\xb5m \xe2\x82\xac \xf0\x9f\xa6\xbf") ==
        "leg \xc2\xb5m \xe2\x82\xac \xf0\x9f\xa6\xbf");
  CHECK(printable("\x1b[2J\n\x7f") == "\\x1b[2J\\x0a\\x7f");
  CHECK(printable("\xc2\x9b \x9b \xe2\x82 \xc0\x9b \xff") == "\\xc2\\x9b \\x9b \\xe2\\x82 \\xc0\\x9b \\xff");
  CHECK(printable("abcdef", 3) == "abc");

  const recorded r(600);
  const std::string clear = "\x1b[2J";
  CHECK(r.refusal({.compression = clear}).find("a chunk compressed with `\\x1b[2J`, which") !=
        std::string::npos);
  const auto with_architecture = [&](const std::string& word, const std::string& now) {
    return r.refusal({.change_metadata = [=](mcap::text_map& entries) {
      if (const auto text = entries.find("text"); text != entries.end())
        text->second.replace(text->second.find(word), word.size(), now);
    }});
  };
  CHECK(with_architecture("node filter", "node \x1b[2J")
            .ends_with("there `node \\x1b[2J, fires every 10 beats from 0`"));
  CHECK(with_architecture("from output 0", "from \x1b[2Jput 0").ends_with("from \\x1b[2Jput 0, delayed 0`"));
  {
    cca::controller<graph> c;
    cca::recording::recorder recording(c, r.file.path, {.waits = true});
    c.load();
    c.start();
    c.run(cca::for_beats<10'000>{});
    REQUIRE(c.state() == cca::state::faulted);
  }
  const std::string reason = r.refusal({.change = [&](const std::string& topic, bytes& data) {
    const std::string_view too = "too ";
    if (const auto at = std::search(data.begin(), data.end(), too.begin(), too.end());
        topic == "/cca/fault" && at != data.end())
      std::copy(clear.begin(), clear.end(), at);
    return true;
  }});
  CHECK(reason.find("recorded the fault `\\x1b[2Jmany steps` of `counter`") != std::string::npos);
}

TEST_CASE("parameters that the component refuses are refused in a replay, too") {
  const recorded r(600);
  const auto with_gain = [&](std::int64_t from, double gain) {
    return r.refusal({.change = [=](const std::string& topic, bytes& data) {
      if (topic == "/cca/parameters/filter" && beat_in(data) >= from)
        std::memcpy(&data[12], &gain, sizeof gain);
      return true;
    }});
  };
  CHECK(with_gain(500, 7) == ": recorded parameters: filter.gain: 7 is out of range, expected 0.01 to 0.5");
  CHECK(with_gain(500, std::nan("")) ==
        ": recorded parameters: filter.gain: nan is not allowed, expected 0.01 to 0.5");
  CHECK(with_gain(0, 7) ==
        ": in replay the state `loaded` is refused: filter.gain: 7 is out of range, expected 0.01 to 0.5");
  CHECK(with_gain(0, 0.2).find("not refused: `filter.y`, beat 0: recorded [") == 0);
}

TEST_CASE("a beat far away ends a replay") {
  const recorded r(600);
  CHECK(r.refusal({.change = moved_to(std::numeric_limits<std::int64_t>::max())}).find(": a message of /") ==
        0);
  CHECK(r.refusal({.change = moved_to(std::numeric_limits<std::int64_t>::max())})
            .find(" is of beat 9223372036854775807, whose time no clock can hold") != std::string::npos);
  const auto later = r.replayed({.change = moved_to(1'000'000'000'000)});
  CHECK_FALSE(later);
  CHECK(later.beat == 100);
}

namespace {

struct quiet_leg {
  auto sense() -> cca::maybe<"angles", leg_angles> { return {}; }
};
struct listener {
  auto process(cca::in<"x", leg_angles> x) -> cca::out<"y", leg_angles> { return x.vector(); }
};
struct quiet : cca::graph<cca::rate<1000>,
                          cca::node<"listener", listener>,
                          cca::node<"leg", quiet_leg>,
                          cca::observe<"listener.y">,
                          cca::wire<"leg.angles", "listener.x">>,
               cca::recordable {};

}  // namespace

TEST_CASE("of beats of which nothing is recorded, only so many are replayed") {
  const temporary_file file("quiet"), other("quiet_later");
  {
    cca::controller<quiet> c;
    cca::recording::recorder recording(c, file.path, {.waits = true});
    c.load();
    c.start();
    c.run(cca::for_beats<1000>{});
    c.stop();
  }
  const auto result = cca::recording::replay<quiet>(file.path);
  CHECK(result);
  CHECK(result.beats == 1000);
  rewrite(file.path, other.path, {.change = [](const std::string& topic, bytes& data) {
            const std::int64_t beat = 1'000'000'000'000;
            if (topic == "/cca/state" && beat_in(data) == 1000) std::memcpy(&data[4], &beat, sizeof beat);
            return true;
          }});
  const auto later = cca::recording::detail::replay_run<quiet, cca::recording::detail::recorded_items<quiet>>(
                         other.path, 5000)
                         .go();
  CHECK_FALSE(later);
  CHECK(later.beats == 5000);
  CHECK(later.ended_early == "nothing is recorded of more than 5000 beats, before beat 1000000000000");
}

TEST_CASE("a recording without a beat is no success") {
  const temporary_file file("none");
  {
    cca::controller<graph> c;
    cca::recording::recorder recording(c, file.path);
    c.load();
    c.start();
    c.stop();
  }
  const auto result = cca::recording::replay<graph>(file.path);
  CHECK_FALSE(result);
  std::ostringstream text;
  text << result;
  CHECK(text.str() == "nothing is replayed: the recording has no beat");
}

TEST_CASE("a length in a file is compared before memory is taken for it") {
  const temporary_file file("sparse");
  const auto damage_of = [&](mcap::op code, std::uint64_t length, std::uint64_t size) {
    mcap::byte_writer start;
    start.add(mcap::byte_view(mcap::magic)).add(static_cast<std::uint8_t>(code)).add(length);
    std::ofstream(file.path, std::ios::binary)
        .write(reinterpret_cast<const char*>(start.view().data()),
               static_cast<std::streamsize>(start.size()));
    std::filesystem::resize_file(file.path, size);  // a hole, which takes no room on the disk
    cca::recording::mcap_reader reader(file.path);
    for (cca::recording::mcap_message m; reader.next(m);) {}
    return reader.damage();
  };
  constexpr std::uint64_t eight_gb = std::uint64_t{8} << 30;
  for (const auto code : {mcap::op::chunk, mcap::op::message})
    CHECK(damage_of(code, eight_gb, eight_gb + 4096) ==
          "a record of 8589934592 bytes, more than 269484032, before byte 17");
  for (const auto code : {mcap::op::schema, mcap::op::channel, mcap::op::metadata, mcap::op::data_end})
    CHECK(damage_of(code, eight_gb, eight_gb + 4096) ==
          "a record of 8589934592 bytes, more than 16777216, before byte 17");
  CHECK(damage_of(mcap::op::attachment, eight_gb, eight_gb).find("the file ends within a record") == 0);
  CHECK(damage_of(mcap::op::attachment, 1 << 20, (1 << 20) + 4096).find("a record without a kind") == 0);
}
