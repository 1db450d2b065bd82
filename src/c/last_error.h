// Turns a Result, or an exception, into a macula_status and the text of macula_last_error.
#pragma once

#include <macula.h>

#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <utility>

#include "base/check.h"
#include "base/result.h"

namespace macula::c {

// Keeps the error for macula_last_error of this thread, and returns its status. Throws nothing: without
// memory for the texts it keeps MACULA_MEMORY instead.
macula_status keep(const Error& error) noexcept;
macula_status keepFault() noexcept;
macula_status keepFault(const CheckFailure& failure) noexcept;  // with the text of the check
macula_status keepOutOfMemory() noexcept;

// The error of a wrong argument: usage.
inline Error badArgument(Text message, Text advice) {
    return {ErrorCode::usage, std::move(message), {}, std::move(advice)};
}

inline Error nullHandle() {
    return badArgument(Text("A handle or a place for a result is null."),
                       Text("See macula.h for what the function needs."));
}

// Turns the log off, because stderr is the host's: until macula_log_to, or unless MACULA_LOG asks for it.
void silenceLog() noexcept;

// Runs `body`, which returns a Result<void>. No exception gets out, and no check aborts.
template <class Body>
macula_status guarded(const Body& body) noexcept {
    silenceLog();
    const CheckBoundary boundary;
    try {
        const Result<void> done = body();
        return done ? MACULA_DONE : keep(done.error());
    } catch (const std::bad_alloc&) {
        return keepOutOfMemory();
    } catch (const std::system_error& error) {
        // The system has no more threads. Other errors of the system are handled where they occur.
        return error.code() == std::errc::resource_unavailable_try_again ? keepOutOfMemory() : keepFault();
    } catch (const CheckFailure& failure) {
        return keepFault(failure);
    } catch (...) {
        return keepFault();
    }
}

}  // namespace macula::c
