#include "cli/report.h"

#include <unistd.h>

#include <cstdio>

namespace macula::cli {

namespace {

// A sentence from a library or a file name may hold a line break; one error stays one line.
void printLine(std::string line) {
    for (char& c : line) {
        if (c == '\n' || c == '\r') c = ' ';
    }
    // In the place of a progress bar that has not come to its end.
    if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\x1b[K");
    fmt::print(stderr, "macula: {}\n", line);
}

}  // namespace

int exitCode(ErrorCode code) {
    switch (code) {
        case ErrorCode::usage:
        case ErrorCode::outputNotWritable:
            return 2;
        case ErrorCode::inputNotUsable:
            return 3;
        case ErrorCode::deviceNotUsable:
        case ErrorCode::deviceLost:
        case ErrorCode::outOfMemory:
            return 4;
        case ErrorCode::cancelled:
            return 130;  // 128 + SIGINT, as shells expect
    }
    return 3;
}

std::string describe(const Error& error) {
    std::string line = error.message;
    if (!error.hint.empty()) line += " " + error.hint;
    if (!error.where.empty()) line += " (" + error.where + ")";
    return line;
}

void printError(const Error& error) {
    printLine(describe(error));
}

void printNote(std::string_view sentence) {
    printLine("note: " + std::string(sentence));
}

}  // namespace macula::cli
