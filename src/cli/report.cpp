#include "cli/report.h"

#include <algorithm>
#include <cstdio>

#include "base/progress_bar.h"

namespace macula::cli {

namespace {

// A sentence from a library or a file name may hold a line break; one error stays one line. Nobody can be
// told that stderr takes nothing.
void printLine(std::string line) {
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    clearProgressBar();
    std::fputs((line + "\n").c_str(), stderr);
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
    printLine("macula: " + describe(error));
}

void printNote(std::string_view sentence) {
    printLine("macula: note: " + std::string(sentence));
}

void printWarning(std::string_view sentence) {
    printLine("macula: warning: " + std::string(sentence));
}

void printWritten(const std::filesystem::path& path, std::chrono::steady_clock::time_point start) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    printLine(fmt::format("Wrote {} in {:.1f} s", path.string(), seconds));
}

}  // namespace macula::cli
