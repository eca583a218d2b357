// One malformed file for each rule of the sections "Bytes" and "Document" of the format page, sealed where that can be.

#include <gtest/gtest.h>

#include "tests/checker/support/graded_torus.hpp"
#include "tests/checker/support/run_checker.hpp"
#include "tests/checker/support/space_form_samples.hpp"

namespace delcert::checker_tests {
namespace {

const std::string& valid() {
  static const std::string text = sealed(circle().document());
  return text;
}

/// The valid text with one occurrence replaced, sealed anew.
std::string with(const std::string& old, const std::string& replacement) {
  std::string text = valid();
  const std::size_t place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  text.replace(place, old.size(), replacement);
  return resealed(text);
}

/// The point 3, as an example of a number.
std::string with_number(const std::string& text) {
  Json document = circle().document();
  document["points"][3][0] = text;
  return sealed(document);
}

struct Case {
  std::string name, rule, bytes;
};

/// What is said about a malformed file, by a check that has so many threads.
std::string told(const std::string& bytes, int threads) {
  const CheckerRun run = run_checker_with(temporary_file(bytes) + " --threads " + std::to_string(threads));
  EXPECT_EQ(run.status, 3) << run.output;
  return run.output;
}

void expect_malformed(const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const CheckerRun run = run_checker(c.bytes);
    EXPECT_EQ(run.status, 3) << run.output;
    EXPECT_EQ(run.rules, std::set<std::string>{c.rule}) << run.output;
    // The second half is read in another thread.
    EXPECT_EQ(told(c.bytes, 2), told(c.bytes, 1));
  }
}

TEST(Malformed, the_unchanged_text_and_the_resealed_one_are_accepted) {
  EXPECT_EQ(run_checker(valid()).status, 0);
  EXPECT_EQ(resealed(valid()), valid());
  EXPECT_EQ(run_checker(zstd_compressed(valid())).status, 0);
}

TEST(Malformed, bytes_are_one_document_on_one_line) {
  const std::string text = valid(), cut = text.substr(0, text.size() - 1);
  expect_malformed(
      {{"no line feed", "form.bytes", cut},
       {"carriage return", "form.bytes", cut + "\r\n"},
       {"two line feeds", "form.bytes", text + "\n"},
       {"trailing bytes", "form.bytes", text + "x"},
       {"trailing zero byte", "form.bytes", text + std::string(1, '\0')},
       {"two documents", "form.bytes", text + text},
       {"empty", "form.keys", ""},
       {"a single brace", "form.keys", "{"},
       {"cut in a string", "form.bytes", text.substr(0, text.find("a test") + 3)},
       {"a byte order mark", "form.keys", "\xef\xbb\xbf" + text},
       {"deep nesting", "form.keys", std::string(1000000, '[')},
       {"deep nesting inside", "form.keys", with("\"levels\":{", "\"levels\":" + std::string(1000000, '{'))}});
}

TEST(Malformed, compressed_bytes_are_one_frame_of_sane_size) {
  const std::string frame = zstd_compressed(valid());
  std::string damaged = frame;
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 0x40);
  expect_malformed({{"cut short", "form.bytes", frame.substr(0, frame.size() - 5)},
                    {"only the magic number", "form.bytes", frame.substr(0, 4)},
                    {"two frames", "form.bytes", frame + frame},
                    {"bytes after the frame", "form.bytes", frame + "x"},
                    {"grows without end", "form.bytes", zstd_compressed(std::string(100'000'000, '['))},
                    {"compressed twice", "form.keys", zstd_compressed(frame)},
                    {"skippable frame", "form.keys", std::string("\x50\x2a\x4d\x18\x00\x00\x00\x00", 8) + frame}});
  EXPECT_EQ(run_checker(damaged).status, 3);
}

