#pragma once

#include <cstdio>
#include <cstdlib>

/// Ends the program, with the case in the fuzzer's hands, unless the condition holds. The rest is printed: a
/// format and its values.
#define BUOYANCY_EXPECT(condition, ...)                                                  \
    do {                                                                                 \
        if (!(condition)) {                                                              \
            std::fprintf(stderr, "%s:%d: not so: %s: ", __FILE__, __LINE__, #condition); \
            std::fprintf(stderr, __VA_ARGS__);                                           \
            std::fprintf(stderr, "\n");                                                  \
            std::abort();                                                                \
        }                                                                                \
    } while (false)
