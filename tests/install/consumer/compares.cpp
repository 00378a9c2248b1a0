// A user of the library compares a picture of the library's type without a test framework, and
// links nothing more. The program ends with 0 if the golden image matches itself, and one changed
// pixel is found.
#include <cstdio>

#include <glassbox/compare/testing/golden.h>
#include <glassbox/images/read.h>
#include <glassbox/images/stored_image.h>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  auto picture = glassbox::read_image(argv[1]);
  if (!picture || !glassbox::check_golden(*picture, argv[1], __FILE__)) return 1;
  picture->at(3, 4).r ^= 1;
  const glassbox::GoldenOutcome outcome = glassbox::check_golden(*picture, argv[1], __FILE__);
  std::printf("%s\n", outcome.message.c_str());
  return !outcome && outcome.message.find("1 of 57600 pixels") != std::string::npos ? 0 : 1;
}