TEST(Malformed, keys_are_those_of_the_page_in_its_order_without_white_space) {
  expect_malformed(
      {{"white space", "form.keys", with("\"version\":2", "\"version\": 2")},
       {"white space between labels", "form.keys", with("[0,1,0],[0,29,1]", "[0,1,0], [0,29,1]")},
       {"another format", "form.keys", with("delcert-certificate", "delcert-certificate-2")},
       {"another version", "form.keys", with("\"version\":2", "\"version\":3")},
       {"a version that begins right", "form.keys", with("\"version\":2", "\"version\":2.0")},
       {"an unknown key", "form.keys", with("\"version\":2", "\"version\":2,\"note\":1")},
       {"a repeated key", "form.keys", with("\"version\":2", "\"version\":2,\"version\":2")},
       {"a missing key", "form.keys", with("\"candidates\":\"pruned\",", "")},
       {"keys out of order", "form.keys",
        with("\"candidates\":\"pruned\",\"seed\":\"7\"", "\"seed\":\"7\",\"candidates\":\"pruned\"")},
       {"an unknown level", "form.keys", with("\"levels\":{", "\"levels\":{\"7\":{},")},
       {"levels out of order", "form.keys",
        with("\"2s\":{},\"3\":{\"tested\":\"P1 to P4\"}", "\"3\":{\"tested\":\"P1 to P4\"},\"2s\":{}")},
       {"a level twice", "form.keys", with("\"4\":{}", "\"4\":{},\"4\":{}")},
       {"a margin too many", "form.keys", with("\"4\":{}", "\"4\":{\"a\":1}")},
       {"another family", "form.types", with("flat-torus", "round-torus")},
       {"a radius of a torus", "form.keys", with("\"gram\":[[\"1\"]]", "\"radius\":\"1\"")},
       {"an escaped key", "form.keys", with("\"net\":", "\"n\\u0065t\":")},
       {"software without delcert", "form.keys", with("{\"delcert\":\"test\"}", "{\"other\":\"test\"}")},
       {"software repeated", "form.keys",
        with("{\"delcert\":\"test\"}", "{\"delcert\":\"test\",\"delcert\":\"test\"}")},
       {"software repeated in disguise", "form.keys",
        with("{\"delcert\":\"test\"}", "{\"delcert\":\"test\",\"d\\u0065lcert\":\"test\"}")},
       {"no software", "form.types", with("{\"delcert\":\"test\"}", "{}")},
       {"level 6 with another constant", "form.keys", with("\"bilipschitz\":\"1\"", "\"bilipschitz\":\"2\"")},
       {"level 5 by another route", "form.keys", with("space-form", "fan")}});
}

TEST(Malformed, values_have_the_types_of_the_page) {
  const std::string closed = "\"closed\":true";
  expect_malformed(
      {{"mode", "form.types", with("\"measured\"", "\"guessed\"")},
       {"candidates", "form.types", with("\"pruned\"", "\"some\"")},
       {"seed", "form.numbers", with("\"seed\":\"7\"", "\"seed\":\"0x7\"")},
       {"seed with a fraction", "form.numbers", with("\"seed\":\"7\"", "\"seed\":\"7/2\"")},
       {"dimension 0", "form.types", with("\"dimension\":1", "\"dimension\":0")},
       {"dimension 5", "form.types", with("\"dimension\":1", "\"dimension\":5")},
       {"a string for a truth value", "form.types", with("\"hypotheses_2\":false", "\"hypotheses_2\":\"false\"")},
       {"hypotheses that are not claimed", "form.keys",
        with("\"hypotheses_2\":false", "\"hypotheses_2\":false,\"hypotheses\":\"sharper\"")},
       {"hypotheses of no name", "form.keys",
        with("\"hypotheses_2\":false", "\"hypotheses_2\":true,\"hypotheses\":\"sharp\"")},
       {"a number for a string", "form.types", with("\"seed\":\"7\"", "\"seed\":7")},
       {"a string for a count", "form.types", with("\"simplices\":30", "\"simplices\":\"30\"")},
       {"a count with a sign", "form.types", with("\"simplices\":30", "\"simplices\":-30")},
       {"a count with a leading zero", "form.types", with("\"simplices\":30", "\"simplices\":030")},
       {"a count with an exponent", "form.keys", with("\"simplices\":30", "\"simplices\":3e1")},
       {"a count beyond 64 bits", "form.types", with("\"simplices\":30", "\"simplices\":18446744073709551646")},
       {"minus zero", "form.types", with("\"euler_characteristic\":0", "\"euler_characteristic\":-0")},
       {"homology that is no list", "form.keys", with(closed, closed + ",\"homology\":\"Z\"")},
       {"homology in numbers", "form.types", with(closed, closed + ",\"homology\":[1,1]")},
       {"too few homology groups", "form.keys", with(closed, closed + ",\"homology\":[\"Z\"]")},
       {"too many homology groups", "form.keys", with(closed, closed + ",\"homology\":[\"Z\",\"Z\",\"0\"]")},
       {"no homology group", "form.types", with(closed, closed + ",\"homology\":[]")},
       {"homology before its place", "form.keys", with("\"closed\"", "\"homology\":[\"Z\",\"Z\"],\"closed\"")},
       {"a label as a string", "form.types", with("[0,1,0],[0,29,1]", "[0,\"1\",0],[0,29,1]")},
       {"a negative label", "form.types", with("[0,1,0],[0,29,1]", "[0,-1,0],[0,29,1]")},
       {"null", "form.keys", with("\"net\":[", "\"net\":null,\"x\":[")},
       {"a control character in a string", "form.bytes", with("a test", "a\ttest")},
       {"invalid UTF-8", "form.bytes", with("a test", "a \xff test")},
       {"an overlong form", "form.bytes", with("a test", "a \xc0\xaf test")},
       {"a surrogate", "form.bytes", with("a test", "a \xed\xa0\x80 test")},
       {"half a surrogate pair", "form.bytes", with("a test", "a \\ud800 test")},
       {"an unknown escape", "form.bytes", with("a test", "a \\x test")}});
  EXPECT_EQ(run_checker(with(closed, closed + ",\"homology\":[\"Z\",\"Z\"]")).status, 0);
  EXPECT_EQ(run_checker(with("a test", "\\\"quotes\\\" \\u00e9 \\ud83d\\ude00 \xc3\xa9 \xf0\x9f\x98\x80")).status, 0);
}

