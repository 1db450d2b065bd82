#include "study/segmentation/label_map.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "base/exceptions.h"
#include "base/frames.h"
#include "base/sha256.h"
#include "dicom/segmentation/segment_voxels.h"
#include "formats/label_map_file.h"
#include "formats/volume_file.h"

namespace macula::study {

namespace {

constexpr double kMm3PerMl = 1000.0;
constexpr double kSamePlaceMm = 0.01;

struct Grid {
    glm::ivec3 size{0};
    glm::dmat4 worldFromVoxel{1.0};
};

// Whether each voxel of the volume is one of the file, and each of the file one of the volume: sizes and
// directions may be exchanged, as programs store voxels in other orders.
bool haveSameVoxels(const Grid& file, const Volume& volume) {
    const glm::dmat4 fileFromVoxel = glm::inverse(file.worldFromVoxel) * volume.worldFromVoxel();
    glm::dmat4 whole(1.0);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) {
            const double value = fileFromVoxel[column][row];
            if (!(std::abs(value) < 1e6)) return false;
            whole[column][row] = std::round(value);
        }
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 step = glm::abs(glm::dvec3(whole[axis]));
        if (step.x + step.y + step.z != 1.0) return false;
        const int ofFile = step.x == 1.0 ? 0 : step.y == 1.0 ? 1 : 2;
        if (file.size[ofFile] != volume.size()[axis]) return false;
    }
    const Box voxels{glm::dvec3(0.0), glm::dvec3(volume.size() - 1)};
    for (const glm::dvec3& corner : cornersOf(voxels)) {
        const glm::dvec3 there = transformPoint(whole, corner);
        const glm::dvec3 most = glm::dvec3(file.size - 1);
        if (glm::any(glm::lessThan(there, glm::dvec3(0.0))) || glm::any(glm::greaterThan(there, most)))
            return false;
        const double offMm = glm::distance(transformPoint(file.worldFromVoxel, there),
                                           transformPoint(volume.worldFromVoxel(), corner));
        if (!(offMm <= kSamePlaceMm)) return false;
    }
    return true;
}

double voxelMlOf(const glm::dmat4& worldFromVoxel) {
    return std::abs(glm::determinant(glm::dmat3(worldFromVoxel))) / kMm3PerMl;
}

// Volume and middle come from the voxels of the file.
LoadedSegment loadedFrom(formats::FileSegment&& of, const Grid& file, const Volume& volume,
                         const CancelToken& token) {
    LoadedSegment loaded;
    loaded.segment = std::move(of.segment);
    glm::dvec3 sum(0.0);
    std::size_t count = 0;
    of.voxels.forEach([&](const glm::ivec3& voxel) {
        sum += glm::dvec3(voxel);
        ++count;
    });
    if (count > 0) {
        loaded.volumeMl = double(count) * voxelMlOf(file.worldFromVoxel);
        loaded.centroidMm = transformPoint(file.worldFromVoxel, sum / double(count));
    }
    const glm::dmat4 fileFromVoxel = glm::inverse(file.worldFromVoxel) * volume.worldFromVoxel();
    loaded.voxels = std::make_shared<const VoxelSet>(
        dicom::nearestVoxels(of.voxels, fileFromVoxel, volume.size(), token));
    return loaded;
}

std::vector<Text> notesOn(const formats::LabelMapFile& file, bool isResampled) {
    std::vector<Text> notes{
        Text("The file names no patient and no frame of reference: it was taken to be of this patient, and "
             "to lie in the coordinate system of this volume.")};
    notes.insert(notes.end(), file.assumptions.begin(), file.assumptions.end());
    if (isResampled)
        notes.push_back(
            Text("It was drawn on other voxels than those of this volume; the nearest voxel is shown."));
    if (!file.hasNames) notes.push_back(Text("The file has the numbers of segments, not their names."));
    return notes;
}

Result<OpenedLabelMap> open(const std::filesystem::path& path, const Volume& volume, Progress& progress) {
    MACULA_TRY(formats::LabelMapFile file, formats::readLabelMapFile(path, progress));
    const Grid grid{file.size, file.worldFromVoxel};
    OpenedLabelMap opened;
    opened.found.title = path.filename().string();
    opened.found.digest = sha256Hex("label map " + path.string());
    auto loaded = std::make_shared<LoadedSegmentation>();
    loaded->digest = opened.found.digest;
    loaded->isResampled = !haveSameVoxels(grid, volume);
    loaded->notes = notesOn(file, loaded->isResampled);
    progress.beginStage(Text("Placing the segments"), file.segments.size());
    for (formats::FileSegment& each : file.segments) {
        loaded->segments.push_back(loadedFrom(std::move(each), grid, volume, progress.token()));
        opened.found.header.segments.push_back(loaded->segments.back().segment);
        progress.advance();
        if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}};
    }
    if (std::ranges::none_of(loaded->segments, &LoadedSegment::isInVolume))
        return Error{ErrorCode::inputNotUsable,
                     Text("No voxel of this segmentation lies in the volume that is open."), path.string(),
                     Text("Open the volume that it was drawn on first.")};
    opened.loaded = std::move(loaded);
    return opened;
}

}  // namespace

Result<OpenedLabelMap> openLabelMap(const std::filesystem::path& path, const Volume& volume,
                                    Progress& progress) try {
    return open(path, volume, progress);
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("open this segmentation"), path.string());
}

LabelMapGuess guessLabelMap(const std::filesystem::path& path, const Volume& volume) try {
    if (!formats::isVolumeFileName(path)) return LabelMapGuess::no;
    if (formats::isSegmentationName(path)) return LabelMapGuess::yes;
    const auto info = formats::readVolumeFileInfo(path);
    const bool isOnIt = info && info->volumes == 1 && isInvertibleAffine(info->worldFromVoxel) &&
                        haveSameVoxels({info->size, info->worldFromVoxel}, volume);
    return isOnIt ? LabelMapGuess::maybe : LabelMapGuess::no;
} catch (const std::exception&) {
    return LabelMapGuess::no;
}

}  // namespace macula::study
