// How these programs end: with 0, or with why not.
#pragma once

#include <base/result.h>

#include <cstdio>

inline int fail(const macula::Error& error) {
    std::fprintf(stderr, "%s %s\n", error.message.english().c_str(), error.hint.english().c_str());
    return 1;
}

inline int expect(bool holds, const char* what) {
    std::printf("%s: %s\n", what, holds ? "yes" : "NO");
    return holds ? 0 : 1;
}
