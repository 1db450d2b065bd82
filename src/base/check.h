// Programmer errors and clinical invariants: on in release too. A failed check says where, prints both
// values, and aborts: to go on with a wrong image would be worse.
#pragma once

#include <fmt/format.h>

#include <string>

namespace macula {

[[noreturn]] void checkFailed(const char* file, int line, const char* what, const std::string& values);

}  // namespace macula

#define MACULA_CHECK(condition) \
    ((condition) ? void() : ::macula::checkFailed(__FILE__, __LINE__, #condition, {}))

#define MACULA_CHECK_OP_(a, op, b)                                                 \
    do {                                                                           \
        const auto& maculaA = (a);                                                 \
        const auto& maculaB = (b);                                                 \
        if (!(maculaA op maculaB))                                                 \
            ::macula::checkFailed(__FILE__, __LINE__, #a " " #op " " #b,           \
                                  fmt::format("{} against {}", maculaA, maculaB)); \
    } while (false)
#define MACULA_CHECK_EQ(a, b) MACULA_CHECK_OP_(a, ==, b)
#define MACULA_CHECK_LE(a, b) MACULA_CHECK_OP_(a, <=, b)
#define MACULA_CHECK_LT(a, b) MACULA_CHECK_OP_(a, <, b)
