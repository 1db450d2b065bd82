#include "formats/label_map_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/exceptions.h"
#include "base/label_sets.h"
#include "base/parsing.h"
#include "formats/text_header.h"
#include "formats/volume_file.h"

namespace macula::formats {

namespace {

namespace fs = std::filesystem;
using LayerSets = std::map<std::uint16_t, VoxelSet>;

bool endsWith(const fs::path& path, std::string_view ending) {
    const std::string name = lowerCase(path.filename().string());
    return name.size() > ending.size() && name.ends_with(ending);
}

// A segment as the header of 3D Slicer describes it ("Segment0_Name:=Liver").
struct Described {
    Segment segment;
    std::size_t layer = 0;
    std::uint16_t value = 1;  // of its voxels in the layer
};

// "0.5 0.68 0.5"
std::optional<std::array<std::uint8_t, 3>> rgbOf(const std::string& text) {
    const auto parts = parseNumbers(text, 3);
    if (!parts) return std::nullopt;
    std::array<std::uint8_t, 3> rgb{};
    for (std::size_t n = 0; n < 3; ++n) {
        if (!std::isfinite((*parts)[n])) return std::nullopt;
        rgb.at(n) = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp((*parts)[n], 0.0, 1.0)));
    }
    return rgb;
}

// Files of before 2020 have one layer for each segment, and no label values.
std::vector<Described> describedIn(const Fields& notes) {
    std::vector<Described> all;
    for (std::size_t n = 0; n < kMostLabels; ++n) {
        const std::string prefix = fmt::format("Segment{}_", n);
        const auto has = [&](const char* key) { return notes.contains(prefix + key); };
        if (!has("ID") && !has("Name")) break;
        Described one;
        one.segment.label = std::string(trimmed(valueOf(notes, prefix + "Name")));
        one.segment.recommendedRgb = rgbOf(valueOf(notes, prefix + "Color"));
        one.layer = parseNumber<std::size_t>(trimmed(valueOf(notes, prefix + "Layer")))
                        .value_or(has("LabelValue") ? 0 : n);
        one.value = parseNumber<std::uint16_t>(trimmed(valueOf(notes, prefix + "LabelValue"))).value_or(1);
        all.push_back(std::move(one));
    }
    return all;
}

Error notALabelMap(Text message) {
    return {ErrorCode::inputNotUsable,
            std::move(message),
            {},
            Text("Choose a file with a segmentation, or open this one as a volume.")};
}

void addTo(LabelMapFile& file, Segment segment, std::uint16_t number, VoxelSet voxels) {
    segment.number = number;
    if (segment.label.empty()) segment.label = fmt::format("Label {}", number);
    file.segments.push_back({std::move(segment), std::move(voxels)});
}

// Numbers are those in the file where they are different, otherwise the places of the segments.
void addDescribed(LabelMapFile& file, std::vector<Described> described, std::vector<LayerSets>& layers) {
    std::set<std::uint16_t> values;
    for (const Described& each : described) values.insert(each.value);
    const bool areDifferent = values.size() == described.size() && !values.contains(0);
    std::uint16_t place = 0;
    for (Described& each : described) {
        ++place;
        VoxelSet voxels;
        if (each.layer < layers.size()) {
            const auto there = layers[each.layer].find(each.value);
            if (there != layers[each.layer].end()) voxels = std::move(there->second);
            if (there != layers[each.layer].end()) layers[each.layer].erase(there);
        }
        addTo(file, std::move(each.segment), areDifferent ? each.value : place, std::move(voxels));
    }
}

// What the header does not describe gets the number of the file where that is free.
void addOthers(LabelMapFile& file, std::vector<LayerSets>& layers) {
    std::set<std::uint16_t> taken;
    for (const FileSegment& each : file.segments) taken.insert(each.segment.number);
    for (LayerSets& layer : layers)
        for (auto& each : layer) {
            std::uint16_t number = each.first;
            while (!taken.insert(number).second) number = number == 65535 ? 1 : std::uint16_t(number + 1);
            addTo(file, {}, number, std::move(each.second));
        }
}

// A segmentation leaves something out, or has few numbers.
bool isAnImage(const LayerSets& sets, const glm::ivec3& size) {
    constexpr std::size_t kManyNumbers = 200;
    constexpr double kMostLabelled = 0.99;
    if (sets.size() < kManyNumbers) return false;
    double labelled = 0.0;
    for (const auto& each : sets) labelled += double(each.second.count());
    return labelled > kMostLabelled * double(size.x) * size.y * size.z;
}

Result<LabelMapFile> read(const fs::path& path, Progress& progress) {
    MACULA_TRY(const VolumeFileInfo info, readVolumeFileInfo(path));
    std::vector<Described> described;
    if (endsWith(path, ".nrrd") || endsWith(path, ".nhdr")) {
        MACULA_TRY(const TextHeader header, readNrrdHeader(path));
        described = describedIn(header.notes);
    }
    if (info.volumes > 1 && described.empty())
        return notALabelMap(Text("The file holds {} volumes, and is no label map of one.", info.volumes));
    if (info.volumes > kMostLabels)
        return notALabelMap(Text("The file has more than {} layers of segments.", kMostLabels));
    LabelMapFile file{
        .size = info.size, .worldFromVoxel = info.worldFromVoxel, .assumptions = info.assumptions};
    file.hasNames = !described.empty();
    std::vector<LayerSets> layers;
    std::size_t most = kMostLabels;
    for (std::size_t layer = 1; layer <= info.volumes; ++layer) {
        MACULA_TRY(const auto labels, readVolumeFile(path, progress, layer));
        MACULA_TRY(LayerSets sets, labelSets(*labels, most, progress.token()));
        most -= sets.size();
        if (described.empty() && isAnImage(sets, info.size))
            return notALabelMap(Text(
                "It has {} numbers and hardly a voxel that is 0: it seems to be an image.", sets.size()));
        layers.push_back(std::move(sets));
    }
    addDescribed(file, std::move(described), layers);
    addOthers(file, layers);
    if (file.segments.size() > kMostLabels)
        return notALabelMap(Text("It has more than {} segments.", kMostLabels));
    if (std::ranges::all_of(file.segments, [](const FileSegment& each) { return each.voxels.isEmpty(); }))
        return notALabelMap(Text("It has no segment: all of its voxels are 0."));
    std::ranges::sort(file.segments, {}, [](const FileSegment& each) { return each.segment.number; });
    return file;
}

}  // namespace

bool isSegmentationName(const fs::path& path) {
    return endsWith(path, ".seg.nrrd") || endsWith(path, ".seg.nhdr");
}

Result<LabelMapFile> readLabelMapFile(const fs::path& path, Progress& progress) try {
    auto file = read(path, progress);
    if (file) return file;
    Error error = file.error();
    if (error.where.empty()) error.where = path.string();
    return error;
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("read this label map"), path.string());
}

}  // namespace macula::formats
