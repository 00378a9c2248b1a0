// Error budgets as users write them, and the choices that they lead to.
#include <tests/support/catch.h>

#include <limits>
#include <string>
#include <vector>

#include "study/recommend/budget.h"
#include "study/recommend/candidates.h"

namespace glassbox::study {
namespace {

TEST_CASE("budgets name a quantity once each, with a limit as a number or a fraction") {
  const auto budgets = parse_budgets(" position<0.05px,depth < 1e-4 ,colour<1/255");
  REQUIRE(budgets);
  REQUIRE(budgets->size() == 3);
  CHECK((*budgets)[0].quantity == Quantity::kPosition);
  CHECK((*budgets)[0].limit == 0.05);
  CHECK((*budgets)[1].quantity == Quantity::kDepth);
  CHECK((*budgets)[1].limit == 1e-4);
  CHECK((*budgets)[2].quantity == Quantity::kColour);
  CHECK((*budgets)[2].limit == 1.0 / 255);
  CHECK(parse_budgets("position<1")->front().limit == 1);
  CHECK(parse_budgets("position < 0.25 px")->front().limit == 0.25);
  CHECK(parse_budgets("color<3 / 255")->front().limit == 3.0 / 255);
}

TEST_CASE("budgets that are none are refused with what is wrong and how to write them") {
  for (const char* text : {"",
                           ",",
                           "position",
                           "position<",
                           "position<px",
                           "position>0.1",
                           "position<0.1m",
                           "position<0.1pxpx",
                           "depth<1e-4px",
                           "depth<0",
                           "depth<-1",
                           "depth<nan",
                           "depth<inf",
                           "colour<1/0",
                           "colour<1/",
                           "colour</255",
                           "colour<1/2/3",
                           "speed<3",
                           "Position<1",
                           "depth<1e-4,",
                           "depth<1,depth<2",
                           "colour<1,color<2",
                           "depth<1 2",
                           "depth<0x10",
                           "depth<1e999",
                           "<1"}) {
    INFO(text);
    const auto refused = parse_budgets(text);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().place == "--error-budget");
    CHECK(refused.error().remedy.find("position<0.05px") != std::string::npos);
  }
}

Candidate candidate(double error, double ns, double spread, bool in_render = true) {
  return {"", {}, in_render, error, Quartiles{ns - spread, ns, ns + spread}};
}

TEST_CASE("the fastest candidate with an error below the limit is recommended") {
  const std::vector<Candidate> all{candidate(3, 10, 1), candidate(2, 20, 1), candidate(1, 30, 1)};
  CHECK(fastest_candidate(all, 4) == 0u);
  CHECK(fastest_candidate(all, 3) == 1u);  // below the limit, not equal to it
  CHECK(fastest_candidate(all, 1.5) == 2u);
  CHECK_FALSE(fastest_candidate(all, 1).has_value());
  CHECK_FALSE(fastest_candidate({}, 1).has_value());
}

TEST_CASE("of candidates as fast as the fastest the smaller error is recommended") {
  CHECK(fastest_candidate({candidate(3, 10, 2), candidate(2, 11, 2), candidate(1, 30, 1)}, 4) ==
        1u);
}

TEST_CASE("what render can do comes first, then the first of the rest") {
  const auto other = [](double error) { return candidate(error, 1, 0, false); };
  const auto ours = [](double error) { return candidate(error, 1, 0); };
  CHECK(first_render_candidate({other(1), other(2), ours(3)}, 4) == 2u);
  // Below the limit, not equal to it.
  CHECK(first_render_candidate({other(5), other(2), ours(3)}, 3) == 1u);
  CHECK_FALSE(first_render_candidate({other(1), ours(1)}, 1).has_value());
}

TEST_CASE("a candidate that was not timed is not recommended") {
  CHECK(fastest_candidate({{"", {}, true, 1, {}}, candidate(1, 10, 1)}, 4) == 1u);
  CHECK_FALSE(fastest_candidate({{"", {}, true, 1, {}}}, 4).has_value());
}

TEST_CASE("a candidate without an answer never fits") {
  CHECK_FALSE(fastest_candidate({candidate(std::numeric_limits<double>::quiet_NaN(), 1, 0),
                                 candidate(std::numeric_limits<double>::infinity(), 1, 0)},
                                1e300)
                  .has_value());
}

}  // namespace
}  // namespace glassbox::study
