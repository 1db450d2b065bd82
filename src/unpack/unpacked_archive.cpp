#include "unpack/unpacked_archive.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/exceptions.h"
#include "base/private_file.h"
#include "base/user_folder.h"
#include "unpack/archive_reader.h"
#include "unpack/safe_names.h"

namespace macula::unpack {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kChunkBytes = 256 * 1024;
constexpr std::size_t kSteps = 1000;      // of progress
constexpr std::size_t kMostOfName = 512;  // bytes; longer names get no second name
constexpr int kMostPlaces = 16;           // that are tried for one file

Error cancelledError() {
    return {ErrorCode::cancelled, Text("Unpacking was cancelled."), {}, {}};
}

// A new file, 0600, which follows no link and replaces nothing.
class NewFile {
  public:
    explicit NewFile(const fs::path& path)
        : descriptor_(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600)) {}
    NewFile(NewFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    NewFile& operator=(NewFile&&) = delete;
    ~NewFile() {
        if (descriptor_ >= 0) close(descriptor_);
    }

    bool isOpen() const { return descriptor_ >= 0; }
    bool write(std::span<const std::byte> bytes) const {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) return false;
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
        return true;
    }

  private:
    int descriptor_;
};

class Unpacking {
  public:
    Unpacking(const fs::path& archive, const fs::path& folder, Progress& progress, const UnpackLimits& limits)
        : archive_(archive),
          folder_(folder),
          progress_(progress),
          budget_(limits, archive, folder),
          reader_(archive),
          chunk_(kChunkBytes) {
        std::error_code unknown;
        const std::uintmax_t bytes = fs::file_size(archive, unknown);
        archiveBytes_ = unknown ? 1 : std::max<std::uintmax_t>(bytes, 1);
    }

    Result<ArchiveFacts> run() {
        progress_.beginStage(Text("Unpacking the archive"), kSteps);
        ArchiveEntry entry;
        bool isFirst = true;
        for (ArchiveReader::Step step = reader_.next(entry); step != ArchiveReader::Step::end;
             step = reader_.next(entry), isFirst = false) {
            if (progress_.cancelled()) return cancelledError();
            facts_.isCutOff = step == ArchiveReader::Step::broken;
            if (facts_.isCutOff && isFirst) return noArchive();
            if (facts_.isCutOff) break;
            MACULA_TRY_VOID(budget_.beginEntry(reader_.positionBytes()));
            MACULA_TRY_VOID(take(entry));
        }
        facts_.isCutOff = facts_.isCutOff || isTarWithoutEnd();
        if (facts_.files == 0) return nothingIn();
        return facts_;
    }

  private:
    Result<void> take(const ArchiveEntry& entry) {
        if (entry.kind == ArchiveEntry::Kind::folder || SafeNames::isLeftByMacOs(entry.name)) return {};
        if (entry.kind == ArchiveEntry::Kind::file && !entry.isEncrypted) return takeFile(entry);
        if (entry.kind == ArchiveEntry::Kind::secondName) {
            takeSecondName(entry);
        } else {
            ++(entry.isEncrypted ? facts_.encrypted : facts_.links);
        }
        return {};
    }

    Result<void> takeFile(const ArchiveEntry& entry) {
        fs::path place;
        bool wasOutside = false;
        {
            MACULA_TRY(NewFile file, makeFile(entry, place, wasOutside));
            MACULA_TRY(const bool isWhole, copy(file));
            if (isWhole) {
                keep(entry, place, wasOutside);
                return {};
            }
        }
        ++facts_.damaged;
        std::error_code ignored;
        fs::remove(folder_ / place, ignored);
        return {};
    }

    void keep(const ArchiveEntry& entry, const fs::path& place, bool wasOutside) {
        ++facts_.files;
        facts_.outside += wasOutside ? 1 : 0;
        if (entry.name.size() <= kMostOfName) places_.try_emplace(entry.name, place);
    }

    // A hard link refers to a file of the archive by its name there, never to one of this machine. Tar and
    // ISO 9660 store files that are the same once.
    void takeSecondName(const ArchiveEntry& entry) {
        const auto first = places_.find(entry.nameOfFirst);
        if (first == places_.end()) {
            ++facts_.links;
            return;
        }
        const SafeNames::Place place = names_.placeOf(entry.name);
        std::error_code failure;
        fs::create_directories((folder_ / place.path).parent_path(), failure);
        if (!failure) fs::create_hard_link(folder_ / first->second, folder_ / place.path, failure);
        if (failure) {
            ++facts_.links;
        } else {
            keep(entry, place.path, place.wasOutside);
        }
    }

