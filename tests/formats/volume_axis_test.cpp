// What NIfTI and NRRD files say of the axis along which they hold several volumes.
#include "formats/volume_axis.h"

#include <gtest/gtest.h>

#include "import_support.h"

namespace macula::formats::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kVolume = 3 * 4 * 5 * 2;  // bytes

class VolumeAxes : public Import {
  protected:
    // Three volumes whose voxel (1, 0, 0) is 10, 20, 30; `units` is xyzt_units, `step` is pixdim[4].
    VolumeAxis ofNifti(int units, float step, float first = 0.0f) {
        NiftiBytes file = makeNifti(4, 2);
        file.set<std::int16_t>(40, 4);
        file.set<std::int16_t>(48, 3);
        file.set(92, step);
        file.bytes[123] = char(units);
        file.set(136, first);
        file.bytes.resize(352 + 3 * kVolume);
        return axisOf(write("t.nii", file.bytes));
    }
    VolumeAxis axisOf(const fs::path& path) {
        const auto info = readVolumeFileInfo(path);
        EXPECT_TRUE(info) << info.error().message;
        if (!info) return {};
        EXPECT_EQ(info->volumes, 3u);
        return info->axis;
    }
    static std::string nrrd(const std::string& fields) {
        return "NRRD0004\ntype: short\ndimension: 4\nendian: little\nencoding: raw\n" + fields + "\n";
    }
    // Values of volumes one after the other, or voxel by voxel.
    static std::string values(bool isInterleaved) {
        std::string bytes;
        for (int n = 0; n < 3 * 60; ++n) {
            const int volume = isInterleaved ? n % 3 : n / 60;
            const int voxel = isInterleaved ? n / 3 : n % 60;
            bytes += bytesOf(std::int16_t(100 * volume + voxel));
        }
        return bytes;
    }
    void expectVolumes(const fs::path& path) {
        for (int volume = 0; volume < 3; ++volume) {
            Progress progress;
            const auto read = readVolumeFile(path, progress, std::size_t(volume) + 1);
            ASSERT_TRUE(read) << read.error().message;
            EXPECT_EQ((*read)->size(), glm::ivec3(3, 4, 5));
            for (const glm::ivec3 at : {glm::ivec3(0), glm::ivec3(1, 0, 0), glm::ivec3(2, 3, 4)})
                EXPECT_EQ((*read)->value(at.x, at.y, at.z), 100 * volume + at.x + 3 * at.y + 12 * at.z);
        }
    }
};

