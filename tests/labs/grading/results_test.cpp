#include "labs/grading/results.h"

#include "labs/grading/class_overview.h"
#include "tests/labs/grading/grading.h"
#include "tests/labs/grading/tiny_lab.h"
#include "tests/support/catch.h"

namespace glassbox::test {

using namespace labs::grading;

TEST_CASE("results.json has Gradescope's fields, in its types and with its words") {
  const auto json =
      gradescope_json(ungraded_submission(tiny_labs()[0], "compile error"), "a sandbox");
  CHECK(json.at("output").is_string());
  CHECK(json.at("output_format") == "text");
  CHECK_FALSE(json.contains("score"));  // Gradescope adds up the tests
  CHECK(json.at("stdout_visibility") == "hidden");
  CHECK(json.at("extra_data").is_object());
  REQUIRE(json.at("tests").size() == 3);
  double most = 0;
  for (const auto& test : json.at("tests")) {
    CHECK(test.at("score") == 0);
    most += test.at("max_score").get<double>();
    CHECK(test.at("status") == "failed");
    CHECK(test.at("name").is_string());
    CHECK(test.at("number").is_string());
    CHECK(test.at("output").is_string());
    CHECK(test.at("output_format") == "text");
    CHECK(test.at("tags").size() == 3);
    const std::string visibility = test.at("visibility");
    CHECK((visibility == "visible" || visibility == "after_published"));
    CHECK(test.at("extra_data").is_object());
  }
  CHECK(most == 10);
  CHECK(json.at("tests")[2].at("number") == "99.2.2");
}

TEST_CASE("GitHub Classroom's JSON has what its reporter adds up, and hides what is hidden") {
  const auto json =
      classroom_json(gradescope_json(ungraded_submission(tiny_labs()[0], "compile error"), ""));
  CHECK(json.at("version") == 1);
  CHECK(json.at("status") == "error");
  CHECK(json.at("max_score") == 10);
  REQUIRE(json.at("tests").size() == 3);
  CHECK(json.at("tests")[0].at("status") == "fail");
  CHECK(json.at("tests")[0].at("score") == 0);
  const auto& hidden = json.at("tests")[2];
  CHECK(hidden.at("name") == "hidden checks");
  CHECK(hidden.at("message") == "hidden");
  CHECK(hidden.at("max_score") == 3);
  for (const labs::Check& check : tiny_labs()[0].checks)
    CHECK((json.dump().find(check.name) == std::string::npos) == check.hidden);
  CHECK(classroom_json(unfinished_json()).at("status") == "error");
}

TEST_CASE("what a student wrote is text in every file: no markup, no formula, no broken UTF-8") {
  GradedSubmission graded = ungraded_submission(tiny_labs()[0], "compile error");
  graded.messages = "<script>alert(1)</script>\xff\xfe";
  const auto json = nlohmann::ordered_json::parse(text_of(gradescope_json(graded, "")));
  const std::vector<ClassRow> rows{{"=HYPERLINK(\"x\",1)", json}, {"a,b<i>", json}};
  const std::string html = class_html(rows), csv = class_csv(rows);
  CHECK(html.find("<script>") == std::string::npos);
  CHECK(html.find("&lt;script&gt;") != std::string::npos);
  CHECK(html.find("<i>") == std::string::npos);
  CHECK(csv.find("\"'=HYPERLINK(\"\"x\"\",1)\",0,10,compile error,0,0\r\n") != std::string::npos);
  CHECK(csv.find("\"a,b<i>\",0,10,compile error,0,0\r\n") != std::string::npos);
}

}  // namespace glassbox::test
