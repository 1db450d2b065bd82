#include "dicom/read/media_directory.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "base/exceptions.h"
#include "dicom/read/dataset.h"
#include "dicom/read/directory_records.h"
#include "dicom/read/folder.h"
#include "dicom/read/sop_class.h"
#include "dicom/read/tags.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

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
