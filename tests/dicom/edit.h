// Changes one element of a DICOM file in place, to make the odd files that the writer never makes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "dicom/read/dataset.h"
#include "dicom/write/series_writer.h"

namespace macula::dicom::test {

void setText(const std::filesystem::path& file, Tag tag, const std::string& value);
void setWord(const std::filesystem::path& file, Tag tag, std::uint16_t value);
void remove(const std::filesystem::path& file, Tag tag);
void setPixels(const std::filesystem::path& file, const std::vector<std::uint16_t>& cells);
// As cells of 16 bits with 8 stored, or of 8 bits, in this syntax. The encoders are there once writeSeries
// was called.
void saveWithEightBits(const std::filesystem::path& file, int bitsAllocated,
                       const std::vector<std::uint8_t>& values, WriteSyntax syntax);
// Without preamble, file meta information and DICM, in Implicit VR Little Endian.
void saveBare(const std::filesystem::path& file);
void truncate(const std::filesystem::path& file, std::size_t bytesLess);

}  // namespace macula::dicom::test
