// The parts of make_seeds that need nothing of DICOM.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace macula::fuzz {

inline void save(const std::filesystem::path& file, const std::string& bytes) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << bytes;
}

void writeArchiveSeeds(const std::filesystem::path& corpus);
void writeDatabaseSeeds(const std::filesystem::path& corpus);
void writePresetSeeds(const std::filesystem::path& corpus);
void writeStateSeeds(const std::filesystem::path& corpus);
void writeModelSeeds(const std::filesystem::path& corpus);

}  // namespace macula::fuzz
