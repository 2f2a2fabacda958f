#include "study/methods.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "evolution/analytic_evaluator.h"

namespace hexapod {
namespace {

TEST(Methods, AreAllMadeByTheirNames) {
  AnalyticEvaluator evaluator;
  StudyOptions options;
  options.targets = 5;
  for (const std::string& name : methodNames()) {
    const Method method = makeMethod(name, 24, options, Random(1));
    advance(*method.algorithm, evaluator, 100);
    EXPECT_EQ(method.algorithm->counters().evaluations, 100) << name;
    EXPECT_FALSE(method.repertoires().empty()) << name;
  }
  EXPECT_THROW(makeMethod("annealing", 24, options, Random(1)), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
