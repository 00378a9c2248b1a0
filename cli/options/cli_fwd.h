// Forward declarations of CLI11 for headers: including all of it costs each source file some
// seconds of compile time.
#pragma once

namespace CLI {

class App;
class Option;

}  // namespace CLI
