#include "dicom/read/media_directory.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "base/exceptions.h"
#include "dicom/read/dataset.h"
#include "dicom/read/folder.h"
#include "dicom/read/sop_class.h"
#include "dicom/read/tags.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

struct DirectoryRecord {
    std::vector<std::string> fileId;  // ReferencedFileID: the names on the way to the file
    std::string sopInstanceUid;       // empty when the record does not say
    std::string seriesInstanceUid;    // the series that lists the record; empty when there is none
    std::optional<int> instanceNumber;
};

constexpr Tag kNextRecord{0x0004, 0x1400};
constexpr Tag kRecordInUse{0x0004, 0x1410};
constexpr Tag kLowerLevel{0x0004, 0x1420};
constexpr Tag kRecordType{0x0004, 0x1430};
constexpr Tag kReferencedFile{0x0004, 0x1500};
constexpr Tag kReferencedInstance{0x0004, 0x1511};

std::uint64_t offsetIn(const Dataset& record, Tag tag) {
    return static_cast<std::uint64_t>(record.number(tag).value_or(0.0));
}

bool isSeries(const Dataset& record) {
    return record.shortText(kRecordType) == "SERIES";
}

// The series of each record; an empty UID where there is none.
std::vector<std::string> seriesOf(const std::vector<Dataset>& records) {
    std::map<std::uint64_t, std::size_t> byOffset;
    for (std::size_t i = 0; i < records.size(); ++i) byOffset.emplace(records[i].offset(), i);
    std::vector<std::string> series(records.size());
    std::vector<bool> isFound(records.size(), false);
    for (const Dataset& record : records) {
        if (!isSeries(record)) continue;
        const std::string uid = record.shortText(tag::kSeriesInstanceUid);
        // No record is visited twice, so that rings end.
        for (auto at = byOffset.find(offsetIn(record, kLowerLevel));
             at != byOffset.end() && !isFound[at->second];
             at = byOffset.find(offsetIn(records[at->second], kNextRecord))) {
            isFound[at->second] = true;
            series[at->second] = uid;
        }
    }
    std::string before;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const std::string type = records[i].shortText(kRecordType);
        if (type == "PATIENT" || type == "STUDY") before.clear();
        if (type == "SERIES") before = records[i].shortText(tag::kSeriesInstanceUid);
        if (!isFound[i]) series[i] = before;
    }
    return series;
}

// The records in use that name a file, in file order. A record belongs to the series whose offsets lead to it
// (PS3.3 F.2); if none do, to the series before it.
std::vector<DirectoryRecord> directoryRecords(const Dataset& directory) {
    constexpr std::uint16_t kNotInUse = 0;
    const std::vector<Dataset> all = directory.items(tag::kDirectoryRecords);
    const std::vector<std::string> series = seriesOf(all);
    std::vector<DirectoryRecord> records;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].word(kRecordInUse) == kNotInUse) continue;
        auto fileId = all[i].texts(kReferencedFile);
        if (fileId.empty()) continue;
        records.push_back({.fileId = std::move(fileId),
                           .sopInstanceUid = all[i].shortText(kReferencedInstance),
                           .seriesInstanceUid = series[i],
                           .instanceNumber = all[i].integer(tag::kInstanceNumber)});
    }
    return records;
}

constexpr Tag kMediaStorageSopClass{0x0002, 0x0002};

// A name without what discs change: in lower case, without a version number and the dot before it.
std::string comparable(std::string_view name) {
    const std::size_t version = name.rfind(';');
    if (version != std::string_view::npos &&
        name.find_first_not_of("0123456789", version + 1) == std::string_view::npos)
        name = name.substr(0, version);
    while (name.size() > 1 && name.ends_with('.')) name.remove_suffix(1);
    std::string result;
    for (const char c : name) result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return result;
}

// The same without an ending, which the standard forbids (PS3.10 8.2) and programs that copy media add.
std::string withoutEnding(const std::string& comparable) {
    const std::size_t dot = comparable.rfind('.');
    return dot == std::string::npos || dot == 0 ? comparable : comparable.substr(0, dot);
}

// The names along the path to the file; nothing when that would lead out of the folder.
std::optional<std::vector<std::string>> wayTo(const std::vector<std::string>& components) {
    std::vector<std::string> way;
    for (const std::string& component : components) {
        // Some writers use the separator of their own system.
        for (std::size_t begin = 0; begin <= component.size();) {
            const std::size_t end = std::min(component.find('/', begin), component.size());
            std::string name = component.substr(begin, end - begin);
            begin = end + 1;
            if (name.empty() && !way.empty()) continue;
            // An absolute path, a drive, or "..".
            if (name.empty() || name == ".." || (name.size() == 2 && name[1] == ':')) return {};
            if (name != ".") way.push_back(std::move(name));
        }
    }
    if (way.empty()) return {};
    return way;
}

