// A library that is loaded before a program's others (LD_PRELOAD): only the first FEW_THREADS
// threads can be started, as if memory or a limit on processes were exhausted.
#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                              void* (*function)(void*), void* argument) {
  static std::atomic<int> left = std::atoi(std::getenv("FEW_THREADS"));
  if (--left < 0) return EAGAIN;
  const auto create =
      reinterpret_cast<decltype(&pthread_create)>(dlsym(RTLD_NEXT, "pthread_create"));
  return create(thread, attributes, function, argument);
}
