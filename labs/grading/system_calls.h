// Which system calls a process may make (seccomp).
#pragma once

#include <linux/filter.h>

#include <string>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

// A filter in the kernel's form.
using SystemCallFilter = std::vector<sock_filter>;

// False where the program was built without libseccomp.
bool can_filter_system_calls();

// For a student's code, which computes and writes to what is open already. It may not open, make or remove files, start
// processes or threads, signal another process, use the network, or change its own limits. A forbidden call raises SIGSYS.
//
// `in_namespace`: of processes of its own, where there is nobody to signal. Elsewhere the filter holds kOwnPid where the process's
// own number belongs; put_own_pid replaces it.
Result<SystemCallFilter> runner_filter(bool in_namespace);

// For a compiler, which needs files and processes: no network, no tracing, no mounts, no new privileges or namespaces. A
// forbidden call fails with EPERM.
Result<SystemCallFilter> compiler_filter();

inline constexpr unsigned kOwnPid = 0x3ead1dea;  // above the kernel's largest process number, 2^22
void put_own_pid(SystemCallFilter& filter, unsigned pid);  // allocates nothing: for use after fork

// "openat"; "system call 257" where the name is not known.
std::string system_call_name(int number);

}  // namespace glassbox::labs::grading
