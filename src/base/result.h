// Expected failure as a value: the subset of std::expected, which C++20 lacks, with an error that a person
// can act on.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "base/check.h"
#include "base/text.h"

namespace macula {

enum class ErrorCode {
    usage,            // the caller asked for something that does not exist: an unknown preset, a bad option
    inputNotUsable,   // missing, unreadable, malformed or unsupported input
    deviceNotUsable,  // no Vulkan driver, no such device
    deviceLost,       // the device stopped responding; another can be opened, see gpu::LastingDevice
    outOfMemory,      // out of host or device memory, or over a limit of the device
    outputNotWritable,
    archiveNotUsable,  // a PACS that cannot be reached, refuses, or answers what no archive should
    cancelled,
};

// `message` is one sentence that a radiologist understands, and `hint` says what to do; neither ever holds
// patient data. `where` is the file or object concerned. It may name a patient, as folder names do: it is
// shown to the person who entered it, and never logged.
struct Error {
    ErrorCode code = ErrorCode::inputNotUsable;
    Text message;
    std::string where;
    Text hint;
};

template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    bool ok() const { return state_.index() == 0; }
    explicit operator bool() const { return ok(); }

    T& value() & { return MACULA_CHECK(ok()), *std::get_if<0>(&state_); }
    const T& value() const& { return MACULA_CHECK(ok()), *std::get_if<0>(&state_); }
    T&& value() && { return MACULA_CHECK(ok()), std::move(*std::get_if<0>(&state_)); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    const Error& error() const { return MACULA_CHECK(!ok()), *std::get_if<1>(&state_); }

  private:
    std::variant<T, Error> state_;
};

// A result without a value: `return {};` is success.
template <>
class [[nodiscard]] Result<void> {
  public:
    Result() = default;
    Result(Error error) : error_(std::move(error)) {}

    bool ok() const { return !error_.has_value(); }
    explicit operator bool() const { return ok(); }
    const Error& error() const { return MACULA_CHECK(!ok()), *error_; }

  private:
    std::optional<Error> error_;
};

}  // namespace macula

// Unwraps a Result into a new variable, or returns its error from the enclosing function.
#define MACULA_CONCAT_(a, b) a##b
#define MACULA_CONCAT(a, b) MACULA_CONCAT_(a, b)
#define MACULA_TRY(declaration, expression) \
    MACULA_TRY_(MACULA_CONCAT(maculaResult_, __LINE__), declaration, expression)
#define MACULA_TRY_(result, declaration, expression) \
    auto result = (expression);                      \
    if (!result.ok()) return result.error();         \
    declaration = std::move(*result)
// The same for a Result<void>.
#define MACULA_TRY_VOID(expression)                          \
    do {                                                     \
        auto maculaStatus = (expression);                    \
        if (!maculaStatus.ok()) return maculaStatus.error(); \
    } while (false)
