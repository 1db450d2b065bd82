// How macula receive listens, and to whom.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "net/dimse/store_provider.h"
#include "study/archive/receiving.h"

namespace macula::cli {

struct ReceiveOptions {
    net::StoreProviderOptions provider;
    std::vector<std::string> from;  // TITLE, TITLE@ADDRESS or *@ADDRESS
    double limitGigabytes = 0.0;    // 0: none
    std::filesystem::path into;
    double doneAfterSeconds = 5.0;
    double forSeconds = 0.0;  // 0: until somebody stops it
    bool once = false;
    bool json = false;
};

void addReceiveOptions(CLI::App& command, ReceiveOptions& options);

// Fails with usage where a caller is not written as it should be.
Result<study::ReceivingOptions> receivingOptions(const ReceiveOptions& options);

}  // namespace macula::cli
