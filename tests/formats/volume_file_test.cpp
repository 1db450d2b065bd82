// Volumes to and from NIfTI, NRRD and MetaImage files.
#include "formats/volume_file.h"

#include <unistd.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "base/phantom.h"
#include "nifti_bytes.h"
#include "support.h"

namespace macula::formats::test {

using namespace dicom;  // what the tests of readers share
using namespace dicom::test;
namespace {

namespace fs = std::filesystem;
using namespace dicom;
using namespace dicom::test;

const char* const kEndings[] = {".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd"};

Volume floatVolume(const glm::dmat4& worldFromVoxel, std::vector<float> voxels, const glm::ivec3& size) {
    auto volume = Volume::createFloat({.size = size, .worldFromVoxel = worldFromVoxel}, std::move(voxels));
    return std::move(*volume);
}

// 2 x 2 x n voxels with these values.
Volume floats(std::vector<float> voxels) {
    const int slices = static_cast<int>(voxels.size() / 4);
    return floatVolume(obliqueAffine(), std::move(voxels), {2, 2, slices});
}

// A tilted gantry: the slices step sideways.
glm::dmat4 shearedAffine() {
    return affine({0.5, 0, 0}, {0, 0.5, 0}, {0, 0.6234, 2.5}, {-120.25, -130.5, 40.75});
}

void expectWritten(const Volume& volume, const fs::path& path) {
    Progress progress;
    const auto written = writeVolumeFile(volume, path, progress);
    ASSERT_TRUE(written.ok()) << path << ": " << written.error().message;
}

std::shared_ptr<const Volume> readBack(const fs::path& path) {
    Progress progress;
    auto volume = readVolumeFile(path, progress);
    if (!volume) {
        ADD_FAILURE() << path << ": " << volume.error().message;
        return nullptr;
    }
    return *volume;
}

void expectSame(const Volume& actual, const Volume& expected, double affineTolerance) {
    ASSERT_EQ(actual.size(), expected.size());
    EXPECT_LT(affineError(actual.worldFromVoxel(), expected.worldFromVoxel()), affineTolerance);
    const glm::ivec3 size = expected.size();
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                const auto wanted = static_cast<float>(expected.value(i, j, k));
                const double got = actual.value(i, j, k);
                ASSERT_TRUE(got == double(wanted) || (std::isnan(got) && std::isnan(wanted)))
                    << i << " " << j << " " << k << ": " << got << " is not " << wanted;
            }
        }
    }
}

double toleranceOf(const std::string& ending) {
    return ending.starts_with(".nii") ? 1e-4 : 1e-9;  // NIfTI keeps its affine as float32
}

