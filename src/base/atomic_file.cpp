#include "base/atomic_file.h"

#include <fstream>

#include "base/draft.h"

namespace macula {

namespace fs = std::filesystem;

Result<void> writeAtomically(const fs::path& path,
                             const std::function<Result<void>(const fs::path&)>& write) {
    MACULA_TRY(const Draft draft, Draft::beside(path, Draft::Kind::file));
    if (auto written = write(draft.path()); !written) {
        Error error = written.error();
        if (error.where.empty()) error.where = path.string();
        return error;
    }
    return putInPlace(draft.path(), path);
}

Result<void> writeTextAtomically(const fs::path& path, std::string_view text) {
    return writeAtomically(path, [&](const fs::path& temporary) -> Result<void> {
        std::ofstream stream(temporary, std::ios::binary);
        stream.write(text.data(), static_cast<std::streamsize>(text.size()));
        stream.close();
        if (!stream) {
            return Error{ErrorCode::outputNotWritable, Text("The file could not be written."), path.string(),
                         Text("Check free space and permissions.")};
        }
        return {};
    });
}

Result<std::string> readText(const fs::path& path, std::size_t maxBytes) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        return Error{ErrorCode::inputNotUsable, Text("The file does not exist."), path.string(),
                     Text("Check the path.")};
    }
    const auto bytes = fs::file_size(path, error);
    if (error || bytes > maxBytes) {
        return Error{ErrorCode::inputNotUsable, Text("The file is larger than {} bytes.", maxBytes),
                     path.string(), Text("Check that it is the file you meant.")};
    }
    std::ifstream stream(path, std::ios::binary);
    std::string text(bytes, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(bytes));
    if (!stream) {
        return Error{ErrorCode::inputNotUsable, Text("The file could not be read."), path.string(),
                     Text("Check its permissions.")};
    }
    return text;
}

}  // namespace macula
