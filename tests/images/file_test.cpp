#include "tests/support/catch.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <string_view>
#include <thread>

#include <glassbox/images/atomic_file.h>
#include <glassbox/images/read.h>

#include "tests/images/temporary_directory.h"
#include "tests/support/skip.h"

namespace {

using namespace glassbox;
using test::TemporaryDirectory;
using Names = std::vector<std::string>;

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

std::string content(const std::string& path) {
  const auto bytes = read_file(path);
  if (!bytes) return "unreadable: " + bytes.error().message();
  return std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size());
}

unsigned permissions(const std::string& path) {
  struct stat status = {};
  return ::stat(path.c_str(), &status) == 0 ? status.st_mode & 0777u : 0u;
}

// Runs `work` in a child process and returns its result, which must be below 128.
template <class Work>
int in_child(Work work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

// Becomes user "nobody" if the tests run as root, because root may write anywhere. Returns whether
// the process now has an ordinary user's rights.
bool drop_privileges() {
  return ::geteuid() != 0 || (::setgid(65534) == 0 && ::setuid(65534) == 0);
}

}  // namespace

TEST_CASE("a written file holds exactly the bytes, and no temporary is left") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("a file.bin");
  for (const std::string& text : {std::string("first"), std::string(), std::string(3000000, 'x')}) {
    REQUIRE(write_file(path, bytes_of(text)));
    CHECK(content(path) == text);
    CHECK(directory.names() == Names{"a file.bin"});
  }
}

TEST_CASE("a name without a directory is written to the current one") {
  const TemporaryDirectory directory;
  CHECK(in_child([&] {
          if (::chdir(directory.path().c_str()) != 0) return 1;
          return write_file("plain", bytes_of("text")) ? 0 : 2;
        }) == 0);
  CHECK(content(directory.file("plain")) == "text");
}

TEST_CASE("a new file gets the permissions of the umask, an existing one keeps its own") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("file");
  CHECK(in_child([&] {
          ::umask(027);
          return write_file(path, bytes_of("a")) ? 0 : 1;
        }) == 0);
  CHECK(permissions(path) == 0640u);
  ::chmod(path.c_str(), 0604);
  REQUIRE(write_file(path, bytes_of("b")));
  CHECK(permissions(path) == 0604u);
}

TEST_CASE("a symbolic link stays a link, and the file behind it is replaced") {
  const TemporaryDirectory directory;
  const std::string real = directory.file("real"), link = directory.file("link");
  REQUIRE(write_file(real, bytes_of("old")));
  REQUIRE(::symlink("real", link.c_str()) == 0);
  REQUIRE(write_file(link, bytes_of("new")));
  CHECK(std::filesystem::is_symlink(link));
  CHECK(content(real) == "new");
}

TEST_CASE("the longest file name that the file system takes can be written") {
  const TemporaryDirectory directory;
  const std::string name(255, 'n');
  CHECK(write_file(directory.file(name), bytes_of("text")));
  CHECK(directory.names() == Names{name});
}

TEST_CASE("writing to a directory, into a missing one or to no name is refused with a reason") {
  const TemporaryDirectory directory;
  const std::string target = directory.file("target");
  REQUIRE(std::filesystem::create_directory(target));
  const auto onto = write_file(target, bytes_of("text"));
  REQUIRE_FALSE(onto);
  CHECK(onto.error().message() == target + ": is a directory; name a file in it");

  const std::string lost = directory.file("missing/file");
  const auto into = write_file(lost, bytes_of("text"));
  REQUIRE_FALSE(into);
  CHECK(into.error().message() ==
        lost + ": cannot be written: No such file or directory; make the directory first");
  CHECK_FALSE(write_file("", bytes_of("text")));
  CHECK(directory.names() == Names{"target"});
}

TEST_CASE("a read-only directory or file is left as it was") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("file");
  REQUIRE(write_file(path, bytes_of("old")));
  REQUIRE(::chmod(path.c_str(), 0444) == 0);
  const auto refused = [&](const std::string& name) {
    return in_child([&] {
      if (!drop_privileges()) return 3;
      const auto written = write_file(name, bytes_of("new"));
      if (written) return 1;
      return written.error().cause == "cannot be written: Permission denied" ? 0 : 2;
    });
  };
  SECTION("the file is protected, its directory is not") {
    REQUIRE(::chmod(directory.path().c_str(), 0777) == 0);
    CHECK(refused(path) == 0);
  }
  SECTION("the directory is protected") {
    REQUIRE(::chmod(path.c_str(), 0666) == 0);
    REQUIRE(::chmod(directory.path().c_str(), 0555) == 0);
    CHECK(refused(path) == 0);
    CHECK(refused(directory.file("another")) == 0);
  }
  CHECK(content(path) == "old");
  CHECK(directory.names() == Names{"file"});
}

TEST_CASE("a write that fails half way leaves the old file and no temporary") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("file");
  REQUIRE(write_file(path, bytes_of("old")));
  // A limit on the size of files replaces a full disk: it cuts the write short in the same way.
  CHECK(in_child([&] {
          std::signal(SIGXFSZ, SIG_IGN);
          const rlimit limit{10000, 10000};
          if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return 1;
          const auto written = write_file(path, bytes_of(std::string(100000, 'x')));
          if (written) return 2;
          return written.error().remedy == "free some space or write to another disk" ? 0 : 3;
        }) == 0);
  CHECK(content(path) == "old");
  CHECK(directory.names() == Names{"file"});
}

TEST_CASE("a full device is an error that says so") {
  if (::access("/dev/full", W_OK) != 0) SKIP_TEST("/dev/full cannot be written to");
  const auto written = write_file("/dev/full", bytes_of("text"));
  REQUIRE_FALSE(written);
  CHECK(written.error().message() ==
        "/dev/full: cannot be written: No space left on device; free some space or write to "
        "another disk");
}

TEST_CASE("a pipe is written directly and stays a pipe") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("pipe");
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  std::string received;
  std::thread reader([&] { received = content(path); });
  const auto written = write_file(path, bytes_of("through"));
  reader.join();
  CHECK(written);
  CHECK(received == "through");
  CHECK(std::filesystem::is_fifo(path));
}

TEST_CASE("/dev/stdout that is a regular file is added to, not replaced") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("log");
  REQUIRE(write_file(path, bytes_of("before ")));
  CHECK(in_child([&] {
          const int file = ::open(path.c_str(), O_WRONLY | O_APPEND);
          if (file < 0 || ::dup2(file, 1) < 0) return 1;
          return write_file("/dev/stdout", bytes_of("after")) ? 0 : 2;
        }) == 0);
  CHECK(content(path) == "before after");
}

TEST_CASE("reading names what is wrong with a file") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("file");
  CHECK(content(path) == "unreadable: " + path +
                             ": cannot be opened: No such file or directory; check the name and "
                             "the permissions");
  CHECK_FALSE(read_file(directory.path().string()));
  REQUIRE(write_file(path, bytes_of("12345")));
  CHECK(read_file(path, 5));
  CHECK_FALSE(read_file(path, 4));
  CHECK_FALSE(read_file("/dev/zero", 100000));
}
