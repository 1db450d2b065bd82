#include "base/private_file.h"

#include <fstream>
#include <system_error>

#include "base/atomic_file.h"

namespace macula {

namespace fs = std::filesystem;

Result<void> makePrivateFolder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (!failure) fs::permissions(folder, fs::perms::owner_all, failure);
    if (failure)
        return Error{ErrorCode::outputNotWritable, Text("A private folder cannot be made."), folder.string(),
                     Text("Check free space, and the permissions of the folder above it.")};
    return {};
}

Result<void> writeTextPrivately(const fs::path& file, std::string_view text) {
    return writeAtomically(file, [&](const fs::path& written) -> Result<void> {
        std::error_code refused;
        fs::permissions(written, fs::perms::owner_read | fs::perms::owner_write, refused);
        if (refused)
            return Error{ErrorCode::outputNotWritable, Text("The file cannot be made private."),
                         file.string(),
                         Text("Choose a data folder on a disk with permissions: XDG_DATA_HOME names it.")};
        std::ofstream stream(written, std::ios::binary);
        stream.write(text.data(), static_cast<std::streamsize>(text.size()));
        stream.close();
        if (!stream)
            return Error{ErrorCode::outputNotWritable, Text("The file could not be written."), file.string(),
                         Text("Check free space and permissions.")};
        return {};
    });
}

}  // namespace macula
