// Vectors of 32 bytes where the processor has them.
#pragma once

// GLASSBOX_WIDE before the first declaration of a function makes two copies of it, one with the
// instructions of AVX2. The loader chooses the copy that suits the processor. Both give the same
// bits, because each lane does the same IEEE operations and -ffp-contract=off keeps FMA out. A
// function that it calls must be inlined (GLASSBOX_INLINE) to be copied with it. On other
// processors than x86-64 there is one copy. The same holds under ThreadSanitizer, which is not
// ready yet when the loader chooses, and where an empty GLASSBOX_WIDE is defined on the command
// line, as in a program with which the tests compare the bits.
#if defined(__SANITIZE_THREAD__)
#define GLASSBOX_HAS_THREAD_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define GLASSBOX_HAS_THREAD_SANITIZER 1
#endif
#endif

#if defined(GLASSBOX_WIDE)
#elif defined(__x86_64__) && !defined(GLASSBOX_HAS_THREAD_SANITIZER)
#define GLASSBOX_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define GLASSBOX_WIDE
#endif

#define GLASSBOX_INLINE [[gnu::always_inline]] inline
