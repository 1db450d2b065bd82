// Keeps what an archive sends, in a folder of the test.
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "net/archive/file_meta.h"
#include "net/archive/receiver.h"

namespace macula::net::test {

class WebReceiver final : public Receiver {
  public:
    explicit WebReceiver(const std::filesystem::path& folder, std::uintmax_t mostBytes = 1u << 30)
        : folder_(folder), mostBytes_(mostBytes) {
        std::filesystem::create_directories(folder);
    }

    Result<std::filesystem::path> place() override {
        const std::lock_guard guard(mutex_);
        if (errorOfPlace) return *errorOfPlace;
        const auto file = folder_ / std::to_string(++placed);
        std::ofstream(file).close();
        return file;
    }

    Result<Verdict> take(const std::filesystem::path& file, const InstanceKey& promised) override {
        const std::lock_guard guard(mutex_);
        ++taken;
        lastPromised = promised;
        if (onTake) onTake();
        const auto meta = readFileMeta(file);
        if (!meta.ok()) {
            std::filesystem::remove(file);
            return Verdict::refused;
        }
        if (!kept.emplace(meta->sopInstanceUid, file).second) {
            std::filesystem::remove(file);
            return Verdict::hadAlready;
        }
        return Verdict::kept;
    }

    void drop(const std::filesystem::path& file) noexcept override {
        const std::lock_guard guard(mutex_);
        ++dropped;
        std::error_code failed;
        std::filesystem::remove(file, failed);
    }

    std::uintmax_t mostBytesOfInstance() const override { return mostBytes_; }

    // Bytes that lie in the folder now.
    std::uintmax_t bytesOnDisk() const {
        std::uintmax_t bytes = 0;
        for (const auto& entry : std::filesystem::directory_iterator(folder_)) bytes += entry.file_size();
        return bytes;
    }

    std::map<std::string, std::filesystem::path> kept;  // by SOP Instance UID
    InstanceKey lastPromised;
    int placed = 0;
    int taken = 0;
    int dropped = 0;
    std::function<void()> onTake;
    std::optional<Error> errorOfPlace;

  private:
    std::filesystem::path folder_;
    std::uintmax_t mostBytes_;
    std::mutex mutex_;
};

}  // namespace macula::net::test
