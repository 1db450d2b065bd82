#include "base/atomic_file.h"

#include <unistd.h>

#include <fstream>

namespace macula {

namespace fs = std::filesystem;

Result<void> writeAtomically(const fs::path& path,
                             const std::function<Result<void>(const fs::path&)>& write) {
    fs::path temporary = path;
    temporary.replace_filename(
        fmt::format(".{}.{}.part{}", path.stem().string(), getpid(), path.extension().string()));
    std::error_code error;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error)) {
        return Error{ErrorCode::outputNotWritable, "The folder to write into does not exist.",
                     folder.string(), "Create it, or choose another place."};
    }
    if (auto written = write(temporary); !written) {
        fs::remove(temporary, error);
        return written.error();
    }
    fs::rename(temporary, path, error);
    if (error) {
        const std::string reason = error.message();
        fs::remove(temporary, error);
        return Error{ErrorCode::outputNotWritable,
                     fmt::format("The file could not be put in place: {}.", reason), path.string(),
                     "Check the permissions of the folder."};
    }
    return {};
}

Result<void> writeTextAtomically(const fs::path& path, std::string_view text) {
    return writeAtomically(path, [&](const fs::path& temporary) -> Result<void> {
        std::ofstream stream(temporary, std::ios::binary);
        stream.write(text.data(), static_cast<std::streamsize>(text.size()));
        stream.close();
        if (!stream) {
            return Error{ErrorCode::outputNotWritable, "The file could not be written.", path.string(),
                         "Check free space and permissions."};
        }
        return {};
    });
}

Result<std::string> readText(const fs::path& path, std::size_t maxBytes) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        return Error{ErrorCode::inputNotUsable, "The file does not exist.", path.string(), "Check the path."};
    }
    const auto bytes = fs::file_size(path, error);
    if (error || bytes > maxBytes) {
        return Error{ErrorCode::inputNotUsable, fmt::format("The file is larger than {} bytes.", maxBytes),
                     path.string(), "Check that it is the file you meant."};
    }
    std::ifstream stream(path, std::ios::binary);
    std::string text(bytes, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(bytes));
    if (!stream) {
        return Error{ErrorCode::inputNotUsable, "The file could not be read.", path.string(),
                     "Check its permissions."};
    }
    return text;
}

}  // namespace macula
