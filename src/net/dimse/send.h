// C-STORE: sending files to an archive, byte by byte as they are.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/archive.h"
#include "net/archive/file_meta.h"
#include "net/dimse/connector.h"

namespace macula::net {

class Sending {
  public:
    Sending(const Connector& connector, std::span<const std::filesystem::path> files, Progress& progress);

    Result<Sent> run();

  private:
    using Kind = std::pair<std::string, std::string>;  // SOP class, transfer syntax
    struct Outgoing {
        std::filesystem::path file;
        FileMeta meta;
        Kind kind() const { return {meta.sopClassUid, meta.transferSyntaxUid}; }
    };

    void readAll();
    // The files of as many kinds as one association can carry, from the first that is left.
    std::vector<Outgoing> nextBatch();
    Result<void> sendWithTries(std::vector<Outgoing>& batch);
    Result<void> sendBatch(std::vector<Outgoing>& batch);
    Result<void> sendFile(Association& association, const AcceptedContext& context, const Outgoing& outgoing);
    Result<void> sendBytes(Association& association, const AcceptedContext& context,
                           const Outgoing& outgoing);
    void note(const Outgoing& outgoing, const Error& error, bool isRefused = true);

    const Connector& connector_;
    std::span<const std::filesystem::path> files_;
    Progress& progress_;
    std::vector<Outgoing> left_;
    Sent sent_;
    bool isConnected_ = false;  // in the last try
};

}  // namespace macula::net
