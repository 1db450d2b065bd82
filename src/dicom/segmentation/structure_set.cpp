#include "dicom/segmentation/structure_set.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "base/available_memory.h"
#include "base/exceptions.h"
#include "dicom/read/dataset.h"
#include "dicom/read/sop_class.h"
#include "dicom/read/tags.h"

namespace macula::dicom {

namespace {

constexpr Tag kLabel{0x3006, 0x0002};
constexpr Tag kReferencedFrames{0x3006, 0x0010};
constexpr Tag kReferencedStudies{0x3006, 0x0012};
constexpr Tag kReferencedSeriesOfStudy{0x3006, 0x0014};
constexpr Tag kRegions{0x3006, 0x0020};
constexpr Tag kRegionNumber{0x3006, 0x0022};
constexpr Tag kRegionFrameOfReference{0x3006, 0x0024};
constexpr Tag kRegionName{0x3006, 0x0026};
constexpr Tag kRegionDescription{0x3006, 0x0028};
constexpr Tag kColour{0x3006, 0x002A};
constexpr Tag kAlgorithm{0x3006, 0x0036};
constexpr Tag kRegionContours{0x3006, 0x0039};
constexpr Tag kContours{0x3006, 0x0040};
constexpr Tag kGeometricType{0x3006, 0x0042};
constexpr Tag kContourData{0x3006, 0x0050};
constexpr Tag kReferencedRegionNumber{0x3006, 0x0084};

constexpr double kFarthestMm = 1e6;
constexpr double kSamePlaneMm = 0.02;
constexpr double kFlatMm = 0.1;        // of a contour, and of its angle with the slices
constexpr double kTieOfSlice = 1e-3;   // a plane half-way between two slices belongs to both
constexpr double kFartherApart = 1.1;  // planes than slices
constexpr std::size_t kMostRegions = 4096;

Error notUsable(const std::filesystem::path& file) {
    return {ErrorCode::inputNotUsable, Text("The structure set cannot be read."), file.string(),
            Text("Copy the file again from its source.")};
}

std::optional<std::array<std::uint8_t, 3>> colourOf(const Dataset& item) {
    const auto rgb = item.numbers(kColour, 3);
    if (!rgb) return {};
    std::array<std::uint8_t, 3> colour{};
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] = static_cast<std::uint8_t>(std::clamp((*rgb)[c], 0.0, 255.0));
    return colour;
}

void addContours(StructureRegion& region, const Dataset& item) {
    constexpr std::size_t kFewest = 3;
    for (const Dataset& each : item.items(kContours)) {
        const std::string type = each.text(kGeometricType).value_or("");
        if (type == "POINT" || type == "OPEN_PLANAR" || type == "OPEN_NONPLANAR") {
            ++region.points;
            continue;
        }
        const std::vector<double> numbers = each.allNumbers(kContourData);
        const bool isUsable =
            (type == "CLOSED_PLANAR" || type == "CLOSEDPLANAR_XOR") && numbers.size() % 3 == 0 &&
            numbers.size() >= 3 * kFewest &&
            std::ranges::all_of(numbers, [](double n) { return std::abs(n) <= kFarthestMm; });
        if (!isUsable) {
            ++region.unusable;
            continue;
        }
        Contour& contour = region.contours.emplace_back();
        contour.reserve(numbers.size() / 3);
        for (std::size_t i = 0; i < numbers.size(); i += 3)
            contour.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    }
}

std::vector<std::string> seriesOf(const Dataset& header) {
    std::vector<std::string> uids;
    for (const Dataset& frame : header.items(kReferencedFrames))
        for (const Dataset& study : frame.items(kReferencedStudies))
            for (const Dataset& series : study.items(kReferencedSeriesOfStudy))
                if (auto uid = series.text(tag::kSeriesInstanceUid)) uids.push_back(*std::move(uid));
    std::ranges::sort(uids);
    uids.erase(std::unique(uids.begin(), uids.end()), uids.end());
    return uids;
}

StructureSet structuresIn(const Dataset& header) {
    StructureSet structures;
    structures.sopInstanceUid = header.text(tag::kSopInstanceUid).value_or("");
    structures.label = header.text(kLabel).value_or("");
    structures.referencedSeriesUids = seriesOf(header);
    std::map<int, std::size_t> placeOf;  // by the number of the region
    for (const Dataset& item : header.items(kRegions)) {
        const std::optional<int> number = item.integer(kRegionNumber);
        const bool isUsable = number && structures.regions.size() < kMostRegions &&
                              placeOf.try_emplace(*number, structures.regions.size()).second;
        if (!isUsable) {
            ++structures.lost;
            continue;
        }
        StructureRegion& region = structures.regions.emplace_back();
        region.segment.number = static_cast<std::uint16_t>(structures.regions.size());
        region.segment.label = item.text(kRegionName).value_or("");
        region.segment.description = item.text(kRegionDescription).value_or("");
        region.segment.algorithm = item.text(kAlgorithm).value_or("");
        region.frameOfReferenceUid = item.text(kRegionFrameOfReference).value_or("");
    }
    for (const Dataset& item : header.items(kRegionContours)) {
        const auto found = placeOf.find(item.integer(kReferencedRegionNumber).value_or(-1));
        if (found == placeOf.end()) {
            structures.lost += item.itemCount(kContours) > 0 ? 1 : 0;
            continue;
        }
        StructureRegion& region = structures.regions[found->second];
        region.segment.recommendedRgb = colourOf(item);
        addContours(region, item);
    }
    return structures;
}

// Contours in one plane of the grid, in voxels.
struct Plane {
    double mm = 0.0;  // along the normal of the slices
    std::vector<const Contour*> contours;
    double areaMm2 = 0.0;
    glm::dvec3 momentMm{0.0};  // area times its centre
};

// Of a flat contour, with the sign of its sense around the normal, and the moment of that area.
std::pair<double, glm::dvec3> areaOf(const Contour& contour, const glm::dvec3& normal) {
    double area = 0.0;
    glm::dvec3 moment(0.0);
    const glm::dvec3& origin = contour.front();
    for (std::size_t i = 1; i + 1 < contour.size(); ++i) {
        const glm::dvec3 a = contour[i] - origin;
        const glm::dvec3 b = contour[i + 1] - origin;
        const double part = 0.5 * glm::dot(glm::cross(a, b), normal);
        area += part;
        moment += part * (origin + (a + b) / 3.0);
    }
    return {area, moment};
}

// The places where a row of voxel centres, at `row`, crosses the contour; half open, so that a vertex on the
// row counts once.
void addCrossings(const Contour& contour, const glm::dmat4& voxelFromWorld, double row,
                  std::vector<double>& columns) {
    glm::dvec2 from(voxelFromWorld * glm::dvec4(contour.back(), 1.0));
    for (const glm::dvec3& point : contour) {
        const glm::dvec2 to(voxelFromWorld * glm::dvec4(point, 1.0));
        if ((from.y <= row) != (to.y <= row))
            columns.push_back(from.x + (row - from.y) / (to.y - from.y) * (to.x - from.x));
        from = to;
    }
}

class Voxels {
  public:
    Voxels(const glm::dmat4& worldFromVoxel, const glm::ivec3& size,
           std::span<const glm::dvec3> slicePositionsMm)
        : voxelFromWorld_(glm::inverse(worldFromVoxel)), size_(size) {
        const glm::dvec3 across = glm::cross(glm::dvec3(worldFromVoxel[0]), glm::dvec3(worldFromVoxel[1]));
        normal_ = glm::normalize(across);
        for (int k = 0; k < size.z; ++k) {
            const bool isGiven = slicePositionsMm.size() == std::size_t(size.z);
            const glm::dvec3 position = isGiven ? slicePositionsMm[std::size_t(k)]
                                                : glm::dvec3(worldFromVoxel * glm::dvec4(0, 0, k, 1));
            slicesMm_.push_back(glm::dot(position, normal_));
        }
        if (size.z > 1)
            sliceDistanceMm_ = std::abs(slicesMm_.back() - slicesMm_.front()) / double(size.z - 1);
    }