class Resolver {
  public:
    explicit Resolver(const fs::path& folder) : folder_(folder) {
        std::error_code error;
        canonical_ = fs::canonical(folder_.empty() ? fs::path(".") : folder_, error);
    }

    void add(const DirectoryRecord& record) {
        const auto way = wayTo(record.fileId);
        if (!way) {
            ++outside_;
            return;
        }
        fs::path found;
        fs::path asNamed;
        for (const std::string& name : *way) asNamed /= name;
        for (const std::string& name : *way) {
            const auto real = nameOnDisk(found, name);
            if (!real) {
                std::error_code error;
                const fs::path folder = fs::canonical(folder_ / found, error);
                if (!error && !liesInside(folder, canonical_)) {
                    ++outside_;
                } else {
                    addMissing(folder_ / asNamed, record);
                }
                return;
            }
            found /= *real;
        }
        std::error_code error;
        const fs::path target = fs::canonical(folder_ / found, error);
        if (!error && !liesInside(target, canonical_)) {
            ++outside_;
        } else if (!error && fs::is_regular_file(target, error)) {
            files_.insert(folder_ / found);
        } else {
            addMissing(folder_ / asNamed, record);
        }
    }

    MediaDirectory take() const {
        MediaDirectory directory{{files_.begin(), files_.end()}, {}, outside_};
        for (const auto& [path, listed] : missing_) directory.missing.push_back(listed);
        return directory;
    }

  private:
    using Names = std::map<std::string, std::string>;  // on disk, by comparable name

    void addMissing(const fs::path& file, const DirectoryRecord& record) {
        missing_.try_emplace(file, ListedFile{.file = file,
                                              .sopInstanceUid = record.sopInstanceUid,
                                              .seriesInstanceUid = record.seriesInstanceUid,
                                              .instanceNumber = record.instanceNumber});
    }

    std::optional<std::string> nameOnDisk(const fs::path& folder, const std::string& name) {
        const auto [entry, isNew] = names_.try_emplace(folder);
        if (isNew) {
            std::error_code error;
            const fs::path real = fs::canonical(folder_ / folder, error);
            // A folder outside is not even listed.
            if (!error && liesInside(real, canonical_)) {
                std::vector<std::string> added;
                fs::directory_iterator at(real, error);
                for (; !error && at != fs::directory_iterator(); at.increment(error)) {
                    const std::string onDisk = at->path().filename().string();
                    entry->second.try_emplace(comparable(onDisk), onDisk);
                    entry->second.insert_or_assign(onDisk, onDisk);  // the exact name has precedence
                    added.push_back(onDisk);
                }
                // Of several names that differ only in their ending, prefers that with .dcm.
                std::stable_partition(added.begin(), added.end(), [](const std::string& onDisk) {
                    return comparable(onDisk).ends_with(".dcm");
                });
                for (const std::string& onDisk : added)
                    entry->second.try_emplace(withoutEnding(comparable(onDisk)), onDisk);
            }
        }
        const Names& names = entry->second;
        auto found = names.find(name);
        if (found == names.end()) found = names.find(comparable(name));
        // Perhaps only one of the two names has an ending.
        if (found == names.end()) found = names.find(withoutEnding(comparable(name)));
        if (found == names.end()) return {};
        return found->second;
    }

    fs::path folder_;
    fs::path canonical_;
    std::map<fs::path, Names> names_;
    std::set<fs::path> files_;
    std::map<fs::path, ListedFile> missing_;
    std::size_t outside_ = 0;
};

}  // namespace

Result<MediaDirectory> readMediaDirectory(const fs::path& path) try {
    const HeaderFile read = readHeader(path);
    const bool isDirectory =
        read.header && (read.header->text(kMediaStorageSopClass) == sop_class::kMediaDirectory ||
                        !read.header->items(tag::kDirectoryRecords).empty());
    if (!isDirectory) {
        return Error{ErrorCode::inputNotUsable, Text("The file is not the directory of a DICOM disc."),
                     path.string(), Text("Open the folder instead.")};
    }
    Resolver resolver(path.parent_path());
    for (const DirectoryRecord& record : directoryRecords(*read.header)) resolver.add(record);
    return resolver.take();
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("read the directory of this disc"), path.string());
}

}  // namespace macula::dicom
