// Checks for programmer errors and clinical invariants, active in release builds too. A failed check prints
// its place and both values and aborts, because a wrong image would be worse. Within a CheckBoundary it
// throws instead.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

namespace macula {

[[noreturn]] void checkFailed(const char* file, int line, const char* what, const std::string& values);

// The exception of a failed check. Not a std::exception, so that handlers for exceptions of libraries let it
// pass.
class CheckFailure {
  public:
    explicit CheckFailure(std::string text) : text_(std::move(text)) {}
    const std::string& text() const { return text_; }  // where, what, and both values

  private:
    std::string text_;
};

// While a boundary exists, checks that fail in its thread throw CheckFailure, so that a host program survives
// (src/c). The code that makes the boundary catches it, and bars further use of the objects that were in use.
// Helper threads of this one make boundaries of their own (parallel.cpp). In a destructor a failed check
// still aborts.
class CheckBoundary {
  public:
    CheckBoundary() noexcept;
    CheckBoundary(const CheckBoundary&) = delete;
    CheckBoundary& operator=(const CheckBoundary&) = delete;
    ~CheckBoundary();

    static bool isDrawn() noexcept;  // whether this thread has a boundary
};

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