    Result<SegmentVoxels> of(const StructureRegion& region, RegionVoxels& all) {
        SegmentVoxels made;
        made.segment = region.segment;
        const std::vector<Plane> planes = planesOf(region, all);
        if (planes.empty()) return made;
        const double distanceMm = distanceOf(planes);
        measure(made, planes, distanceMm);
        all.isUneven = all.isUneven || isUneven(planes, distanceMm);
        double reachMm = 0.5 * sliceDistanceMm_;
        if (planes.size() > 1 && distanceMm > kFartherApart * sliceDistanceMm_ && sliceDistanceMm_ > 0.0) {
            reachMm = 0.5 * distanceMm;
            all.isBetween = true;
        }
        MACULA_TRY(made.voxels, filled(region, planes, reachMm));
        return made;
    }

  private:
    std::vector<Plane> planesOf(const StructureRegion& region, RegionVoxels& all) const {
        std::vector<Plane> planes;
        for (const Contour& contour : region.contours) {
            const auto along = [this](const glm::dvec3& point) { return glm::dot(point, normal_); };
            const auto [low, high] = std::ranges::minmax(contour, {}, along);
            if (along(high) - along(low) > kFlatMm) {
                ++all.oblique;
                continue;
            }
            const double mm = 0.5 * (along(low) + along(high));
            auto plane = std::ranges::find_if(
                planes, [&](const Plane& each) { return std::abs(each.mm - mm) <= kSamePlaneMm; });
            if (plane == planes.end()) plane = planes.insert(planes.end(), Plane{.mm = mm, .contours = {}});
            plane->contours.push_back(&contour);
        }
        std::ranges::sort(planes, {}, &Plane::mm);
        for (Plane& plane : planes) enclose(plane);
        return planes;
    }

