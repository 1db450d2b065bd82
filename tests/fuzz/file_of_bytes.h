// What a fuzz target that reads files works with: its bytes as a file in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/check.h"
#include "base/log.h"

namespace macula::fuzz {

// A folder of this process, on a file system in memory where there is one.
inline const std::filesystem::path& folder() {
    static const std::filesystem::path made = [] {
        log::setLevel(log::Level::off);
        std::error_code error;
        const std::filesystem::path memory = "/dev/shm";
        const bool inMemory = std::filesystem::is_directory(memory, error);
        std::string name =
            ((inMemory ? memory : std::filesystem::temp_directory_path()) / "macula-fuzz-XXXXXX").string();
        MACULA_CHECK(mkdtemp(name.data()) != nullptr);
        std::atexit([] {
            std::error_code ignored;
            std::filesystem::remove_all(folder(), ignored);
        });
        return std::filesystem::path(name);
    }();
    return made;
}

inline std::filesystem::path fileOf(const std::uint8_t* data, std::size_t size, const std::string& name) {
    const std::filesystem::path path = folder() / name;
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    file.close();
    MACULA_CHECK(file.good());
    return path;
}

}  // namespace macula::fuzz
