#include "study/export/segmentation_on_grid.h"

#include <algorithm>
#include <vector>

#include "dicom/read/sop_class.h"
#include "dicom/segmentation/segmentation.h"

namespace macula::study {

namespace {

std::vector<const dicom::OtherObject*> segmentationsOf(const dicom::Series& series) {
    std::vector<const dicom::OtherObject*> found;
    for (const dicom::OtherObject& object : series.objects) {
        if (dicom::isSegmentation(object.sopClassUid)) found.push_back(&object);
    }
    return found;
}

// Loads the segmentation on the first grid that it fits; several stacks of a series may share one.
Result<SegmentationOnGrid> onItsGrid(const dicom::Scan& scan, const dicom::Segmentation& segmentation,
                                     Progress& progress) {
    bool hasImages = false;
    for (const std::string& uid : segmentation.referencedSeriesUids) {
        for (const dicom::Series* series : dicom::findAllSeries(scan, uid)) {
            for (const dicom::Stack& stack : series->stacks) {
                if (!stack.canBeVolume()) continue;
                const glm::ivec3 size(stack.columns, stack.rows, static_cast<int>(stack.slices.size()));
                hasImages = true;
                const std::vector<glm::dvec3> positionsMm = dicom::slicePositionsMm(stack);
                auto map =
                    dicom::loadSegmentation(segmentation, *stack.worldFromVoxel, size, progress, positionsMm);
                if (map) return SegmentationOnGrid{std::move(*map), true, true};
                if (map.error().code != ErrorCode::inputNotUsable) return map.error();
            }
        }
    }
    MACULA_TRY(LabelMap map, dicom::loadSegmentation(segmentation, progress));
    return SegmentationOnGrid{std::move(map), false, hasImages};
}

}  // namespace

bool isSegmentationSeries(const dicom::Series& series) {
    return series.stacks.empty() && !segmentationsOf(series).empty();
}

Result<SegmentationOnGrid> loadSegmentation(const dicom::Scan& scan, const dicom::Series& series,
                                            std::size_t number, Progress& progress) {
    const auto all = segmentationsOf(series);
    if (number == 0 && all.size() > 1) {
        return Error{ErrorCode::usage,
                     Text("The series has {} segmentations.", all.size()),
                     {},
                     Text("Choose one of them with --volume.")};
    }
    if (number > all.size()) {
        return Error{ErrorCode::usage,
                     Text("There is no segmentation {}; the series has {}.", number, all.size()),
                     {},
                     Text("Choose another with --volume.")};
    }
    MACULA_TRY(const dicom::Segmentation segmentation,
               dicom::readSegmentation(all[std::max<std::size_t>(number, 1) - 1]->file));
    return onItsGrid(scan, segmentation, progress);
}

}  // namespace macula::study
