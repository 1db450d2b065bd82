#include "c/last_error.h"

#include <string>

#include "c/sized.h"
#include "c/utf8_text.h"

namespace macula::c {

namespace {

struct Kept {
    macula_status status = MACULA_DONE;
    // Either these, or the fixed texts, which need no memory.
    std::string message;
    std::string advice;
    std::string place;
    const char* fixed = nullptr;
    const char* fixedAdvice = nullptr;
};
thread_local Kept kept;

macula_status statusOf(ErrorCode code) {
    switch (code) {
        case ErrorCode::usage:
            return MACULA_USAGE;
        case ErrorCode::inputNotUsable:
            return MACULA_INPUT;
        case ErrorCode::deviceNotUsable:
        case ErrorCode::deviceLost:
            return MACULA_DEVICE;
        case ErrorCode::outOfMemory:
            return MACULA_MEMORY;
        case ErrorCode::cancelled:
            return MACULA_CANCELLED;
        case ErrorCode::outputNotWritable:
            return MACULA_OUTPUT;
        case ErrorCode::archiveNotUsable:
            return MACULA_ARCHIVE;
    }
    return MACULA_FAULT;
}

macula_status keepFixed(macula_status status, const char* message, const char* advice) noexcept {
    kept.status = status;
    kept.fixed = message;
    kept.fixedAdvice = advice;
    return status;
}

}  // namespace

macula_status keep(const Error& error) noexcept {
    try {
        kept.message = utf8Of(error.message.english());
        kept.advice = utf8Of(error.hint.english());
        kept.place = utf8Of(error.where);
    } catch (const std::exception&) {
        return keepOutOfMemory();
    }
    kept.fixed = nullptr;
    return kept.status = statusOf(error.code);
}

macula_status keepFault(const CheckFailure& failure) noexcept {
    try {
        kept.message = "Macula found a mistake of its own, and stopped before it could show something wrong.";
        kept.advice = "Close what was in use and open it again. Please report this: " + failure.text();
        kept.place.clear();
    } catch (const std::exception&) {
        return keepFault();
    }
    kept.fixed = nullptr;
    return kept.status = MACULA_FAULT;
}

macula_status keepOutOfMemory() noexcept {
    return keepFixed(MACULA_MEMORY, "There is not enough memory.",
                     "Close other programs, or open a smaller series.");
}

macula_status keepFault() noexcept {
    return keepFixed(MACULA_FAULT, "Something went wrong that Macula did not foresee.",
                     "Please report what was done.");
}

extern "C" macula_status macula_last_error(macula_error* error) {
    const bool isFixed = kept.fixed != nullptr;
    macula_error told{};
    told.status = kept.status;
    told.message = isFixed ? kept.fixed : kept.message.c_str();
    told.advice = isFixed ? kept.fixedAdvice : kept.advice.c_str();
    told.place = isFixed ? "" : kept.place.c_str();
    // Not guarded(): a refusal must not replace the error that was asked for.
    return give(told, error) ? MACULA_DONE : MACULA_USAGE;
}

}  // namespace macula::c