TEST(Malformed, numbers_are_exact_and_in_one_of_three_forms) {
  std::vector<Case> cases;
  for (const char* number :
       {"",    "-",     "+1",    "0.5", ".5",  "1.",   "1e5",  "1/0",      "1/00",     "1/-2",   "-1/-2",      "/2",
        "1/",  "1/2/3", " 1",    "1 ",  "0x",  "0x.8", "0x1.", "0x1p",     "0x1p+3",   "0x1p-",  "0x1p123456", "0x1P3",
        "0X1", "0xA",   "0x1/2", "1p3", "inf", "nan",  "--1",  "1\\u0030", "\xd9\xa3", "0x1p1p1"}) {
    cases.push_back({std::string("number ") + number, "form.numbers", with_number(number)});
  }
  expect_malformed(cases);
  Json document = circle().document();
  document["points"][3][0] = 1;
  expect_malformed({{"a JSON number", "form.types", sealed(document)}});
}

TEST(Malformed, the_same_number_in_another_form_is_accepted) {
  Json document = circle().document();
  document["manifold"]["gram"][0][0] = "0x00.800p1";
  document["parameters"]["radius_variation"] = "-0/7";
  document["parameters"]["distortion"] = "0x0.0p-99999";
  document["points"][15][0] = "00500/1000";
  EXPECT_EQ(run_checker(sealed(document)).status, 0);
}

