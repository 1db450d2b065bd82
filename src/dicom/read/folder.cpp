#include "dicom/read/folder.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/log.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

bool isLeftByMacOs(const fs::path& name) {
    const std::string_view text = name.native();
    return text.starts_with("._") || text == ".DS_Store" || text == "__MACOSX";
}

// Walks by hand rather than by the recursive iterator, which ends for good at the first error. Files are
// named by their path from the folder, without any link in it, so that each has only one name.
class Listing {
  public:
    Listing(const fs::path& folder, const fs::path& canonical) : folder_(folder), canonical_(canonical) {}

    // Lists the folder. False when cancelled.
    bool run(Progress& progress) {
        enterOnce({});
        while (!waiting_.empty()) {
            const fs::path folder = std::move(waiting_.back());
            waiting_.pop_back();
            if (!list(folder, progress)) return false;
            // Follows links last: most of their targets have been found by then.
            if (waiting_.empty() && !followLinks(progress)) return false;
        }
        auto& files = result_.files;
        std::sort(files.begin(), files.end());
        // Removes files that were found both directly and by a link.
        files.erase(std::unique(files.begin(), files.end()), files.end());
        std::ranges::sort(result_.unreadable, {}, &UnreadableFolder::path);
        return true;
    }

    FolderListing take() { return std::move(result_); }

  private:
    bool list(const fs::path& folder, Progress& progress) {
        std::error_code error;
        fs::directory_iterator at(canonical_ / folder, error);
        while (!error && at != fs::directory_iterator()) {
            if (progress.cancelled()) return false;
            const fs::path name = at->path().filename();
            std::error_code ignored;  // a file that vanished meanwhile is not listed
            if (!isLeftByMacOs(name)) {
                if (at->is_symlink(ignored)) {
                    links_.push_back(at->path());
                } else if (at->is_regular_file(ignored)) {
                    result_.files.push_back(folder_ / folder / name);
                } else if (at->is_directory(ignored)) {
                    enterOnce(folder / name);
                }
            }
            at.increment(error);
        }
        if (error) {
            log::warning("a folder could not be listed to its end: {}", error.message());
            result_.unreadable.push_back({folder.empty() ? folder_ : folder_ / folder, error.value()});
        }
        return true;
    }

    bool followLinks(Progress& progress) {
        for (const fs::path& link : std::exchange(links_, {})) {
            if (progress.cancelled()) return false;
            std::error_code error;
            const fs::path target = fs::canonical(link, error);
            if (error) continue;  // leads nowhere, or round in circles
            if (!liesInside(target, canonical_)) {
                ++result_.linksOutside;
                continue;
            }
            const fs::path inside = target == canonical_ ? fs::path() : target.lexically_relative(canonical_);
            const bool isSkipped = std::any_of(inside.begin(), inside.end(), isLeftByMacOs);
            if (isSkipped) continue;
            if (fs::is_directory(target, error)) {
                enterOnce(inside);
            } else if (fs::is_regular_file(target, error)) {
                result_.files.push_back(folder_ / inside);
            }
        }
        return true;
    }

    void enterOnce(const fs::path& folder) {
        if (entered_.insert(folder.native()).second) waiting_.push_back(folder);
    }

    const fs::path& folder_;
    const fs::path& canonical_;
    FolderListing result_;
    std::vector<fs::path> waiting_;
    std::vector<fs::path> links_;
    std::set<std::string> entered_;
};

}  // namespace

bool liesInside(const fs::path& canonicalPath, const fs::path& canonicalFolder) {
    return std::mismatch(canonicalFolder.begin(), canonicalFolder.end(), canonicalPath.begin(),
                         canonicalPath.end())
               .first == canonicalFolder.end();
}

Result<FolderListing> listFiles(const fs::path& path, Progress& progress) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (error == std::errc::filename_too_long) {
        return Error{
            ErrorCode::inputNotUsable, Text("The path is longer than this system can open."), path.string(),
            Text("Move the folder nearer to the root of the disk, or give the folders shorter names.")};
    }
    // A path that may not be examined may exist.
    if (status.type() == fs::file_type::not_found) {
        return Error{ErrorCode::inputNotUsable, Text("The folder does not exist."), path.string(),
                     Text("Check the path.")};
    }
    if (fs::is_regular_file(status)) return FolderListing{{path}, {}};
    fs::path canonical;
    if (fs::is_directory(status)) {
        canonical = fs::canonical(path, error);
        if (!error) fs::directory_iterator(canonical, error);
    }
    if (!fs::is_directory(status) || error) {
        return Error{ErrorCode::inputNotUsable, Text("The folder cannot be read."), path.string(),
                     Text("Check that it is a folder, and its permissions.")};
    }
    Listing listing(path, canonical);
    if (!listing.run(progress)) return Error{ErrorCode::cancelled, Text("Reading was cancelled."), {}, {}};
    return listing.take();
}

}  // namespace macula::dicom
