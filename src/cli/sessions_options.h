// What the subcommands of sessions have in common.
#pragma once

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/shared/json_text.h"
#include "live/store/store_json.h"
#include "live/store/store_text.h"
#include "session/store.h"

namespace macula::cli {

struct SessionsOptions {
    std::filesystem::path folder = session::defaultFolder();
    bool json = false;
};

// A subcommand with --folder and --json.
CLI::App* addSessionsVerb(CLI::App& sessions, const std::string& name, const std::string& help,
                          SessionsOptions& options);

// Opens the store, and makes it where there is none. Warnings of the opening go to stderr.
Result<session::Store> openStudyStore(const SessionsOptions& options);
void printWarnings(const std::vector<Text>& warnings);

// A report of app/session on stdout.
template <class Report>
void print(const SessionsOptions& options, const Report& report) {
    fmt::print("{}", options.json ? jsonText(live::toJson(report)) + "\n" : live::textOf(report));
}

// The same where nothing is stored; `report` is that of nothing.
template <class Report>
Result<void> printNothing(const SessionsOptions& options, const Report& report) {
    if (options.json)
        print(options, report);
    else
        fmt::print("{}", live::nothingStoredText(options.folder));
    return {};
}

}  // namespace macula::cli