TEST_F(VolumeAxes, OfNiftiIsTimeInItsUnit) {
    constexpr int kMm = 2;
    const VolumeAxis seconds = ofNifti(kMm | 8, 2.5f, 10.0f);
    EXPECT_TRUE(seconds.isOfTimes());
    EXPECT_EQ(seconds.at(0), 10'000.0);
    EXPECT_EQ(seconds.at(2), 15'000.0);
    EXPECT_EQ(ofNifti(kMm | 16, 40.0f).at(2), 80.0);
    EXPECT_NEAR(ofNifti(kMm | 24, 500.0f).at(2).value_or(0.0), 1.0, 1e-9);
    EXPECT_EQ(ofNifti(kMm | 32, 3.0f).unit, "Hz");
    EXPECT_EQ(ofNifti(kMm | 40, 3.0f).unit, "ppm");
    EXPECT_EQ(ofNifti(kMm, 3.0f).unit, "") << "it names none";
    EXPECT_EQ(ofNifti(kMm, 3.0f).at(1), 3.0);
    for (const float none : {0.0f, -1.0f, std::nanf(""), INFINITY})
        EXPECT_FALSE(ofNifti(kMm | 8, none).at(1)) << none;
    EXPECT_EQ(ofNifti(kMm | 8, 1.0f, std::nanf("")).at(1), 1000.0);
}

TEST_F(VolumeAxes, OfNiftiThatIsNoTimeIsSaid) {
    NiftiBytes file = makeNifti(4, 2);
    file.set<std::int16_t>(40, 4);
    file.set<std::int16_t>(48, 2);
    file.bytes[123] = char(2 | 32);
    file.bytes.resize(352 + 2 * kVolume);
    EXPECT_TRUE(
        anyContains(import(write("hz.nii", file.bytes))->provenance().assumptions, "Hz, which is no time"));
}

TEST_F(VolumeAxes, OfNrrdHasSpacingAndUnitOfItsLastAxis) {
    const std::string space =
        "sizes: 3 4 5 3\nspace: left-posterior-superior\nspace origin: (0,0,0)\n"
        "space directions: (1,0,0) (0,2,0) (0, 0, 3) none\nkinds: domain domain domain time\n";
    const fs::path timed = write(
        "t.nrrd",
        nrrd(space + "spacings: nan nan nan 2.5\naxis mins: nan nan nan 1\nunits: \"\" \"\" \"\" \"s\"\n") +
            values(false));
    expectVolumes(timed);
    const VolumeAxis axis = axisOf(timed);
    EXPECT_TRUE(axis.isOfTimes());
    EXPECT_EQ(axis.at(0), 1000.0);
    EXPECT_EQ(axis.at(2), 6000.0);
    EXPECT_FALSE(axisOf(write("n.nrrd", nrrd(space) + values(false))).at(1)) << "it says nothing";
    // As 3D Slicer writes sequences.
    const VolumeAxis listed =
        axisOf(write("s.nrrd", nrrd(space + "units: \"\" \"\" \"\" \"ms\"\naxis 3 index values:=0 7 9\n") +
                                   values(false)));
    EXPECT_EQ(listed.at(1), 7.0);
    EXPECT_EQ(listed.at(2), 9.0);
    EXPECT_FALSE(axisOf(write("f.nrrd", nrrd(space + "axis 3 index values:=0 9 7\n") + values(false))).at(1))
        << "they do not rise";
}

TEST_F(VolumeAxes, OfNrrdInASpaceOfFourAxes) {
    const std::string fields =
        "sizes: 3 4 5 3\nspace: left-posterior-superior-time\nspace origin: (7,8,9,100)\n"
        "space directions: (1,0,0,0) (0,2,0,0) (0,0,3,0) (0,0,0,40)\nkinds: domain domain domain domain\n";
    const fs::path path = write("itk.nrrd", nrrd(fields) + values(false));
    expectVolumes(path);
    EXPECT_EQ(axisOf(path).at(2), 180.0);
    const auto volume = import(path);
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(transformPoint(volume->worldFromVoxel(), {1, 1, 1}), glm::dvec3(8, 10, 12));
    const std::string mixed =
        "sizes: 3 4 5 3\nspace dimension: 4\nspace origin: (0,0,0,0)\n"
        "space directions: (1,0,0,1) (0,2,0,0) (0,0,3,0) (0,0,0,40)\n";
    EXPECT_SAYS(refused("mixed.nrrd", nrrd(mixed) + values(false)), "4 axes");
}

TEST_F(VolumeAxes, OfNrrdMayBeTheFirst) {
    const std::string fields =
        "sizes: 3 3 4 5\nspace: left-posterior-superior\nspace origin: (0,0,0)\n"
        "space directions: none (1,0,0) (0,2,0) (0,0,3)\nkinds: list domain domain domain\n"
        "MultiVolume.FrameLabels:=0,30.5,61\nMultiVolume.FrameIdentifyingDICOMTagUnits:=s\n";
    const fs::path path = write("m.nrrd", nrrd(fields) + values(true));
    expectVolumes(path);
    EXPECT_EQ(axisOf(path).at(1), 30'500.0);
    // Values at the end of the file, and big-endian ones in a compressed stream.
    write("m.raw", "rubbish" + values(true));
    const fs::path detached = write("m.nhdr", nrrd(fields + "byte skip: -1\ndata file: m.raw\n"));
    expectVolumes(detached);
    std::string packed = nrrd(fields);
    packed.replace(packed.find("raw"), 3, "gzip");
    packed.replace(packed.find("little"), 6, "big");
    std::string swapped = values(true);
    for (std::size_t n = 0; n + 1 < swapped.size(); n += 2) std::swap(swapped[n], swapped[n + 1]);
    expectVolumes(write("p.nrrd", packed + gzipped(swapped)));
    EXPECT_SAYS(refused("cut.nrrd", nrrd(fields) + values(true).substr(0, 300)), "cut off");
}

TEST_F(VolumeAxes, ComponentsAreNoTimes) {
    for (const char* kind : {"vector", "RGB-color", "covariant-vector", "complex", "3D-symmetric-matrix"}) {
        const std::string last =
            "sizes: 3 4 5 3\nspace: left-posterior-superior\nspace origin: (0,0,0)\n"
            "space directions: (1,0,0) (0,2,0) (0,0,3) none\nkinds: domain domain domain " +
            std::string(kind) + "\n";
        EXPECT_SAYS(refused("c.nrrd", nrrd(last) + values(false)), "several values in each voxel");
        const std::string first =
            "sizes: 3 3 4 5\nspace: left-posterior-superior\nspace origin: (0,0,0)\n"
            "space directions: none (1,0,0) (0,2,0) (0,0,3)\nkinds: " +
            std::string(kind) + " domain domain domain\n";
        EXPECT_SAYS(refused("c.nrrd", nrrd(first) + values(true)), "several values in each voxel");
    }
}

TEST_F(VolumeAxes, CountsThatNobodyHasAreRefused) {
    const std::string space =
        "space: left-posterior-superior\nspace origin: (0,0,0)\nkinds: domain domain domain time\n"
        "space directions: (1,0,0) (0,2,0) (0,0,3) none\n";
    for (const char* count : {"0", "-1", "99999999999999999999"})
        EXPECT_SAYS(refused("h.nrrd", nrrd("sizes: 3 4 5 " + std::string(count) + "\n" + space)), "damaged");
    EXPECT_SAYS(refused("h.nrrd", nrrd("sizes: 3 4 5 4000000000\n" + space) + values(false)), "more volumes");
}

}  // namespace
}  // namespace macula::formats::test
