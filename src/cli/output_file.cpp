#include "cli/output_file.h"

#include <unistd.h>

namespace macula::cli {

namespace fs = std::filesystem;

bool isExr(const fs::path& path) {
    return path.extension() == ".exr";
}

Result<void> checkPlaceOf(const fs::path& path) {
    std::error_code error;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error)) {
        return Error{ErrorCode::outputNotWritable, "The folder to write into does not exist.",
                     folder.string(), "Create it, or choose another place."};
    }
    if (fs::is_directory(path, error))
        return Error{ErrorCode::outputNotWritable, "There is a folder of that name.", path.string(),
                     "Choose another name."};
    if (access(folder.c_str(), W_OK) != 0)
        return Error{ErrorCode::outputNotWritable, "Nothing can be written there.", path.string(),
                     "Check the permissions, or choose another place."};
    return {};
}

Result<void> checkOutput(const fs::path& path) {
    if (path.extension() != ".png" && !isExr(path)) {
        return Error{ErrorCode::usage, "The picture must be a .png or .exr file.", path.string(),
                     "Give -o a name with one of these endings."};
    }
    return checkPlaceOf(path);
}

}  // namespace macula::cli
