#include "common/options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace hexapod {
namespace {

struct Sample {
  double threshold_m = 0.1;
  std::int64_t neighbours = 15;
  bool resume = false;
  std::string engine = "ode";

  std::vector<Option> declare() {
    return {option("threshold_m", threshold_m, "m", "Distance.", 0.0, 10.0),
            option("neighbours", neighbours, "Count.", 1, 1000), option("resume", resume, "Go on."),
            option("engine", engine, "Which one.", {"ode", "reduced"})};
  }
};

std::string problemsOf(const std::map<std::string, OptionValue>& values) {
  Sample sample;
  try {
    applyOptions(sample.declare(), values, "learn.yaml");
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(sample.threshold_m, 0.1) << "nothing may be set when anything is wrong";
    return error.what();
  }
  return "";
}

TEST(ApplyOptions, SetsEveryType) {
  Sample sample;
  applyOptions(sample.declare(),
               {{"threshold_m", std::int64_t{2}},
                {"neighbours", std::int64_t{3}},
                {"resume", true},
                {"engine", std::string("reduced")}},
               "test");
  EXPECT_EQ(sample.threshold_m, 2.0);
  EXPECT_EQ(sample.neighbours, 3);
  EXPECT_TRUE(sample.resume);
  EXPECT_EQ(sample.engine, "reduced");
}

TEST(ApplyOptions, NamesTheNearestOptionOfAMisspeltKey) {
  EXPECT_EQ(problemsOf({{"neigbours", std::int64_t{3}}}),
            "learn.yaml: 'neigbours' is not a known option; did you mean 'neighbours'.");
}

TEST(ApplyOptions, ListsAllProblemsAtOnceAndSetsNothing) {
  const std::string problems = problemsOf({{"threshold_m", -1.0},
                                           {"neighbours", 1.5},
                                           {"resume", std::int64_t{1}},
                                           {"engine", std::string("bullet")}});
  for (const char* part : {"'threshold_m' is wrong: expected 0 .. 10 m, found -1",
                           "expected a whole number, found 1.5", "expected true or false, found 1",
                           "expected ode or reduced, found the text 'bullet'"}) {
    EXPECT_NE(problems.find(part), std::string::npos) << part << "\nnot in\n" << problems;
  }
}

TEST(ApplyOptions, ExplainsNumbersThatYamlReadsAsText) {
  const std::string problem = problemsOf({{"threshold_m", optionValueFromText("1e-2")}});
  EXPECT_NE(problem.find("write 0.01"), std::string::npos) << problem;
}

TEST(ApplyOptions, RefusesNumbersThatAreNotFinite) {
  EXPECT_NE(problemsOf({{"threshold_m", std::nan("")}}), "");
  EXPECT_NE(problemsOf({{"threshold_m", HUGE_VAL}}), "");
}

TEST(OptionValueFromText, TypesScalarsAsTheParameterServerDoes) {
  EXPECT_EQ(std::get<std::int64_t>(optionValueFromText("3")), 3);
  EXPECT_EQ(std::get<double>(optionValueFromText("1.0e-2")), 0.01);
  EXPECT_EQ(std::get<bool>(optionValueFromText("true")), true);
  EXPECT_EQ(std::get<std::string>(optionValueFromText("1e-2")), "1e-2");
  EXPECT_EQ(std::get<std::string>(optionValueFromText("3 legs")), "3 legs");
}

TEST(OptionText, ReadsBackAsTheSameNumber) {
  Sample sample;
  sample.threshold_m = 0.1 + 0.2;
  EXPECT_EQ(std::get<double>(optionValueFromText(sample.declare()[0].text())), 0.1 + 0.2);
}

class YamlFile : public testing::Test {
 protected:
  std::map<std::string, OptionValue> read(const std::string& text) {
    std::ofstream(path_) << text;
    return optionValuesFromYaml(path_);
  }
  std::string problemOf(const std::string& text) {
    try {
      read(text);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
  void TearDown() override { std::remove(path_.c_str()); }
  const std::string path_ = testing::TempDir() + "hexapod_options_test.yaml";
};

TEST_F(YamlFile, KeepsQuotedNumbersText) {
  const auto values = read("a: 3\nb: \"3\"\n");
  EXPECT_EQ(std::get<std::int64_t>(values.at("a")), 3);
  EXPECT_EQ(std::get<std::string>(values.at("b")), "3");
}

TEST_F(YamlFile, MayBeEmpty) { EXPECT_TRUE(read("# nothing\n").empty()); }

TEST_F(YamlFile, NamesFileAndLineOfWhatIsWrong) {
  EXPECT_NE(problemOf("a: 1\nb: [1, 2]\n").find("line 2: 'b' expects a single value"),
            std::string::npos);
  EXPECT_NE(problemOf("a: 1\na: 2\n").find("twice"), std::string::npos);
  EXPECT_NE(problemOf("a: [1\n").find("not YAML"), std::string::npos);
  EXPECT_THROW(optionValuesFromYaml("/no/such/file.yaml"), std::runtime_error);
}

}  // namespace
}  // namespace hexapod