    // A contour inside an odd number of others is a hole.
    void enclose(Plane& plane) const {
        for (const Contour* contour : plane.contours) {
            auto [area, moment] = areaOf(*contour, normal_);
            int around = 0;
            for (const Contour* other : plane.contours)
                around += other != contour && contains(*other, contour->front()) ? 1 : 0;
            const double sign = (area < 0.0 ? -1.0 : 1.0) * (around % 2 == 0 ? 1.0 : -1.0);
            plane.areaMm2 += sign * area;
            plane.momentMm += sign * moment;
        }
    }

    bool contains(const Contour& contour, const glm::dvec3& point) const {
        const glm::dvec2 voxel(voxelFromWorld_ * glm::dvec4(point, 1.0));
        std::vector<double> columns;
        addCrossings(contour, voxelFromWorld_, voxel.y, columns);
        return std::ranges::count_if(columns, [&](double column) { return column < voxel.x; }) % 2 == 1;
    }

    // The median distance of neighbouring planes; that of slices where there is one plane only.
    double distanceOf(const std::vector<Plane>& planes) const {
        if (planes.size() < 2) return sliceDistanceMm_;
        std::vector<double> distances;
        for (std::size_t i = 1; i < planes.size(); ++i) distances.push_back(planes[i].mm - planes[i - 1].mm);
        const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
        std::nth_element(distances.begin(), middle, distances.end());
        return *middle;
    }

    static bool isUneven(const std::vector<Plane>& planes, double distanceMm) {
        constexpr double kTolerance = 0.1;
        for (std::size_t i = 1; i < planes.size(); ++i) {
            const double apart = planes[i].mm - planes[i - 1].mm;
            if (std::abs(apart - distanceMm) > kTolerance * distanceMm) return true;
        }
        return false;
    }

    static void measure(SegmentVoxels& made, const std::vector<Plane>& planes, double distanceMm) {
        double area = 0.0;
        glm::dvec3 moment(0.0);
        for (const Plane& plane : planes) {
            area += plane.areaMm2;
            moment += plane.momentMm;
        }
        if (!(area > 0.0)) return;
        made.centroidMm = moment / area;
        if (distanceMm > 0.0) made.volumeMm3 = area * distanceMm;
    }

