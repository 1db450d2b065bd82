// The archives that a person and an administrator have set up, and their secrets.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/token_renewal.h"

namespace macula::net {

// Where the lists lie. Tests and hosts choose their own.
struct SourceFiles {
    std::filesystem::path managed;  // the administrator's, read only; need not exist
    std::filesystem::path own;      // the person's, 0600; need not exist
    std::filesystem::path secrets;  // 0600, of both lists

    // managed: macula/sources.json in the first folder of $XDG_CONFIG_DIRS that has it (else /etc/xdg).
    // The others: sources.json and secrets.json in the user's data folder.
    static SourceFiles ofUser();
};

// All archives, the administrator's first. Where both lists have a name, the administrator's counts.
// Not thread-safe. Each change reads the file again and writes it whole: two programs do not undo each
// other's changes, except of the same archive.
class SourceList {
  public:
    static Result<SourceList> read(SourceFiles files);

    const std::vector<Source>& all() const { return all_; }
    // By its name, in which case does not matter if only one fits. Fails with usage, and lists what there is.
    Result<Source> find(std::string_view name) const;

    // Replaces the archive of that name. Fails with usage where the settings cannot work or the archive is
    // the administrator's.
    Result<void> put(const Source& source);
    Result<void> remove(std::string_view name);  // with its secrets

    // None that were kept are empty. Fails with inputNotUsable where others can read the file.
    Result<Secrets> secretsOf(const Source& source) const;
    Result<void> keep(const Source& source, const Secrets& secrets);
    // As RenewTokens: threads and programs that share this file take turns, by a lock beside it.
    // `readBefore`: the refresh token that the file had when its secrets were read last; another one there is
    // newer than ours. Fails with archiveNotUsable where another holds them for minutes; with cancelled.
    Result<Secrets> renewTokens(const Source& source, const Secrets& ours, const std::string& readBefore,
                                const AskForTokens& ask, const CancelToken& cancel) const;

  private:
    explicit SourceList(SourceFiles files) : files_(std::move(files)) {}
    Result<void> readAgain();
    Result<void> refuseManaged(std::string_view name) const;
    // Only where the archive still has secrets.
    Result<void> keepTokens(const Source& source, const Secrets& secrets) const;

    SourceFiles files_;
    std::vector<Source> own_;
    std::vector<Source> all_;
};

}  // namespace macula::net