    // Where the entry's place is taken by another entry, which may be a file where this one needs a folder,
    // it gets another one.
    Result<NewFile> makeFile(const ArchiveEntry& entry, fs::path& place, bool& wasOutside) {
        const SafeNames::Place wanted = names_.placeOf(entry.name);
        wasOutside = wanted.wasOutside;
        place = wanted.path;
        for (int tries = 0; tries < kMostPlaces; ++tries, place = names_.otherPlace()) {
            std::error_code failure;
            fs::create_directories((folder_ / place).parent_path(), failure);
            if (failure == std::errc::no_space_on_device) return budget_.diskFull();
            NewFile file(folder_ / place);
            if (file.isOpen()) return file;
            if (errno == ENOSPC || errno == EDQUOT) return budget_.diskFull();
        }
        return Error{ErrorCode::outputNotWritable, Text("The copy of the archive cannot be written."),
                     folder_.string(), Text("Check free space, and the permissions of the data folder.")};
    }

    // Whether all of the file could be read.
    Result<bool> copy(const NewFile& file) {
        while (true) {
            if (progress_.cancelled()) return cancelledError();
            const std::optional<std::size_t> bytes = reader_.read(chunk_);
            if (!bytes || *bytes == 0) return bytes.has_value();
            const std::uint64_t position = reader_.positionBytes();
            MACULA_TRY_VOID(budget_.spend(*bytes, position));
            if (!file.write(std::span(chunk_).first(*bytes))) return budget_.diskFull();
            tell(position);
        }
    }

    void tell(std::uint64_t position) {
        const auto steps = static_cast<std::size_t>(std::min(1.0, double(position) / double(archiveBytes_)) *
                                                    double(kSteps));
        if (steps <= told_) return;
        progress_.advance(steps - told_);
        told_ = steps;
    }

    Error noArchive() const {
        return {ErrorCode::inputNotUsable,
                Text("The file is no archive that Macula can open, whatever its name says: it opens ZIP, tar "
                     "and ISO "
                     "9660 files."),
                archive_.string(),
                Text("Unpack it with another program, and open the folder. If that fails too, get the file "
                     "again.")};
    }

    Error nothingIn() const {
        const auto fail = [&](Text sentence, Text action) {
            return Error{ErrorCode::inputNotUsable, std::move(sentence), archive_.string(),
                         std::move(action)};
        };
        if (facts_.encrypted > 0)
            return fail(
                Text("The archive is encrypted, and cannot be opened without its password."),
                Text("Unpack it with another program, which asks for the password, and open the folder."));
        if (facts_.isCutOff || facts_.damaged > 0)
            return fail(Text("No file in the archive can be read: it is damaged or incomplete."),
                        Text("Get the archive again."));
        return fail(Text("There is no file in the archive."), Text("Choose another file."));
    }

    // A tar file ends with zeros (POSIX 1003.1, pax). libarchive does not miss them, and one that was cut off
    // between two files would look whole.
    bool isTarWithoutEnd() const {
        std::ifstream file(archive_, std::ios::binary);
        std::array<char, 512> block{};
        constexpr std::size_t kMagicAt = 257;
        file.read(block.data(), block.size());
        if (!file || std::string_view(block.data() + kMagicAt, 5) != "ustar") return false;
        file.seekg(-static_cast<std::streamoff>(block.size()), std::ios::end);
        file.read(block.data(), block.size());
        return !file || std::ranges::any_of(block, [](char c) { return c != 0; });
    }

    const fs::path& archive_;
    const fs::path& folder_;
    Progress& progress_;
    Budget budget_;
    ArchiveReader reader_;
    SafeNames names_;
    std::vector<std::byte> chunk_;
    std::uintmax_t archiveBytes_ = 1;
    std::size_t told_ = 0;  // of kSteps
    ArchiveFacts facts_;
    std::unordered_map<std::string, fs::path> places_;  // of files, by their names in the archive
};

}  // namespace

fs::path unpackedFolder() {
    return userDataFolder() / "unpacked";
}

void removeAbandoned() {
    removeAbandonedDrafts(unpackedFolder());
}

Result<std::shared_ptr<const UnpackedArchive>> unpack(const fs::path& archive, Progress& progress,
                                                      const UnpackLimits& limits) try {
    MACULA_TRY_VOID(makePrivateFolder(unpackedFolder()));
    removeAbandoned();
    MACULA_TRY(Draft draft, Draft::beside(unpackedFolder() / "archive", Draft::Kind::folder));
    MACULA_TRY_VOID(makePrivateFolder(draft.path()));
    MACULA_TRY(const ArchiveFacts facts, Unpacking(archive, draft.path(), progress, limits).run());
    return std::make_shared<const UnpackedArchive>(std::move(draft), facts);
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("unpack this archive"), archive.string());
}

}  // namespace macula::unpack
