// Every reason to refuse a file: the exact message, and that no parameter changes.
#include <doctest/doctest.h>

#include "mock.hpp"

using config_test::controller;

namespace {

// Checks that the file is refused with this message and that no parameter changes.
void refuses(std::string_view text, std::string_view words) {
  controller c;
  const std::string before = c.text();
  CHECK_EQ(c.refusal(text), words);
  CHECK_EQ(c.text(), before);
}

}  // namespace

TEST_SUITE("config refusals") {
  TEST_CASE("a value of another type") {
    refuses("[cpg]\nfrequency = \"fast\"\n",
            "trot.toml:2: cpg.frequency: expected a number, got a string \"fast\"; for example `frequency = "
            "1.5`");
    refuses("cpg.frequency = true",
            "trot.toml:1: cpg.frequency: expected a number, got true; for example `frequency = 1.5`");
    refuses("cpg.frequency = 1979-05-27",
            "trot.toml:1: cpg.frequency: expected a number, got a date; for example `frequency = 1.5`");
    refuses("cpg.frequency = 07:32:00",
            "trot.toml:1: cpg.frequency: expected a number, got a time; for example `frequency = 1.5`");
    refuses(
        "cpg.frequency = 1979-05-27T07:32:00Z",
        "trot.toml:1: cpg.frequency: expected a number, got a date and time; for example `frequency = 1.5`");
    refuses("[pose]\nmode = 2.0",
            "trot.toml:2: pose.mode: expected an integer, got the number 2.0; for example `mode = 1`");
    refuses("[pose]\nstiff = 1",
            "trot.toml:2: pose.stiff: expected true or false, got the integer 1; for example `stiff = true`");
    refuses("[pose]\nground = 2",
            "trot.toml:2: pose.ground: expected flat, slope or steps, got the integer 2; for example `ground "
            "= \"slope\"`");
    refuses("[pose]\nlabel = 2",
            "trot.toml:2: pose.label: expected a text, got the integer 2; for example `label = \"trot\"`");
    refuses("[pose]\nhip = true",
            "trot.toml:2: pose.hip: expected a number, in rad or with its unit, got true; for example `hip = "
            "\"0.25 rad\"`");
    refuses("cpg.frequency = \"0123456789012345678901234567890123456789xyz\"",
            "trot.toml:1: cpg.frequency: expected a number, got a string "
            "\"0123456789012345678901234567890123456789...\"; for example `frequency = 1.5`");
  }

  TEST_CASE("characters beyond ASCII outside of quotes") {
    const std::string_view words = "trot.toml:2: not TOML: characters beyond ASCII must stand in quotes";
    for (const char* text : {"cpg.gain = 2 \xc2\xb5", "\xd1\xa2 = 1", "[cpg.\xd0\x8f]", "\"\"\xd0\x8f = 1"})
      refuses(std::string("# \xd1\xa2\n") + text, words);
    controller c;
    CHECK_EQ(c.refusal("\xEF\xBB\xBF[pose]\nlabel = \"\xd1\xa2\"  # \xd1\xa2\n"), "");
  }

  TEST_CASE("a header without a name") {
    const std::string_view words = "trot.toml:2: not TOML: after `[` comes the name of a table";
    for (const char* header : {"[=]", "[\x13ose]", "[.a]", "[\n]", " [[ =", "\t[ #", "[[[", "[\xc3\xa4]"})
      refuses(std::string("# [\n") + header, words);
    refuses("\xEF\xBB\xBF[{}", "trot.toml:1: not TOML: after `[` comes the name of a table");
    controller c;
    CHECK_EQ(c.refusal("[\"cpg\"]\ngain = 2\n[ 'pose' ]\noffset =[\n=\n]").substr(0, 12), "trot.toml:5:");
  }

  TEST_CASE("a text that is nested too deep is refused before it is parsed") {
    const auto repeated = [](std::string_view what, int times) {
      std::string all;
      for (int i = 0; i < times; ++i) all += what;
      return all;
    };
    const std::string key = "trot.toml:2: a key of more than 64 parts";
    refuses("[cpg]\n" + repeated("a.", 50'000) + "a = 1", key);
    refuses("\n[" + repeated("a.", 50'000) + "a]", key);
    refuses("\n" + repeated("\"a\" . ", 50'000) + "a = 1", key);
    refuses("\ncpg = {" + repeated("a.", 50'000) + "a = 1}", key);
    const std::string brackets = "trot.toml:1: more than 32 brackets are open";
    refuses("cpg = " + repeated("[", 100'000), brackets);
    refuses("cpg = " + repeated("{a = ", 100'000), brackets);
    // Strings and comments hide brackets and dots, but not what follows them.
    for (const char* string :
         {"''", "'#'", "\"\\\"\"", "\"\"\"\n\\\"\"\"\"\"\"", "'''\n'''''''", "''''''", "# '\n"})
      refuses("cpg = [" + std::string(string) + (string[0] == '#' ? "" : ",") + repeated("[", 40),
              std::string("trot.toml:") +
                  (std::string_view(string).find('\n') != std::string_view::npos ? "2" : "1") +
                  ": more than 32 brackets are open");
    controller c;
    CHECK_EQ(c.refusal("[pose]\noffset = [0.5, 0.25]  # " + repeated("[.", 100) + "\nlabel = \"....\"\n"),
             "");
    CHECK_EQ(c.refusal("[pose]\nlabel = '" + repeated("[", 8) + "'\n"), "");
    refuses("[pose]\nlabel = '" + repeated(".[", 100) + "'\n",
            "trot.toml:2: pose.label: the text has 200 bytes, expected at most 8");
  }

  TEST_CASE("a table instead of a value, and a value instead of a table") {
    refuses("[cpg.frequency]\nx = 1",
            "trot.toml:1: cpg.frequency: expected a number, got a table; for example `frequency = 1.5`");
    refuses("[cpg]\nlinks = 3",
            "trot.toml:2: cpg.links: expected a table, got the integer 3; for example `links = {strength = "
            "3.0, offsets = [\"0 rad\", \"0.5 rad\"]}`");
    refuses("cpg = 3", "trot.toml:1: cpg: expected a table, got the integer 3");
    refuses("dmp = 3", "trot.toml:1: dmp: expected a table, got the integer 3");
    refuses("[[cpg]]\nfrequency = 1.0", "trot.toml:1: cpg: expected a table, got an array");
  }

  TEST_CASE("a key, a node or a scope that doesn't exist") {
    refuses("[cpg]\ngain = 2\nfrequncy = 2.0",
            "trot.toml:3: cpg.frequncy: unknown parameter, did you mean `frequency`?");
    refuses("[cpg]\nzzzzzz = 2",
            "trot.toml:2: cpg.zzzzzz: unknown parameter, there are `frequency`, `gain`, `links`");
    refuses("[pose]\nzzzzzz = 2",
            "trot.toml:2: pose.zzzzzz: unknown parameter, there are `hip`, `load`, `offset`, `mixing`, "
            "`mode`, `retries`, `stiff`, `ground` and others");
    refuses("[cpg.links]\nstrenght = 2.0",
            "trot.toml:2: cpg.links.strenght: unknown parameter, did you mean `strength`?");
    refuses("[sum]\nx = 1", "trot.toml:2: sum.x: unknown parameter, this node has none");
    refuses("\n[cgp]\nfrequency = 2.0", "trot.toml:2: cgp: unknown node, did you mean `cpg`?");
    refuses("[dmp.oed]\nfrequency = 2.0", "trot.toml:1: dmp.oed: unknown node, did you mean `ode`?");
    refuses("[robot]\nfrequency = 2.0",
            "trot.toml:1: robot: unknown node, there are `cpg`, `sum`, `dmp`, `pose`");
    refuses("title = \"x\"", "trot.toml:1: title: unknown node, there are `cpg`, `sum`, `dmp`, `pose`");
    refuses("[pose]\nlegs = [{knee = -1, front = true}, {knie = -1, front = true}]",
            "trot.toml:2: pose.legs[1].knie: unknown parameter, did you mean `knee`?");
  }

  TEST_CASE("out of range") {
    refuses("[cpg]\ngain = 9", "trot.toml:2: cpg.gain: 9 is out of range, expected 0.1 to 5");
    refuses("[cpg]\ngain = 0.05", "trot.toml:2: cpg.gain: 0.05 is out of range, expected 0.1 to 5");
    refuses("[pose]\nmode = 4", "trot.toml:2: pose.mode: 4 is out of range, expected 0 to 3");
    refuses("[pose]\nretries = 256", "trot.toml:2: pose.retries: 256 is out of range, expected 0 to 255");
    refuses("[pose]\nretries = -1", "trot.toml:2: pose.retries: -1 is out of range, expected 0 to 255");
    refuses("[pose]\nhip = 1", "trot.toml:2: pose.hip: 1 rad is out of range, expected -0.9 to 0.9 rad");
    refuses(
        "[pose]\nhip = \"60 deg\"",
        "trot.toml:2: pose.hip: 60 deg (1.0471975511965976 rad) is out of range, expected -0.9 to 0.9 rad");
    refuses("[pose]\npatience = -1", "trot.toml:2: pose.patience: -1 is out of range, expected at least 0");
    refuses("[pose]\nslack = 1e300", "trot.toml:2: pose.slack: 1e+300 is too large for a float");
    refuses("[pose]\nlegs = [{knee = -1}, {knee = 0.5}]",
            "trot.toml:2: pose.legs[1].knee: 0.5 rad is out of range, expected -1.8 to 0 rad");
  }

  TEST_CASE("not a finite number") {
    refuses("cpg.frequency = nan",
            "trot.toml:1: cpg.frequency: nan is not allowed, expected a finite number");
    refuses("cpg.frequency = -inf",
            "trot.toml:1: cpg.frequency: -inf is not allowed, expected a finite number");
    refuses("cpg.gain = inf", "trot.toml:1: cpg.gain: inf is not allowed, expected 0.1 to 5");
    refuses("pose.load = \"inf N m\"",
            "trot.toml:1: pose.load: inf N m is not allowed, expected a finite number");
    refuses("pose.patience = nan", "trot.toml:1: pose.patience: nan is not allowed, expected at least 0");
    refuses("pose.slack = inf", "trot.toml:1: pose.slack: inf is not allowed, expected a finite number");
  }

  TEST_CASE("numbers that can't be held") {
    refuses("pose.seed = 9223372036854775808",
            "trot.toml:1:32: not TOML: Error while parsing decimal integer: '9223372036854775808' is not "
            "representable in 64 bits, "
            "in `pose.seed = 9223372036854775808`");
    refuses("cpg.frequency = 9007199254740993",
            "trot.toml:1: cpg.frequency: 9007199254740993 is not held exactly, write it as a number, with a "
            "point");
    refuses("pose.load = \"1e999 N m\"", "trot.toml:1: pose.load: \"1e999 N m\" does not fit into a double");
  }

  TEST_CASE("units") {
    refuses(
        "[pose]\nhip = \"30 furlong\"",
        "trot.toml:2: pose.hip: unknown unit \"furlong\" in \"30 furlong\", expected rad, mrad, deg or turn");
    refuses("[pose]\nhip = \"0.3\"",
            "trot.toml:2: pose.hip: \"0.3\" has no unit, expected rad, mrad, deg or turn");
    refuses("[pose]\nhip = \"far\"",
            "trot.toml:2: pose.hip: expected a number with its unit (rad, mrad, deg or turn), got a string "
            "\"far\"");
    refuses("[pose]\nload = \"2 deg\"",
            "trot.toml:2: pose.load: unknown unit \"deg\" in \"2 deg\", expected N m, Nm, mN m or mNm");
    refuses("[pose]\nduty = \"2 rad\"",
            "trot.toml:2: pose.duty: unknown unit \"rad\" in \"2 rad\", expected no unit or %");
    refuses("[pose]\noffset = [1, \"2 m\"]",
            "trot.toml:2: pose.offset[1]: expected a number, got a string \"2 m\"; for example `2.0`");
  }

  TEST_CASE("arrays") {
    refuses("[pose]\noffset = [1, 2, 3]", "trot.toml:2: pose.offset: expected an array of 2, got one of 3");
    refuses("[pose]\noffset = []", "trot.toml:2: pose.offset: expected an array of 2, got one of 0");
    refuses("[pose]\noffset = 1",
            "trot.toml:2: pose.offset: expected an array of 2, got the integer 1; for example `offset = "
            "[1.0, 2.0]`");
    refuses("[pose]\noffset = [\n  1,\n  \"x\",\n]",
            "trot.toml:4: pose.offset[1]: expected a number, got a string \"x\"; for example `2.0`");
    refuses(
        "[pose]\nmixing = [[1, 2], 3]",
        "trot.toml:2: pose.mixing[1]: expected an array of 2, got the integer 3; for example `[0.0, 1.0]`");
    refuses("[pose]\nmixing = [[1, 2], [3]]",
            "trot.toml:2: pose.mixing[1]: expected an array of 2, got one of 1");
  }

  TEST_CASE("names and texts") {
    refuses("[pose]\nground = \"mud\"",
            "trot.toml:2: pose.ground: unknown name \"mud\", expected flat, slope or steps");
    refuses("[pose]\nground = \"\"",
            "trot.toml:2: pose.ground: unknown name \"\", expected flat, slope or steps");
    refuses("[pose]\nlabel = \"gallop over\"",
            "trot.toml:2: pose.label: the text has 11 bytes, expected at most 8");
  }

  TEST_CASE("a struct's own check") {
    refuses("[cpg]\n[cpg.links]\nstrength = 11",
            "trot.toml:2: cpg.links: so strong a coupling makes the phases jump");
    refuses("[cpg]\ngain = 1.5", "trot.toml:1: cpg: frequency and gain are the same");
    // Called only if all fields are allowed.
    refuses("[cpg]\nfrequency = 9.0\ngain = 9",
            "trot.toml:3: cpg.gain: 9 is out of range, expected 0.1 to 5");
  }

  TEST_CASE("not TOML") {
    refuses("[cpg]\nfrequency = = 2",
            "trot.toml:2:13: not TOML: Error while parsing value: could not determine value type, in "
            "`frequency = = 2`");
    refuses("[pose]\nhip = 30 deg\n",
            "trot.toml:2:10: not TOML: Error while parsing key-value pair: expected a comment or whitespace, "
            "saw 'd', in `hip = 30 deg` "
            "(put a text, or a number with its unit, in quotes)");
    refuses("[cpg",
            "trot.toml:1:5: not TOML: Error while parsing table header: encountered end-of-file, in `[cpg`");
    refuses("[cpg]\ngain = 1\ngain = 2",
            "trot.toml:3:8: not TOML: Error while parsing key-value pair: cannot redefine existing integer "
            "'gain', in `gain = 2`");
  }

  TEST_CASE("all problems at once, in the order of the file") {
    refuses("[pose]\nhip = 2\n[cpg]\nfrequncy = 1.0\ngain = 9\n[robot]\n",
            "trot.toml:2: pose.hip: 2 rad is out of range, expected -0.9 to 0.9 rad\n"
            "trot.toml:4: cpg.frequncy: unknown parameter, did you mean `frequency`?\n"
            "trot.toml:5: cpg.gain: 9 is out of range, expected 0.1 to 5\n"
            "trot.toml:6: robot: unknown node, there are `cpg`, `sum`, `dmp`, `pose`");
  }

  TEST_CASE("at most twenty problems") {
    std::string text = "[cpg]\n";
    for (int i = 0; i < 25; ++i) text += "zzzzzz" + std::to_string(i) + " = 1\n";
    controller c;
    const std::string words = c.refusal(text);
    CHECK_EQ(std::ranges::count(words, '\n'), 20);
    CHECK(words.ends_with("\ntrot.toml: and 5 more"));
  }

  TEST_CASE("values that the file does not mention are checked too, without a line number") {
    controller c;
    c.cpg.p.gain = 7;
    CHECK_EQ(c.refusal("[cpg]\nfrequency = 2.0"),
             "trot.toml: cpg.gain: 7 is out of range, expected 0.1 to 5");
    CHECK_EQ(c.cpg.p.frequency, 1.5);
    CHECK_EQ(c.refusal("cpg.gain = 2"), "");
    c.cpg.p.links.strength = 20;
    CHECK_EQ(c.refusal(""), "trot.toml: cpg.links: so strong a coupling makes the phases jump");
  }

  TEST_CASE("one bad value keeps all others from being set") {
    controller c;
    CHECK_EQ(c.refusal("[cpg]\nfrequency = 2.5\n[pose]\nmode = 3\nretries = 999\n"),
             "trot.toml:5: pose.retries: 999 is out of range, expected 0 to 255");
    CHECK_EQ(c.cpg.p.frequency, 1.5);
    CHECK_EQ(int{c.pose.p.mode}, 1);
  }

}  // TEST_SUITE
