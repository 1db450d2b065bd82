#include "support.h"

#include <unistd.h>

#include <atomic>
#include <cmath>

#include "base/paths.h"
#include "base/worst.h"

namespace macula::dicom::test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    static std::atomic<int> counter{0};
    path_ = fs::temp_directory_path() / fmt::format("macula_dicom_{}_{}", getpid(), counter++);
    fs::remove_all(path_);
    fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

WithoutRootsRights::WithoutRootsRights() : wasRoot_(geteuid() == 0) {
    constexpr uid_t kNobody = 65534;
    if (wasRoot_) {
        EXPECT_EQ(seteuid(kNobody), 0);
    }
}

WithoutRootsRights::~WithoutRootsRights() {
    if (wasRoot_) {
        EXPECT_EQ(seteuid(0), 0);
    }
}

fs::path sharedData() {
    return macula::test::sharedFolder() / "data";
}

glm::dmat4 obliqueAffine() {
    // Three rotations, so that no entry is 0 and no two are equal.
    const double a = 0.3, b = -0.2, c = 0.7;
    const glm::dmat3 x{1, 0, 0, 0, std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a)};
    const glm::dmat3 y{std::cos(b), 0, -std::sin(b), 0, 1, 0, std::sin(b), 0, std::cos(b)};
    const glm::dmat3 z{std::cos(c), std::sin(c), 0, -std::sin(c), std::cos(c), 0, 0, 0, 1};
    const glm::dmat3 r = x * y * z;
    return affine(r[0] * 0.7, r[1] * 1.1, r[2] * 2.3, {-123.4567891, 87.654321, -1022.25});
}

Volume smallVolume(const glm::dmat4& worldFromVoxel, UnitsFromStored map, std::string modality) {
    const glm::ivec3 size{5, 4, 6};
    std::vector<std::uint16_t> voxels;
    for (int n = 0; n < size.x * size.y * size.z; ++n)
        voxels.push_back(static_cast<std::uint16_t>(24 + 27 * n));
    auto volume = Volume::create({.size = size,
                                  .worldFromVoxel = worldFromVoxel,
                                  .unitsFromStored = map,
                                  .unit = modality == "CT" ? Unit::hounsfield : Unit::raw,
                                  .modality = modality,
                                  .padding = {},
                                  .provenance = {}},
                                 std::move(voxels));
    return std::move(*volume);
}

Volume smallVolume(std::optional<StoredRange> padding) {
    const Volume base = smallVolume(obliqueAffine(), {1.0, -1024.0}, "CT");
    auto volume = Volume::create({.size = base.size(),
                                  .worldFromVoxel = base.worldFromVoxel(),
                                  .unitsFromStored = base.unitsFromStored(),
                                  .unit = base.unit(),
                                  .modality = base.modality(),
                                  .padding = padding,
                                  .provenance = {}},
                                 {base.voxels().begin(), base.voxels().end()});
    return std::move(*volume);
}

std::optional<Scan> scan(const fs::path& path) {
    Progress progress;
    auto result = scanFolder(path, progress);
    if (!result) {
        ADD_FAILURE() << "scan of " << path << ": " << result.error().message;
        return {};
    }
    return std::move(*result);
}

std::vector<fs::path> write(const Volume& volume, const fs::path& folder,
                            const SeriesWriterOptions& options) {
    Progress progress;
    auto files = writeSeries(volume, folder, options, progress);
    if (!files) {
        ADD_FAILURE() << "writing: " << files.error().message;
        return {};
    }
    return *files;
}

std::shared_ptr<const Volume> load(const Series& series, const Stack& stack) {
    Progress progress;
    auto volume = loadVolume(series, stack, progress);
    if (!volume) {
        ADD_FAILURE() << "loading: " << volume.error().message << " [" << keysOf(series) << "]";
        return nullptr;
    }
    return *volume;
}

std::shared_ptr<const Volume> load(const Series& series) {
    if (series.stacks.size() != 1) {
        ADD_FAILURE() << series.stacks.size() << " stacks, not one [" << keysOf(series) << "]";
        return nullptr;
    }
    return load(series, series.stacks.front());
}

std::shared_ptr<const Volume> loadFolder(const fs::path& folder) {
    const auto found = scan(folder);
    if (!found) return nullptr;
    if (found->studies.size() != 1 || found->studies[0].series.size() != 1) {
        ADD_FAILURE() << "not one series in " << folder;
        return nullptr;
    }
    return load(found->studies[0].series[0]);
}

namespace {

std::vector<Message> allMessages(const Series& series) {
    std::vector<Message> all = series.messages;
    for (const Stack& stack : series.stacks) {
        all.insert(all.end(), stack.messages.begin(), stack.messages.end());
    }
    return all;
}

}  // namespace

bool hasMessage(const Series& series, std::string_view key) {
    for (const Message& message : allMessages(series)) {
        if (message.key == key) return !message.sentence.empty();
    }
    return false;
}

std::string keysOf(const Series& series) {
    std::string keys;
    for (const Message& message : allMessages(series)) keys += message.key + " ";
    return keys;
}

double affineError(const glm::dmat4& a, const glm::dmat4& b) {
    double error = 0.0;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            error = macula::test::worse(error, std::abs(a[column][row] - b[column][row]));
        }
    }
    return error;
}

void expectSameValues(const Volume& actual, const Volume& expected, double tolerance) {
    ASSERT_EQ(actual.size(), expected.size());
    for (int k = 0; k < expected.size().z; ++k) {
        for (int j = 0; j < expected.size().y; ++j) {
            for (int i = 0; i < expected.size().x; ++i) {
                ASSERT_NEAR(actual.value(i, j, k), expected.value(i, j, k), tolerance)
                    << "voxel " << i << " " << j << " " << k;
            }
        }
    }
}

}  // namespace macula::dicom::test
