// Random access to a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace macula::dicom {

// Safe to read from several threads.
class RandomFile {
  public:
    explicit RandomFile(const std::filesystem::path& file);
    ~RandomFile();
    RandomFile(RandomFile&& other) noexcept;
    RandomFile& operator=(RandomFile&&) = delete;

    bool isOpen() const { return descriptor_ >= 0; }
    std::uint64_t size() const { return size_; }  // when it was opened
    // Fills all of `bytes`, or returns false.
    bool read(std::uint64_t offset, std::span<std::byte> bytes) const;

  private:
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

}  // namespace macula::dicom
