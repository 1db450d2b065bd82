// Writes a series into a new folder, lists what is in it, and reads it back.
#include <base/phantom.h>
#include <dicom/best_volume.h>
#include <dicom/loader.h>
#include <dicom/scan.h>
#include <dicom/write/series_writer.h>

#include <filesystem>

#include "ends.h"

int main(int argc, char** argv) {
    const std::filesystem::path folder = std::filesystem::path(argc > 1 ? argv[1] : "made") / "series";
    const macula::Volume volume = macula::phantom::make({.size = {64, 56, 40}, .spacingMm = {4.8, 4.8, 7.5}});
    macula::Progress progress;
    std::filesystem::create_directories(folder.parent_path());
    if (auto written = macula::dicom::writeSeries(volume, folder, {}, progress); !written)
        return fail(written.error());
    const auto scan = macula::dicom::scanFolder(folder, progress);
    if (!scan) return fail(scan.error());
    const macula::dicom::ChosenStack best = macula::dicom::bestVolume(*scan);
    if (!best) return expect(false, best.why.english().c_str());
    const auto read = macula::dicom::loadVolume(*best.series, *best.stack, progress);
    if (!read) return fail(read.error());
    return expect((*read)->value(20, 30, 10) == volume.value(20, 30, 10), "a voxel comes back as it was");
}
