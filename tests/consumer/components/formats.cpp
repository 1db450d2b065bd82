// Writes a NIfTI file and reads it back.
#include <base/phantom.h>
#include <formats/volume_file.h>

#include <filesystem>

#include "ends.h"

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "made";
    std::filesystem::create_directories(folder);
    const macula::Volume volume = macula::phantom::make({.size = {64, 56, 40}, .spacingMm = {4.8, 4.8, 7.5}});
    macula::Progress progress;
    for (const char* name : {"volume.nii.gz", "volume.nrrd"}) {
        if (auto written = macula::formats::writeVolumeFile(volume, folder / name, progress); !written)
            return fail(written.error());
        const auto read = macula::formats::readVolumeFile(folder / name, progress);
        if (!read) return fail(read.error());
        if (expect((*read)->value(20, 30, 10) == volume.value(20, 30, 10), name) != 0) return 1;
    }
    return 0;
}
