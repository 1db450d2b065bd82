// The queue of objects that wait for an archive (docs/privacy.md).
//
// A folder for each entry, 0700, which holds copies of the files, 0600, and notes on them. Names say nothing.
// An entry appears once it is whole and vanishes at once, so whatever kills the program leaves a queue that
// opens and has lost nothing; a file that was stored just then is sent a second time, which archives take for
// the same object. Nothing is ever sent but by send().
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/file_lock.h"
#include "base/progress.h"
#include "base/result.h"
#include "net/archive/archive.h"
#include "study/outbox/outbox_record.h"

namespace macula::study {

struct OutboxLimits {
    std::uintmax_t leastFreeBytes = 1ull << 30;  // left on the disk
    // How long to wait for another program that looks at an entry, or sends it.
    std::chrono::milliseconds patience{2'000};
};

enum class OutboxState {
    waiting,
    sending,  // by some program, at this moment
    refused,  // the archive took none of the files that are left
    damaged,  // the notes cannot be read; it can only be removed
};

enum class SendWhich { waiting, refusedToo };

struct OutboxEntry {
    std::string id;  // 16 hexadecimal digits
    std::filesystem::path folder;
    OutboxState state = OutboxState::waiting;
    OutboxRecord record;  // empty if damaged

    std::size_t toSend(SendWhich which) const;  // how many of the files
};

// What is to wait for an archive.
struct ToQueue {
    struct File {
        std::filesystem::path path;
        std::optional<Reason> refused = {};
    };
    std::string archive;
    std::string address = {};  // see OutboxRecord
    std::vector<File> files;
    std::vector<Identity> patients;  // whom the person confirmed
    std::size_t tries = 0;
    std::optional<Reason> trouble = {};  // of the last try
};

struct OutboxSent {
    std::size_t stored = 0;
    std::size_t refused = 0;  // in the entry now, those refused before included
    std::size_t left = 0;
    std::optional<Error> trouble;  // why files are left; cancelled, too
};

// The user's: outbox, in the data folder.
std::filesystem::path outboxFolder();

// Each call locks the entry that it changes. Thread-safe, as are several at once.
class Outbox {
  public:
    // Makes the folder if it is missing, and removes what killed programs left half made. Fails with
    // outputNotWritable.
    static Result<Outbox> open(std::filesystem::path folder = outboxFolder(), OutboxLimits limits = {});

    const std::filesystem::path& folder() const { return folder_; }

    // Those queued first come first.
    std::vector<OutboxEntry> entries() const;
    // By the first digits of its ID, at least four. Fails with usage.
    Result<OutboxEntry> find(std::string_view digits) const;

    // Copies the files, and returns the ID of the entry. Fails with inputNotUsable where a file is no whole
    // DICOM object or of somebody who is not among the patients; with outputNotWritable where the disk is
    // full; with cancelled. Then nothing is queued.
    Result<std::string> queue(const ToQueue& request, Progress& progress);

    using Which = SendWhich;
    // What is stored leaves the queue, and with its last file the entry. Fails with usage where there is no
    // such entry, or where somebody else is sending it; with inputNotUsable where it is damaged.
    Result<OutboxSent> send(const std::string& id, net::Archive& archive, Progress& progress,
                            Which which = Which::waiting);

    // A person has said that its archive is at this address now. Fails as send() does.
    Result<void> readdress(const std::string& id, const std::string& address);

    // Without sending it. Fails with usage as above.
    Result<void> remove(const std::string& id);

  private:
    Outbox(std::filesystem::path folder, OutboxLimits limits) : folder_(std::move(folder)), limits_(limits) {}

    std::filesystem::path folderOf(const std::string& id) const { return folder_ / id; }
    Result<FileLock> lock(const std::string& id) const;
    Result<void> checkRoom(const ToQueue& request) const;

    std::filesystem::path folder_;
    OutboxLimits limits_;
};

}  // namespace macula::study