    // Null: no plane is near enough to that slice.
    const Plane* planeAt(const std::vector<Plane>& planes, double sliceMm, double reachMm) const {
        const auto nearest = std::ranges::min_element(
            planes, {}, [&](const Plane& plane) { return std::abs(plane.mm - sliceMm); });
        const double most = std::max(reachMm * (1.0 + kTieOfSlice), kFlatMm);
        return std::abs(nearest->mm - sliceMm) <= most ? &*nearest : nullptr;
    }

    Result<VoxelSet> filled(const StructureRegion& region, const std::vector<Plane>& planes, double reachMm) {
        glm::dvec2 low(1e30);
        glm::dvec2 high(-1e30);
        for (const Contour& contour : region.contours) {
            for (const glm::dvec3& point : contour) {
                const glm::dvec2 voxel(voxelFromWorld_ * glm::dvec4(point, 1.0));
                low = glm::min(low, voxel);
                high = glm::max(high, voxel);
            }
        }
        const glm::ivec3 from(clipped(low.x, size_.x), clipped(low.y, size_.y), 0);
        const glm::ivec3 to(clipped(high.x, size_.x), clipped(high.y, size_.y), size_.z - 1);
        const double bytes = VoxelSet::bytesFor(from, to);
        const auto available = availableMemory();
        if (available && bytes > double(*available))
            return notEnoughMemory(static_cast<std::uint64_t>(bytes), *available);
        VoxelSet set(from, to);
        for (int k = 0; k < size_.z; ++k) {
            const Plane* plane = planeAt(planes, slicesMm_[std::size_t(k)], reachMm);
            if (plane != nullptr) fillSlice(set, *plane, k, from, to);
        }
        return set.cropped();
    }

    static int clipped(double voxel, int size) {
        return static_cast<int>(std::clamp(std::floor(voxel), 0.0, double(size - 1)));
    }

    void fillSlice(VoxelSet& set, const Plane& plane, int k, const glm::ivec3& from, const glm::ivec3& to) {
        std::vector<double> columns;
        for (int j = from.y; j <= to.y; ++j) {
            columns.clear();
            for (const Contour* contour : plane.contours) addCrossings(*contour, voxelFromWorld_, j, columns);
            std::ranges::sort(columns);
            for (std::size_t n = 0; n + 1 < columns.size(); n += 2) {
                const auto clamped = [&](double column) {
                    return int(std::ceil(std::clamp(column, double(from.x) - 1.0, double(to.x) + 1.0)));
                };
                const int begin = std::max(from.x, clamped(columns[n]));
                const int end = clamped(columns[n + 1]);
                for (int i = begin; i < end; ++i) set.add({i, j, k});
            }
        }
    }

    const glm::dmat4 voxelFromWorld_;
    const glm::ivec3 size_;
    glm::dvec3 normal_{0.0};
    std::vector<double> slicesMm_;
    double sliceDistanceMm_ = 0.0;
};

}  // namespace

Result<StructureSet> readStructureSet(const std::filesystem::path& file) try {
    const HeaderFile read = readHeader(file);
    const bool isOne = read.header && read.header->text(tag::kSopClassUid) == sop_class::kStructureSet;
    if (!isOne) return notUsable(file);
    return structuresIn(*read.header);
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("read a structure set"), file.string());
}

Result<RegionVoxels> voxelsOf(const StructureSet& structures, const glm::dmat4& worldFromVoxel,
                              glm::ivec3 size, Progress& progress,
                              std::span<const glm::dvec3> slicePositionsMm) try {
    RegionVoxels all;
    Voxels voxels(worldFromVoxel, size, slicePositionsMm);
    progress.beginStage(Text("Reading {} contoured regions", structures.regions.size()),
                        structures.regions.size());
    for (const StructureRegion& region : structures.regions) {
        if (progress.cancelled())
            return Error{ErrorCode::cancelled, Text("Reading the segmentation was cancelled."), {}, {}};
        MACULA_TRY(SegmentVoxels made, voxels.of(region, all));
        all.sets.segments.push_back(std::move(made));
        progress.advance();
    }
    return all;
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("read a structure set"));
}

}  // namespace macula::dicom
