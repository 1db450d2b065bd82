#include "cli/shared/report.h"

#include <algorithm>
#include <cstdio>

#include "base/elapsed.h"
#include "base/printable.h"
#include "base/progress_bar.h"

namespace macula::cli {

namespace {

const char* programName = "macula";

// A sentence from a library or a file name may hold a line break, and what steers a terminal; one error stays
// one line. Nobody can be told that stderr takes nothing.
void printLine(std::string line) {
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    clearProgressBar();
    std::fputs((printable(line) + "\n").c_str(), stderr);
}

}  // namespace

void nameProgram(const char* name) {
    programName = name;
}

std::string describe(const Error& error) {
    std::string line = error.message;
    if (!error.hint.empty()) line += " " + error.hint;
    if (!error.where.empty()) line += " (" + error.where + ")";
    return line;
}

void printError(const Error& error) {
    printLine(fmt::format("{}: {}", programName, describe(error)));
}

void printNote(std::string_view sentence) {
    printLine(fmt::format("{}: note: {}", programName, sentence));
}

void printWarning(std::string_view sentence) {
    printLine(fmt::format("{}: warning: {}", programName, sentence));
}

void printNotes(std::span<const std::string> notes, std::span<const std::string> warnings) {
    for (const std::string& note : notes) {
        const bool isWarning = std::find(warnings.begin(), warnings.end(), note) != warnings.end();
        isWarning ? printWarning(note) : printNote(note);
    }
}

void printWritten(const std::filesystem::path& path, std::chrono::steady_clock::time_point start,
                  std::string_view what) {
    printLine(fmt::format("Wrote {}{}{} in {:.1f} s", path.string(), what.empty() ? "" : ": ", what,
                          secondsSince(start)));
}

}  // namespace macula::cli