TEST(Malformed, lengths_and_labels_fit_together) {
  const auto changed = [](auto change) {
    Json document = circle().document();
    change(document);
    return sealed(document);
  };
  const Json ball = disc().document();
  const Json graded = graded_document(graded_torus());
  const auto with_radii = [](Json document, auto change) {
    change(document);
    return sealed(document);
  };
  Json of_a_ball = Json::object();
  for (const auto& [key, value] : ball.items()) {
    of_a_ball[key] = value;
    if (key == "net") of_a_ball["radii"] = Json(std::vector<std::string>(value.size(), "1"));
  }
  expect_malformed(
      {{"a radius too few", "form.lengths", with_radii(graded, [](Json& d) { d["radii"].erase(4); })},
       {"no radii", "form.lengths", with_radii(graded, [](Json& d) { d["radii"] = Json::array(); })},
       {"a radius of 0", "form.ranges", with_radii(graded, [](Json& d) { d["radii"][4] = "0"; })},
       {"a radius above the sampling radius", "form.ranges", with_radii(graded, [](Json& d) { d["radii"][4] = "1"; })},
       {"a radius that is no number", "form.numbers", with_radii(graded, [](Json& d) { d["radii"][4] = "0.1"; })},
       {"radii of a ball", "form.keys", sealed(of_a_ball)},
       {"a radius variation without radii", "form.ranges",
        with_radii(circle().document(), [](Json& d) { d["parameters"]["radius_variation"] = "1/8"; })}});
  Json without_net = disc().claiming({"1", "2"}).document();
  without_net["net"] = Json::array();
  expect_malformed(
      {{"a point too many", "form.lengths", changed([](Json& d) { d["points"].push_back(d["points"][0]); })},
       {"a net point too few", "form.lengths", changed([](Json& d) { d["net"].erase(4); })},
       {"no net although level 0 is claimed", "form.lengths", changed([](Json& d) { d["net"] = Json::array(); })},
       {"no net of a ball", "form.lengths", sealed(without_net)},
       {"a label of a simplex that is no label", "form.labels", changed([](Json& d) { d["simplices"][3][1] = 30; })},
       {"a label of a net simplex that is no label", "form.labels",
        changed([](Json& d) { d["net_simplices"][3][1] = 30; })},
       {"gram not positive", "form.gram", changed([](Json& d) { d["manifold"]["gram"][0][0] = "-1"; })},
       {"gram zero", "form.gram", changed([](Json& d) { d["manifold"]["gram"][0][0] = "0"; })},
       {"seal in capitals", "seal",
        [] {
          std::string text = valid();
          for (std::size_t k = text.rfind(":\""); k < text.size(); ++k)
            text[k] = static_cast<char>(std::toupper(text[k]));
          return text;
        }()},
       {"seal too short", "seal", [] {
          std::string text = valid();
          return text.erase(text.size() - 5, 1);
        }()}});
}

TEST(Malformed, files_of_version_1_are_said_to_be) {
  Json document = circle().document();
  document["version"] = 1;
  for (const char* key : {"elements", "simplices", "loops"}) document.erase(key);
  document["stars"] = circle().model.stars;
  const CheckerRun run = run_checker(sealed(document));
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.rules, std::set<std::string>{"form.version"}) << run.output;
  EXPECT_NE(run.output.find("version 1 is read by delcert 0.1"), std::string::npos) << run.output;
}

TEST(Malformed, elements_and_loops_are_those_of_the_group) {
  const auto changed = [](const Json& valid, auto change) {
    Json document = valid;
    change(document);
    return sealed(document);
  };
  const Json line = circle().document(), torus = wide_torus().document(), ball = disc().document();
  const Json bolza = bolza_surface().document(), bottle = klein_bottle().document();
  const auto element = [](std::size_t k, const char* value) {
    return [=](Json& d) { d["elements"][k] = Json::parse(value); };
  };
  const auto loop = [](std::size_t k, const char* value) {
    return [=](Json& d) { d["loops"][k] = Json::parse(value); };
  };
  ASSERT_EQ(line["elements"], Json::parse("[[-1]]"));
  expect_malformed(
      {{"an element of two coordinates", "form.keys", changed(line, element(0, "[1,0]"))},
       {"an element of 32 bits", "form.types", changed(line, element(0, "[-2147483648]"))},
       {"the identity as an element", "form.elements", changed(line, element(0, "[0]"))},
       {"an element twice", "form.elements", changed(torus, [](Json& d) { d["elements"][1] = d["elements"][0]; })},
       {"elements out of order", "form.elements",
        changed(torus, [](Json& d) { std::swap(d["elements"][1], d["elements"][0]); })},
       {"elements of a ball", "form.keys", changed(ball, [](Json& d) { d["elements"] = Json::parse("[[1,0]]"); })},
       {"a simplex of a ball elsewhere", "form.elements", changed(ball, [](Json& d) { d["simplices"][2][3] = 1; })},
       {"an element that is not in the table", "form.elements",
        changed(line, [](Json& d) { d["simplices"][4][2] = 2; })},
       {"a parent that comes later", "form.elements", changed(bolza, element(3, "[4,1]"))},
       {"a parent of its own", "form.elements", changed(bolza, element(0, "[1,1]"))},
       {"a negative parent", "form.elements", changed(bolza, element(3, "[-1,1]"))},
       {"the letter 0", "form.elements", changed(bolza, element(3, "[0,0]"))},
       {"a letter too many", "form.elements", changed(bolza, element(3, "[0,5]"))},
       {"an inverse of a letter too many", "form.elements", changed(bolza, element(3, "[0,-5]"))},
       {"a translation too many", "form.elements", changed(bottle, element(3, "[0,4]"))},
       {"a loop too few", "form.loops", changed(bottle, [](Json& d) { d["loops"].erase(2); })},
       {"a loop too many", "form.loops", changed(ball, [](Json& d) { d["loops"].push_back(Json::array()); })},
       {"a step of two numbers", "form.keys", changed(line, loop(0, "[0,1]"))},
       {"a step in no simplex of the list", "form.loops", changed(line, loop(0, "[30,0,1]"))},
       {"a position out of range", "form.loops", changed(line, loop(0, "[0,0,2]"))},
       {"a step that stays", "form.loops", changed(line, loop(0, "[0,0,0]"))},
       {"a loop that begins elsewhere", "form.loops", changed(line, loop(0, "[2,0,1]"))},
       {"a loop with a gap", "form.loops", changed(line, loop(0, "[0,0,1,1,0,1]"))},
       {"a loop that does not end at 0", "form.loops", changed(line, loop(0, "[0,0,1]"))}});
  // There and back: of the right form, whatever group element it is.
  EXPECT_NE(run_checker(changed(line, loop(0, "[0,0,1,0,1,0]"))).status, 3);
}

