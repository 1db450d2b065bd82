// What the DICOM tests share.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "base/volume.h"
#include "dicom/best_volume.h"
#include "dicom/loader.h"
#include "dicom/scan.h"
#include "dicom/write/series_writer.h"

namespace macula::dicom::test {

// A fresh folder that goes when the test ends.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

// Takes root's rights away while it lives, from a test that root runs: what nobody may read it may not read
// then either. Of others it changes nothing.
class WithoutRootsRights {
  public:
    WithoutRootsRights();
    ~WithoutRootsRights();
    WithoutRootsRights(const WithoutRootsRights&) = delete;
    WithoutRootsRights& operator=(const WithoutRootsRights&) = delete;

  private:
    bool wasRoot_;
};

// ../shared/data, which is not part of the repository.
std::filesystem::path sharedData();

// Oblique, anisotropic, 5 x 4 x 6 voxels, every voxel different, values from -1000 to about 2300 HU.
Volume smallVolume(std::optional<StoredRange> padding = {});
Volume smallVolume(const glm::dmat4& worldFromVoxel, UnitsFromStored map, std::string modality);
glm::dmat4 obliqueAffine();

// Fails the test and returns nothing on an error.
std::optional<Scan> scan(const std::filesystem::path& path);
std::vector<std::filesystem::path> write(const Volume& volume, const std::filesystem::path& folder,
                                         const SeriesWriterOptions& options = {});
std::shared_ptr<const Volume> load(const Series& series, const Stack& stack);
std::shared_ptr<const Volume> load(const Series& series);  // its only stack
// The only series of a folder, loaded.
std::shared_ptr<const Volume> loadFolder(const std::filesystem::path& folder);

// Of the series or any of its stacks.
bool hasMessage(const Series& series, std::string_view key);
std::string keysOf(const Series& series);  // to print

// Largest difference of any entry.
double affineError(const glm::dmat4& a, const glm::dmat4& b);
void expectSameValues(const Volume& actual, const Volume& expected, double tolerance = 0.0);

}  // namespace macula::dicom::test

#define SKIP_WITHOUT_SHARED_DATA()                                           \
    if (!std::filesystem::is_directory(::macula::dicom::test::sharedData())) \
    GTEST_SKIP() << "the real test data are not on this machine: " << ::macula::dicom::test::sharedData()
