// Which files a process may reach (Landlock, Linux 5.13 and later): for machines that give it no file system of its own.
#pragma once

#include <filesystem>
#include <vector>

namespace glassbox::labs::grading {

// A set of rules as a file descriptor of the kernel's, closed with it.
class FileRules {
public:
  FileRules() = default;
  // Only what lies at or below `readable` can be read and executed, and only what lies below `writable` written. Paths that do not
  // exist are passed over.
  FileRules(const std::vector<std::filesystem::path>& readable,
            const std::vector<std::filesystem::path>& writable);
  ~FileRules();
  FileRules(const FileRules&) = delete;
  FileRules& operator=(const FileRules&) = delete;

  bool valid() const { return ruleset_ >= 0; }
  int descriptor() const { return ruleset_; }

private:
  int ruleset_ = -1;
};

bool can_rule_files();

// Puts the calling process under the rules, for good. It must have set no_new_privs. Allocates nothing: for use after fork.
bool obey_file_rules(int descriptor);

}  // namespace glassbox::labs::grading