/// Whichever thread meets its mistake first. All numbers are read before what they mean is asked.
TEST(Malformed, the_first_mistake_in_the_file_is_the_one_that_is_told) {
  const auto changed = [](std::string text, const std::string& key, const std::string& old,
                          const std::string& replacement) {
    const std::size_t place = text.find(old, text.find(key));
    EXPECT_NE(place, std::string::npos) << key;
    return resealed(text.replace(place, old.size(), replacement));
  };
  const std::string net = "\"net\":", points = "\"points\":", simplices = "\"simplices\":[";
  const std::string in_net = changed(valid(), net, "\"]", "x\"]"), in_points = changed(valid(), points, "\"]", "x\"]"),
                    in_simplices = changed(valid(), simplices, "[0,1,0]", "[0,1.0]"),
                    in_lengths = changed(valid(), points, "],[", "],[\"0\"],[");
  const std::string first_half = changed(changed(in_net, points, "\"]", "y\"]"), simplices, "[0,1,0]", "[0,1.0]"),
                    second_half = changed(in_points, simplices, "[0,1,0]", "[0,1.0]"),
                    last = changed(in_lengths, simplices, "[0,1,0]", "[0,1.0]");
  // The key of the second half too early: before the end of the net, in its place, or twice; and something before it.
  const std::string early = changed(valid(), net, "],[", "],\"points\":[["),
                    instead = changed(valid(), "", "\"net_simplices\":", "\"points\":"),
                    twice = changed(valid(), "", "\"points\":", "\"points\":[],\"points\":"),
                    late = changed(valid(), "", "\"points\":", "\"x\":1,\"points\":");
  for (const auto& [bytes, first] : {std::pair(first_half, in_net), {second_half, in_points}}) {
    for (const int threads : {1, 2, 3}) EXPECT_EQ(told(bytes, threads), told(first, 1));
  }
  EXPECT_NE(told(in_lengths, 2).find("form.lengths"), std::string::npos);
  for (const std::string& bytes : {last, early, instead, twice, late}) {
    EXPECT_EQ(told(bytes, 2), told(bytes, 1));
    EXPECT_NE(told(bytes, 1).find("form.keys"), std::string::npos);
  }
}

TEST(Malformed, numbers_too_large_for_the_filter_end_undecided_and_never_crash) {
  for (const char* number : {"0x1p99999", "-0x1p99999", "0x1p-99999", "123456789012345678901234567890", "0x1p40"}) {
    const CheckerRun run = run_checker(with_number(number));
    EXPECT_TRUE(run.status == 1 || run.status == 2) << number << run.output;
    Json document = circle().document();
    document["parameters"]["sampling_radius"] = number;
    EXPECT_GT(run_checker(sealed(document)).status, 0) << number;
    document = circle().document();
    document["levels"]["1"]["circumradius"] = number;
    EXPECT_GT(run_checker(sealed(document)).status, 0) << number;
    document = circle().document();
    document["manifold"]["gram"][0][0] = number;
    EXPECT_GT(run_checker(sealed(document)).status, 0) << number;
    document = disc().document();
    document["points"][0][0] = number;
    EXPECT_GT(run_checker(sealed(document)).status, 0) << number;
  }
}

}  // namespace
}  // namespace delcert::checker_tests
