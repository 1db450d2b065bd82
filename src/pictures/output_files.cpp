#include "pictures/output_files.h"

#include <unistd.h>

#include <algorithm>

#include "base/draft.h"
#include "dicom/read/folder.h"
#include "formats/volume_file.h"

namespace macula::pictures {

namespace fs = std::filesystem;

namespace {

fs::path wholePath(const fs::path& path) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(path, error);
    return error ? path.lexically_normal() : whole;
}

fs::path folderOf(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

bool isAmong(const fs::path& file, const std::vector<fs::path>& files) {
    return std::any_of(files.begin(), files.end(), [&](const fs::path& other) {
        std::error_code error;
        return file == other || fs::equivalent(file, other, error);
    });
}

// Whether the file lies in the folder or is a symbolic link to a file there.
bool isFileOf(const fs::path& file, const fs::path& folder) {
    return dicom::liesInside(wholePath(file), folder) ||
           dicom::liesInside(wholePath(folderOf(file)) / file.filename(), folder);
}

Result<void> checkPlace(const fs::path& path) {
    std::error_code error;
    const fs::path folder = folderOf(path);
    if (!fs::is_directory(folder, error)) {
        return Error{ErrorCode::outputNotWritable, Text("The folder to write into does not exist."),
                     folder.string(), Text("Create it, or choose another place.")};
    }
    if (fs::is_directory(path, error))
        return Error{ErrorCode::outputNotWritable, Text("There is a folder of that name."), path.string(),
                     Text("Choose another name.")};
    if (fs::exists(path, error) && !fs::is_regular_file(path, error))
        return Error{ErrorCode::outputNotWritable, Text("What stands there is no file."), path.string(),
                     Text("Choose another name.")};
    if (access(folder.c_str(), W_OK) != 0)
        return Error{ErrorCode::outputNotWritable, Text("Nothing can be written there."), path.string(),
                     Text("Check the permissions, or choose another place.")};
    return {};
}

}  // namespace

void OutputFiles::read(const fs::path& path) {
    std::error_code error;
    fs::path found = path;
    if (!fs::exists(found, error)) found = path.string().substr(0, path.string().find('#'));
    if (found.empty() || !fs::exists(found, error)) return;
    if (fs::is_directory(found, error)) {
        folders_.push_back(wholePath(found));
        return;
    }
    files_.push_back(wholePath(found));
    // A DICOMDIR names files of its folder, which are read too.
    if (found.filename().string().starts_with("DICOMDIR")) folders_.push_back(wholePath(folderOf(found)));
    if (const auto values = formats::valuesFileOf(found)) files_.push_back(wholePath(*values));
}

Result<void> OutputFiles::checkExisting(const fs::path& path) const {
    if (isAmong(wholePath(path), files_))
        return Error{ErrorCode::outputNotWritable, Text("The file is one of those that are read."),
                     path.string(), Text("Choose another name: what is read is never replaced.")};
    if (std::any_of(folders_.begin(), folders_.end(),
                    [&](const auto& folder) { return isFileOf(path, folder); }))
        return Error{ErrorCode::outputNotWritable, Text("The file belongs to the folder that is read."),
                     path.string(), Text("Choose another name: what is read is never replaced.")};
    if (!overwrite_)
        return Error{ErrorCode::outputNotWritable, Text("The file exists already."), path.string(),
                     Text("Give --overwrite to replace it, or choose another name.")};
    return {};
}

Result<void> OutputFiles::take(const fs::path& path) {
    if (!written_.insert(wholePath(path)).second)
        return Error{ErrorCode::usage, Text("Two outputs have the same name."), path.string(),
                     Text("Give each a name of its own.")};
    if (tidied_.insert(folderOf(path)).second) removeAbandonedDrafts(folderOf(path));
    return {};
}

Result<void> OutputFiles::write(const fs::path& path) {
    if (path.empty() || path == "-") return {};
    MACULA_TRY_VOID(checkPlace(path));
    std::error_code error;
    if (!written_.contains(wholePath(path)) && fs::exists(fs::symlink_status(path, error)))
        MACULA_TRY_VOID(checkExisting(path));
    return take(path);
}

Result<void> OutputFiles::writeOn(const fs::path& path) {
    MACULA_TRY_VOID(checkPlace(path));
    return take(path);
}

Result<void> makePictureFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error || !fs::is_directory(folder, error))
        return Error{ErrorCode::outputNotWritable, Text("The folder for the pictures cannot be made."),
                     folder.string(), Text("Check the permissions, or choose another place.")};
    return {};
}

fs::path placeOfUnfinished(const fs::path& wanted) {
    std::error_code error;
    if (!fs::exists(wanted, error)) return wanted;
    fs::path beside = wanted;
    return beside.replace_filename(wanted.stem().string() + "-unfinished" + wanted.extension().string());
}

bool isSameFile(const fs::path& a, const fs::path& b) {
    std::error_code error;
    return !a.empty() && !b.empty() && (wholePath(a) == wholePath(b) || fs::equivalent(a, b, error));
}

}  // namespace macula::pictures
