#include "study/planar/planar_images.h"

#include <algorithm>
#include <utility>

#include "unpack/archive_name.h"

namespace macula::study {

bool canBeShownAsImages(const dicom::Stack& stack) {
    return !stack.canBeVolume() && !stack.frames.empty();
}

std::vector<PlanarSeries> planarSeriesOf(const FoundVolumes& found) {
    std::vector<PlanarSeries> all;
    for (const dicom::Study& study : found.scan().studies)
        for (const dicom::Series& series : study.series)
            for (const dicom::Stack& stack : series.stacks)
                if (canBeShownAsImages(stack)) all.push_back({&study, &series, &stack});
    return all;
}

bool holds(const PlanarSeries& series, const std::filesystem::path& file) {
    return series.stack != nullptr &&
           std::ranges::any_of(series.stack->frames,
                               [&](const dicom::Frame& frame) { return frame.instance->file == file; });
}

PlanarSeries planarSeriesFor(const FoundVolumes& found, const std::filesystem::path& source) {
    const std::vector<PlanarSeries> all = planarSeriesOf(found);
    if (all.empty()) return {};
    const auto own = std::ranges::find_if(all, [&](const PlanarSeries& each) { return holds(each, source); });
    if (own != all.end()) return *own;
    std::error_code failure;
    const bool isFile = std::filesystem::is_regular_file(source, failure) &&
                        source.filename() != "DICOMDIR" && !unpack::isArchive(source);
    const bool isOfOne = std::ranges::all_of(
        all, [&](const PlanarSeries& each) { return each.study->patient == all.front().study->patient; });
    if (isFile || !isOfOne) return {};
    return *std::ranges::max_element(all, {}, [](const PlanarSeries& each) {
        return std::pair(each.study->date, each.stack->frames.size());
    });
}

PlanarSeries seriesOf(const FoundVolumes& found, const dicom::Stack* stack) {
    for (const dicom::Study& study : found.scan().studies)
        for (const dicom::Series& series : study.series)
            for (const dicom::Stack& each : series.stacks)
                if (&each == stack && !each.frames.empty()) return {&study, &series, &each};
    return {};
}

Identity identityOf(const PlanarSeries& series) {
    return identityOf(FoundVolume{series.study, series.series, series.stack});
}

std::vector<PlanarLoop> loopsOf(const dicom::Stack& stack) {
    std::vector<PlanarLoop> loops;
    for (std::size_t i = 0; i < stack.frames.size(); ++i) {
        const bool goesOn = i > 0 && stack.frames[i].instance == stack.frames[i - 1].instance;
        if (!goesOn) loops.push_back({i, i});
        loops.back().end = i + 1;
    }
    return loops;
}

}  // namespace macula::study