std::string textOf(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t filesIn(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(VolumeFile, RoundTripsAreExact) {
    const TemporaryFolder folder;
    const glm::dmat4 mirrored = affine({0.7, 0.1, 0}, {-0.2, 1.4, 0}, {0, 0, -2.5}, {10, -20, 30});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<Volume> volumes = [&] {
        std::vector<Volume> all;
        all.push_back(smallVolume());
        all.push_back(smallVolume(shearedAffine(), {1.0, -1024.0}, "CT"));
        all.push_back(smallVolume(mirrored, {0.25, -3.0}, "MR"));
        all.push_back(smallVolume(StoredRange{24, 100}));
        all.push_back(floats({0.5f, 1e-30f, -3e30f, nan, 1.0f, 2.0f, 3.0f, 4.0f}));
        all.push_back(floats({0.0f, 65535.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f}));
        all.push_back(floats({-32768.0f, 32767.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f}));
        all.push_back(floats({-1.0f, 32768.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f}));
        return all;
    }();
    for (const std::string ending : kEndings) {
        int serial = 0;
        for (const Volume& volume : volumes) {
            SCOPED_TRACE(ending + " " + std::to_string(serial));
            const fs::path path = folder / ("v." + std::to_string(serial++) + ending);
            expectWritten(volume, path);
            const auto back = readBack(path);
            ASSERT_NE(back, nullptr);
            expectSame(*back, volume, toleranceOf(ending));
            const auto info = readVolumeFileInfo(path);
            ASSERT_TRUE(info.ok());
            EXPECT_EQ(info->size, volume.size());
            EXPECT_EQ(info->worldFromVoxel, back->worldFromVoxel());
            EXPECT_EQ(info->assumptions, std::vector<Text>{});
        }
    }
}

// Of what has a unit, and of what has none.
TEST(VolumeFile, ThatPixelsAreNotCalibratedIsKept) {
    const TemporaryFolder folder;
    for (const Unit unit : {Unit::hounsfield, Unit::raw}) {
        for (const bool isCalibrated : {true, false}) {
            const Volume small = smallVolume();
            VolumeOptions options{.size = small.size(), .worldFromVoxel = small.worldFromVoxel()};
            options.unit = unit;
            options.modality = "CT";
            options.provenance.isCalibrated = isCalibrated;
            const auto volume = Volume::create(options, {small.voxels().begin(), small.voxels().end()});
            ASSERT_TRUE(volume.ok());
            for (const std::string ending : kEndings) {
                SCOPED_TRACE(ending);
                const fs::path path = folder / ("c" + ending);
                expectWritten(*volume, path);
                const auto back = readBack(path);
                ASSERT_NE(back, nullptr);
                EXPECT_EQ(back->provenance().isCalibrated, isCalibrated);
                EXPECT_EQ(back->unit(), unit);
                EXPECT_EQ(back->modality(), unit == Unit::raw ? "" : "CT");
                const auto info = readVolumeFileInfo(path);
                ASSERT_TRUE(info.ok());
                EXPECT_EQ(info->isCalibrated, isCalibrated);
                EXPECT_EQ(info->assumptions.empty(), isCalibrated) << "it is told";
            }
        }
    }
}

TEST(VolumeFile, PhantomKeepsItsUnitAndStorage) {
    const TemporaryFolder folder;
    const Volume phantom = phantom::make();
    for (const std::string ending : {".nii.gz", ".nrrd", ".mha"}) {
        expectWritten(phantom, folder / ("phantom" + ending));
        const auto back = readBack(folder / ("phantom" + ending));
        ASSERT_NE(back, nullptr);
        EXPECT_EQ(back->format(), VoxelFormat::stored16);
        EXPECT_EQ(back->unit(), Unit::hounsfield);
        ASSERT_EQ(back->provenance().assumptions.size(), 1u);  // that of the unit
        expectSame(*back, phantom, toleranceOf(ending));
    }
}

// What a killed program has left is in nobody's way, under whatever number it ran.
TEST(VolumeFile, StaleWorkFoldersDoNotBlock) {
    const TemporaryFolder folder;
    const fs::path stale = folder / (".v." + std::to_string(getpid()) + ".part");
    fs::create_directory(stale);
    std::ofstream(stale / "v.nii") << "half";
    expectWritten(smallVolume(), folder / "v.nii");
    EXPECT_NE(readBack(folder / "v.nii"), nullptr);
}

TEST(VolumeFile, SmallestTypeThatIsExact) {
    const TemporaryFolder folder;
    const auto typeOf = [&](const Volume& volume) {
        expectWritten(volume, folder / "t.nii");
        return readNiftiBytes(folder / "t.nii").datatype();
    };
    EXPECT_EQ(typeOf(smallVolume()), 4);
    EXPECT_EQ(typeOf(smallVolume(obliqueAffine(), {1.0, 40000.0}, "MR")), 512);
    EXPECT_EQ(typeOf(smallVolume(obliqueAffine(), {1.0, -33000.0}, "CT")), 16);
    EXPECT_EQ(typeOf(smallVolume(obliqueAffine(), {0.5, 0.0}, "MR")), 16);
    EXPECT_EQ(typeOf(floats({1, 2, 3, 4, 5, 6, 7, 40000})), 512);
    EXPECT_EQ(typeOf(floats({1, 2, 3, 4, 5, 6, 7, -4})), 4);
}

TEST(VolumeFile, NiftiHeaderByItsBytes) {
    const TemporaryFolder folder;
    const Volume volume = smallVolume();
    expectWritten(volume, folder / "a.nii");
    const NiftiBytes file = readNiftiBytes(folder / "a.nii");
    EXPECT_EQ(file.bytes.size(), 352u + 2 * 5 * 4 * 6);
    EXPECT_EQ(file.get<std::int32_t>(0), 348);
    EXPECT_EQ(file.get<std::int16_t>(40), 3);
    EXPECT_EQ(file.size(), volume.size());
    EXPECT_EQ(file.get<char>(123), 2);  // mm
    EXPECT_EQ(file.bytes.substr(344, 8), std::string("n+1\0\0\0\0\0", 8));
    EXPECT_EQ(file.sformCode(), 1);
    EXPECT_EQ(file.qformCode(), 1);
    EXPECT_LT(affineError(file.sform(), volume.worldFromVoxel()), 1e-4);
    EXPECT_LT(affineError(file.qform(), volume.worldFromVoxel()), 1e-4);
    for (int k = 0; k < 6; ++k) {
        for (int j = 0; j < 4; ++j) {
            for (int i = 0; i < 5; ++i) ASSERT_EQ(file.value(i, j, k), volume.value(i, j, k));
        }
    }
    EXPECT_STREQ(file.bytes.substr(148, 80).c_str(), "Macula|int16|HU|CT");  // descrip: what the values are
    // Nowhere else a text: db_name, aux_file, intent_name.
    for (const auto& [first, length] : {std::pair{14, 18}, {228, 24}, {328, 16}})
        EXPECT_EQ(file.bytes.substr(std::size_t(first), std::size_t(length)),
                  std::string(std::size_t(length), '\0'));
}

TEST(VolumeFile, NiftiQformOfEveryHandednessAndTurn) {
    const TemporaryFolder folder;
    const glm::dmat3 turned(obliqueAffine());
    for (int variant = 0; variant < 16; ++variant) {
        // Axes turned around in every combination, and exchanged: each branch of the quaternion.
        glm::dmat3 axes = turned;
        for (int axis = 0; axis < 3; ++axis) axes[axis] *= (variant >> axis & 1) ? -1.0 : 1.0;
        if (variant & 8) std::swap(axes[0], axes[2]);
        const glm::dmat4 wanted = affine(axes[0], axes[1], axes[2], {12.5, -7.25, 300.0});
        expectWritten(smallVolume(wanted, {1.0, 0.0}, "MR"), folder / "q.nii");
        const NiftiBytes file = readNiftiBytes(folder / "q.nii");
        EXPECT_EQ(file.qformCode(), 1) << variant;
        EXPECT_LT(affineError(file.qform(), wanted), 1e-4) << variant;
        EXPECT_EQ(file.get<float>(76) < 0, glm::determinant(axes) < 0) << variant;
    }
}

// ITK would straighten this in silence; see nifti.h.
TEST(VolumeFile, ShearIsKeptInEveryFormat) {
    const TemporaryFolder folder;
    const Volume volume = smallVolume(shearedAffine(), {1.0, -1024.0}, "CT");
    expectWritten(volume, folder / "s.nii");
    const NiftiBytes file = readNiftiBytes(folder / "s.nii");
    EXPECT_LT(affineError(file.sform(), shearedAffine()), 1e-5);
    EXPECT_EQ(file.qformCode(), 0) << "a qform cannot hold a shear";

    expectWritten(volume, folder / "s.nrrd");
    const std::string nrrd = textOf(folder / "s.nrrd");
    EXPECT_NE(nrrd.find("\nspace: left-posterior-superior\n"), std::string::npos);
    double k[3] = {};
    const std::size_t directions = nrrd.find("\nspace directions:");
    ASSERT_NE(directions, std::string::npos);
    ASSERT_EQ(std::sscanf(nrrd.c_str() + directions, "\nspace directions: (%*[^)]) (%*[^)]) (%lf,%lf,%lf)", k,
                          k + 1, k + 2),
              3);
    EXPECT_NEAR(k[1], 0.6234, 1e-12);
    EXPECT_NEAR(k[2], 2.5, 1e-12);

    expectWritten(volume, folder / "s.mha");
    const std::string meta = textOf(folder / "s.mha");
    double m[9] = {};
    double spacing[3] = {};
    const std::size_t matrix = meta.find("TransformMatrix =");
    const std::size_t spacings = meta.find("ElementSpacing =");
    ASSERT_TRUE(matrix != std::string::npos && spacings != std::string::npos);
    std::istringstream(meta.substr(matrix + 17)) >> m[0] >> m[1] >> m[2] >> m[3] >> m[4] >> m[5] >> m[6] >>
        m[7] >> m[8];
    std::istringstream(meta.substr(spacings + 16)) >> spacing[0] >> spacing[1] >> spacing[2];
    EXPECT_NEAR(m[7] * spacing[2], 0.6234, 1e-12);
    EXPECT_NEAR(m[8] * spacing[2], 2.5, 1e-12);
}

// Nor a little of it, once it moves a corner by more than a hundredth of a millimetre: readers that prefer
// the qform would place the volume elsewhere.
TEST(VolumeFile, NiftiSaysNoQformThatMovesACorner) {
    const TemporaryFolder folder;
    for (const auto& [mmPerSlice, code] : {std::pair(0.0005, 1), std::pair(0.02, 0)}) {  // of six slices
        const glm::dmat4 sheared = affine({0.5, 0, 0}, {0, 0.5, 0}, {0, mmPerSlice, 2.5}, {-20, -30, 40});
        expectWritten(smallVolume(sheared, {1.0, 0.0}, "MR"), folder / "s.nii");
        EXPECT_EQ(readNiftiBytes(folder / "s.nii").qformCode(), code) << mmPerSlice;
    }
}

TEST(VolumeFile, DetachedValuesKeepTheirName) {
    const TemporaryFolder folder;
    for (const std::string name : {"a.b.nhdr", "c.MHD", "d.mhd"}) {
        const auto files = filesOfVolumeFile(folder / name);
        ASSERT_TRUE(files.ok());
        ASSERT_EQ(files->size(), 2u);
        expectWritten(smallVolume(), folder / name);
        for (const fs::path& file : *files) EXPECT_TRUE(fs::is_regular_file(file)) << file;
        EXPECT_NE(textOf(files->front()).find((*files)[1].filename().string()), std::string::npos);
        ASSERT_NE(readBack(folder / name), nullptr);
        fs::remove((*files)[1]);
        Progress progress;
        const auto alone = readVolumeFile(folder / name, progress);
        ASSERT_FALSE(alone.ok());
        EXPECT_NE(alone.error().message.english().find("missing"), std::string::npos);
    }
}

// A percent sign in the name of the values is a pattern of many files to NRRD and MetaImage.
TEST(VolumeFile, NamesMayHaveAPercentSignAndBlanks) {
    for (const std::string ending : kEndings) {
        const TemporaryFolder folder;
        const fs::path file = folder / "20% %s" / ("50% dose %d" + ending);
        fs::create_directory(file.parent_path());
        expectWritten(smallVolume(), file);
        const auto files = filesOfVolumeFile(file);
        ASSERT_TRUE(files.ok());
        EXPECT_EQ(files->front(), file);
        EXPECT_EQ(files->back().stem().string().find('%') == std::string::npos, files->size() == 2) << ending;
        for (const fs::path& each : *files) EXPECT_TRUE(fs::is_regular_file(each)) << each;
        EXPECT_EQ(filesIn(file.parent_path()), files->size());
        ASSERT_NE(readBack(file), nullptr) << ending;
    }
}

// Others wrote the name as it is.
TEST(VolumeFile, ValuesMayHaveTheVeryNameOfAPattern) {
    const TemporaryFolder folder;
    expectWritten(smallVolume(), folder / "a.mhd");
    std::string header = textOf(folder / "a.mhd");
    header.replace(header.find("a.raw"), 5, "50% a.raw");
    std::ofstream(folder / "b.mhd", std::ios::binary) << header;
    Progress progress;
    EXPECT_FALSE(readVolumeFile(folder / "b.mhd", progress).ok());
    fs::rename(folder / "a.raw", folder / "50% a.raw");
    EXPECT_NE(readBack(folder / "b.mhd"), nullptr);
}

TEST(VolumeFile, WrittenWholeOrNotAtAll) {
    const TemporaryFolder folder;
    Progress progress;
    const auto unknown = writeVolumeFile(smallVolume(), folder / "a.png", progress);
    ASSERT_FALSE(unknown.ok());
    EXPECT_EQ(unknown.error().code, ErrorCode::usage);
    for (const std::string ending : kEndings)
        EXPECT_NE(unknown.error().hint.english().find(ending), std::string::npos);
    EXPECT_EQ(filesIn(folder.path()), 0u);

    const auto nowhere = writeVolumeFile(smallVolume(), folder / "no/such/a.nii", progress);
    ASSERT_FALSE(nowhere.ok());
    EXPECT_EQ(nowhere.error().code, ErrorCode::outputNotWritable);

    fs::create_directories(folder / "taken.nii" / "x");
    const auto taken = writeVolumeFile(smallVolume(), folder / "taken.nii", progress);
    ASSERT_FALSE(taken.ok());
    EXPECT_EQ(taken.error().code, ErrorCode::outputNotWritable);
    EXPECT_EQ(filesIn(folder.path()), 1u);
    fs::remove_all(folder / "taken.nii");

    for (const std::string ending : kEndings) {
        const CancelToken token;
        token.cancel();
        Progress stopped({}, token);
        const auto written = writeVolumeFile(smallVolume(), folder / ("a" + ending), stopped);
        ASSERT_FALSE(written.ok());
        EXPECT_EQ(written.error().code, ErrorCode::cancelled);
        EXPECT_EQ(filesIn(folder.path()), 0u) << ending;
    }
}

TEST(VolumeFile, ReplacesWhatIsThere) {
    const TemporaryFolder folder;
    for (const std::string ending : kEndings) {
        const fs::path path = folder / ("a" + ending);
        expectWritten(phantom::make({.size = {32, 32, 32}, .spacingMm = {8, 8, 8}}), path);
        expectWritten(smallVolume(), path);
        const auto back = readBack(path);
        ASSERT_NE(back, nullptr);
        expectSame(*back, smallVolume(), toleranceOf(ending));
    }
}

TEST(VolumeFile, LabelMaps) {
    const TemporaryFolder folder;
    for (const std::uint16_t highest : {std::uint16_t{3}, std::uint16_t{40000}}) {
        std::vector<std::uint16_t> labels(3 * 4 * 2, 0);
        labels[5] = 1;
        labels[23] = highest;
        const auto map = LabelMap::create({3, 4, 2}, shearedAffine(), {}, labels);
        ASSERT_TRUE(map.ok());
        for (const std::string ending : kEndings) {
            Progress progress;
            ASSERT_TRUE(writeVolumeFile(*map, folder / ("l" + ending), progress).ok());
            const auto back = readBack(folder / ("l" + ending));
            ASSERT_NE(back, nullptr);
            ASSERT_EQ(back->size(), map->size());
            EXPECT_LT(affineError(back->worldFromVoxel(), shearedAffine()), toleranceOf(ending));
            EXPECT_EQ(back->value(2, 1, 0), 1.0);
            EXPECT_EQ(back->value(2, 3, 1), highest);
            EXPECT_EQ(back->value(0, 0, 0), 0.0);
        }
        EXPECT_EQ(readNiftiBytes(folder / "l.nii").datatype(), highest > 32767 ? 512 : 4);
    }
}

// Real files of other makers, and the DICOM that they were made from.
TEST(VolumeFile, ReferenceFilesOfTheFlatFolder) {
    SKIP_WITHOUT_SHARED_DATA();
    const auto found = scan(sharedData() / "odd/mixed_flat_folder");
    ASSERT_TRUE(found);
    int seen = 0;
    for (const Study& study : found->studies) {
        for (const Series& series : study.series) {
            if (series.stacks.empty()) continue;  // the structure set
            const std::string name = series.modality == "PT" ? "pet" : "mr";
            const auto reference =
                readBack(sharedData() / ("odd/mixed_flat_folder_truth_" + name + ".nii.gz"));
            const auto ours = load(series);
            ASSERT_TRUE(reference != nullptr && ours != nullptr);
            // The reference may count its voxels from other corners.
            const glm::dmat4 theirsFromOurs =
                glm::inverse(reference->worldFromVoxel()) * ours->worldFromVoxel();
            const double tolerance = name == "pet" ? 1e-3 : 0.0;
            for (int k = 0; k < ours->size().z; ++k) {
                for (int j = 0; j < ours->size().y; ++j) {
                    for (int i = 0; i < ours->size().x; ++i) {
                        const glm::dvec3 at = transformPoint(theirsFromOurs, {i, j, k});
                        const glm::ivec3 n(glm::round(at));
                        ASSERT_LT(glm::length(at - glm::dvec3(n)), 0.01);
                        ASSERT_NEAR(ours->value(i, j, k), reference->value(n.x, n.y, n.z), tolerance);
                    }
                }
            }
            ++seen;
        }
    }
    EXPECT_EQ(seen, 2);
}

}  // namespace
}  // namespace macula::formats::test
