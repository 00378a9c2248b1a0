// CLI11 by name alone, for headers: all of it costs every file that includes one of them some seconds to compile.
#pragma once

namespace CLI {

class App;
class Option;

}  // namespace CLI
