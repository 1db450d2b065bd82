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
    std::string line = error.message.english();
    if (!error.hint.empty()) line += " " + error.hint.english();
    if (!error.where.empty()) line += " (" + error.where + ")";
    return line;
}

void printError(const Error& error) {
    printLine(fmt::format("{}: {}", programName, describe(error)));
}

void PrintsNote::operator()(std::string_view sentence) const {
    printLine(fmt::format("{}: note: {}", programName, sentence));
}

void PrintsNote::operator()(const Text& sentence) const {
    (*this)(sentence.english());
}

void PrintsWarning::operator()(std::string_view sentence) const {
    printLine(fmt::format("{}: warning: {}", programName, sentence));
}

void PrintsWarning::operator()(const Text& sentence) const {
    (*this)(sentence.english());
}

void printNotes(std::span<const Text> notes, std::span<const Text> warnings) {
    for (const Text& note : notes) {
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
