// Restricts the system calls that a process may make (seccomp).
#pragma once

#include <linux/filter.h>

#include <string>
#include <vector>

#include <glassbox/base/error.h>

namespace glassbox::labs::grading {

// A filter of system calls in the form that the kernel takes.
using SystemCallFilter = std::vector<sock_filter>;

// False if the program was built without libseccomp.
bool can_filter_system_calls();

// The filter for a student's code, which computes and writes to files that are open already. It may
// not open, make or remove files, start processes or threads, signal another process, use the
// network, or change its own limits. A forbidden call raises SIGSYS.
//
// `in_namespace`: whether the process is in a process namespace of its own, where there is no other
// process to signal. Elsewhere the filter contains kOwnPid in the place of the process's own
// number; set_own_pid replaces it.
Result<SystemCallFilter> runner_filter(bool in_namespace);

// The filter for a compiler, which needs files and processes: no network, no tracing, no mounts, no
// new privileges or namespaces. A forbidden call fails with EPERM.
Result<SystemCallFilter> compiler_filter();

inline constexpr unsigned kOwnPid = 0x3ead1dea;  // greater than any process number (at most 2^22)
// puts the process's own number in the place of kOwnPid; allocates nothing, so it can be used after
// fork
void set_own_pid(SystemCallFilter& filter, unsigned pid);

// The name of a system call, "openat"; or "system call 257" where the name is not known.
std::string system_call_name(int number);

}  // namespace glassbox::labs::grading
