#include "dicom/read/media_directory.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "dicom/read/dataset.h"
#include "dicom/read/folder.h"
#include "dicom/read/sop_class.h"
#include "dicom/read/tags.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

constexpr Tag kMediaStorageSopClass{0x0002, 0x0002};
constexpr Tag kRecordInUse{0x0004, 0x1410};
constexpr Tag kReferencedFile{0x0004, 0x1500};

// A name without what discs change in it: its capitals, a version number, and the dot in front of it.
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

// The names on the way to the file; nothing when it would lead out of the folder.
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

    void add(const std::vector<std::string>& components) {
        const auto way = wayTo(components);
        if (!way) {
            ++outside_;
            return;
        }
        fs::path found;
        fs::path asNamed;
        for (const std::string& name : *way) asNamed /= name;
        for (const std::string& name : *way) {
            const auto real = lookUp(found, name);
            if (!real) {
                std::error_code error;
                const fs::path folder = fs::canonical(folder_ / found, error);
                if (!error && !liesInside(folder, canonical_)) {
                    ++outside_;
                } else {
                    missing_.insert(folder_ / asNamed);
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
            missing_.insert(folder_ / asNamed);
        }
    }

    MediaDirectory take() const {
        return {{files_.begin(), files_.end()}, {missing_.begin(), missing_.end()}, outside_};
    }

  private:
    using Names = std::map<std::string, std::string>;  // on disk, by what is compared

    std::optional<std::string> lookUp(const fs::path& folder, const std::string& name) {
        const auto [entry, isNew] = names_.try_emplace(folder);
        if (isNew) {
            std::error_code error;
            const fs::path real = fs::canonical(folder_ / folder, error);
            // Nothing outside is listed either.
            if (!error && liesInside(real, canonical_)) {
                fs::directory_iterator at(real, error);
                for (; !error && at != fs::directory_iterator(); at.increment(error)) {
                    const std::string onDisk = at->path().filename().string();
                    entry->second.try_emplace(comparable(onDisk), onDisk);
                    entry->second.insert_or_assign(onDisk, onDisk);  // the very name goes first
                }
            }
        }
        const Names& names = entry->second;
        auto found = names.find(name);
        if (found == names.end()) found = names.find(comparable(name));
        if (found == names.end()) return {};
        return found->second;
    }

    fs::path folder_;
    fs::path canonical_;
    std::map<fs::path, Names> names_;
    std::set<fs::path> files_, missing_;
    std::size_t outside_ = 0;
};

}  // namespace

Result<MediaDirectory> readMediaDirectory(const fs::path& path) try {
    const HeaderFile read = readHeader(path);
    const bool isDirectory =
        read.header && (read.header->text(kMediaStorageSopClass) == sop_class::kMediaDirectory ||
                        !read.header->items(tag::kDirectoryRecords).empty());
    if (!isDirectory) {
        return Error{ErrorCode::inputNotUsable, "The file is not the directory of a DICOM disc.",
                     path.string(), "Open the folder instead."};
    }
    Resolver resolver(path.parent_path());
    for (const Dataset& record : read.header->items(tag::kDirectoryRecords)) {
        constexpr std::uint16_t kNotInUse = 0;
        if (record.word(kRecordInUse) == kNotInUse) continue;
        if (const auto components = record.texts(kReferencedFile); !components.empty())
            resolver.add(components);
    }
    return resolver.take();
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, "There is not enough memory to read this disc.", path.string(), {}};
} catch (const std::exception&) {
    return Error{ErrorCode::inputNotUsable, "The directory of this disc cannot be read.", path.string(),
                 "Open the folder instead."};
}

}  // namespace macula::dicom
