#include "dicom/planar/planar_header.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dicom/read/dataset.h"
#include "dicom/read/tags.h"

namespace macula::dicom {

namespace {

constexpr Tag kRecommendedRate{0x0008, 0x2144};
constexpr Tag kPlaybackSequencing{0x0018, 0x1244};
constexpr Tag kViewPosition{0x0018, 0x5101};
constexpr Tag kBodyPartExamined{0x0018, 0x0015};
constexpr Tag kRegions{0x0018, 0x6011};
constexpr Tag kRegionFlags{0x0018, 0x6016};
constexpr Tag kRegionLeft{0x0018, 0x6018};
constexpr Tag kRegionTop{0x0018, 0x601A};
constexpr Tag kRegionRight{0x0018, 0x601C};
constexpr Tag kRegionBottom{0x0018, 0x601E};
constexpr Tag kRegionUnitX{0x0018, 0x6024};
constexpr Tag kRegionUnitY{0x0018, 0x6026};
constexpr Tag kRegionPerColumn{0x0018, 0x602C};
constexpr Tag kRegionPerRow{0x0018, 0x602E};
constexpr Tag kLaterality{0x0020, 0x0060};
constexpr Tag kImageLaterality{0x0020, 0x0062};
constexpr Tag kPixelAspectRatio{0x0028, 0x0034};
constexpr Tag kLutExplanation{0x0028, 0x3003};
constexpr Tag kPresentationLutShape{0x2050, 0x0020};

constexpr double kMostMs = 600'000.0;
constexpr int kMostFrames = 100'000;
constexpr double kMostAspect = 100.0;  // of a pixel that anybody can look at
constexpr std::size_t kMostRegions = 64;

bool isAbove0(double value) {
    return std::isfinite(value) && value > 0.0;
}

// The number of that attribute where it is above 0.
std::optional<double> positive(const Dataset& header, Tag tag) {
    const std::optional<double> value = header.number(tag);
    return value && *value > 0.0 ? value : std::nullopt;
}

// Of a biped (PS3.3 C.7.6.1.1.1): other letters have opposites of their own.
bool isDirection(const std::string& letters) {
    return !letters.empty() && letters.size() <= 3 &&
           letters.find_first_not_of("LRAPHF") == std::string::npos;
}

bool isLowBright(const Dataset& header) {
    const std::string shape = header.text(kPresentationLutShape).value_or("");
    if (shape == "INVERSE") return true;
    return shape != "IDENTITY" && header.text(tag::kPhotometricInterpretation) == "MONOCHROME1";
}

std::vector<VoiTable> tablesOf(const Dataset& header) {
    return readVoiTables(header, header.integer(tag::kPixelRepresentation).value_or(0) == 1 ||
                                     header.number(tag::kRescaleIntercept).value_or(0.0) < 0.0);
}

std::optional<std::pair<double, double>> spacing(const Dataset& header, Tag tag) {
    const auto rowsAndColumns = header.numbers(tag, 2);
    if (!rowsAndColumns || !isAbove0((*rowsAndColumns)[0]) || !isAbove0((*rowsAndColumns)[1])) return {};
    return std::pair((*rowsAndColumns)[0], (*rowsAndColumns)[1]);
}

// Pixel Spacing of a projection is calibrated only if it says so, or differs from that of the detector.
std::optional<PixelSize> pixelSizeOf(const Dataset& header) {
    const auto inPatient = spacing(header, tag::kPixelSpacing);
    const auto atDetector = spacing(header, tag::kImagerPixelSpacing);
    const auto ofFilm = spacing(header, tag::kNominalScannedPixelSpacing);
    const std::string how = header.text({0x0028, 0x0A02}).value_or("");
    const auto& other = atDetector ? atDetector : ofFilm;
    if (inPatient && (!other || !how.empty() || *inPatient != *other)) {
        PixelSize size{.columnMm = inPatient->second, .rowMm = inPatient->first};
        if (how == "GEOMETRY") size.calibration = PixelSize::Calibration::geometry;
        if (how == "FIDUCIAL") size.calibration = PixelSize::Calibration::fiducial;
        return size;
    }
    if (!atDetector && ofFilm)
        return PixelSize{.of = PixelSize::Of::film, .columnMm = ofFilm->second, .rowMm = ofFilm->first};
    if (!atDetector) return {};
    PixelSize size{.of = PixelSize::Of::detector, .columnMm = atDetector->second, .rowMm = atDetector->first};
    const std::optional<double> magnification = positive(header, tag::kEstimatedMagnification);
    if (!magnification) return size;
    size.of = PixelSize::Of::estimate;
    size.magnification = *magnification;
    size.columnMm /= *magnification;
    size.rowMm /= *magnification;
    return size;
}

// PS3.3 C.8.5.5.1.15.
std::pair<UltrasoundRegion::Unit, double> unitOf(int code) {
    using Unit = UltrasoundRegion::Unit;
    constexpr double kMmOfCm = 10.0;
    switch (code) {
        case 0:
            return {Unit::none, 1.0};
        case 1:
            return {Unit::percent, 1.0};
        case 2:
            return {Unit::decibels, 1.0};
        case 3:
            return {Unit::millimetres, kMmOfCm};
        case 4:
            return {Unit::seconds, 1.0};
        case 5:
            return {Unit::hertz, 1.0};
        case 7:
            return {Unit::centimetresPerSecond, 1.0};
        case 12:
            return {Unit::degrees, 1.0};
        default:
            return {Unit::other, 1.0};
    }
}

std::vector<UltrasoundRegion> regionsOf(const Dataset& header) {
    std::vector<UltrasoundRegion> regions;
    for (const Dataset& item : header.items(kRegions)) {
        if (regions.size() == kMostRegions) break;
        const auto left = item.integer(kRegionLeft);
        const auto top = item.integer(kRegionTop);
        const auto right = item.integer(kRegionRight);
        const auto bottom = item.integer(kRegionBottom);
        if (!left || !top || !right || !bottom || *right < *left || *bottom < *top) continue;
        const auto [unitX, scaleX] = unitOf(item.integer(kRegionUnitX).value_or(0));
        const auto [unitY, scaleY] = unitOf(item.integer(kRegionUnitY).value_or(0));
        regions.push_back({.left = *left,
                           .top = *top,
                           .right = *right,
                           .bottom = *bottom,
                           .unitX = unitX,
                           .unitY = unitY,
                           .perColumn = item.number(kRegionPerColumn).value_or(0.0) * scaleX,
                           .perRow = item.number(kRegionPerRow).value_or(0.0) * scaleY,
                           .isLowPriority = (item.integer(kRegionFlags).value_or(0) & 1) != 0});
    }
    return regions;
}

// The scale that all regions in millimetres share; others, such as those of time, have none.
std::optional<PixelSize> pixelSizeOf(const std::vector<UltrasoundRegion>& regions) {
    std::optional<PixelSize> shared;
    for (const UltrasoundRegion& region : regions) {
        using Unit = UltrasoundRegion::Unit;
        if (region.unitX != Unit::millimetres || region.unitY != Unit::millimetres) continue;
        const PixelSize size{.of = PixelSize::Of::regions,
                             .columnMm = std::abs(region.perColumn),
                             .rowMm = std::abs(region.perRow)};
        if (!isAbove0(size.columnMm) || !isAbove0(size.rowMm)) return {};
        if (shared && (shared->columnMm != size.columnMm || shared->rowMm != size.rowMm)) return {};
        shared = size;
    }
    return shared;
}

double heightOverWidth(const Dataset& header, const std::optional<PixelSize>& size) {
    const auto ratio = header.numbers(kPixelAspectRatio, 2);  // vertical, horizontal
    double aspect = 1.0;
    if (size)
        aspect = size->rowMm / size->columnMm;
    else if (ratio)
        aspect = (*ratio)[0] / (*ratio)[1];
    return aspect >= 1.0 / kMostAspect && aspect <= kMostAspect ? aspect : 1.0;
}

// Increments from each frame to the next; that of the first is 0 and means nothing. The last frame is shown
// as long as the one before.
std::vector<double> shownMs(const std::vector<double>& increments) {
    std::vector<double> shown(increments.begin() + 1, increments.end());
    shown.push_back(shown.back());
    const bool isUsable = std::ranges::all_of(shown, [](double ms) { return isAbove0(ms) && ms <= kMostMs; });
    return isUsable ? shown : std::vector<double>();
}

CineTiming cineOf(const Dataset& header) {
    CineTiming timing;
    const auto frames = static_cast<std::size_t>(std::min(header.frameCount(), kMostFrames));
    if (frames < 2) return timing;
    timing.sweeps = header.integer(kPlaybackSequencing).value_or(0) == 1;
    const std::vector<double> increments = header.allNumbers(tag::kFrameTimeVector);
    if (increments.size() == frames) timing.frameMs = shownMs(increments);
    if (!timing.frameMs.empty()) return timing;
    constexpr double kMsOfSecond = 1000.0;
    std::optional<double> ms = positive(header, tag::kFrameTime);
    for (const Tag rate : {kRecommendedRate, tag::kCineRate}) {
        const std::optional<double> perSecond = positive(header, rate);
        if (!ms && perSecond) ms = kMsOfSecond / *perSecond;
    }
    if (ms && *ms <= kMostMs) timing.frameMs.assign(frames, *ms);
    return timing;
}

}  // namespace

std::vector<VoiTable> readVoiTables(const Dataset& header, bool valuesAreSigned) {
    std::vector<VoiTable> tables;
    for (const Dataset& item : header.items(tag::kVoiLutSequence)) {
        const std::vector<std::uint16_t> descriptor = item.words(tag::kLutDescriptor);
        if (descriptor.size() != 3 || descriptor[2] < 1 || descriptor[2] > 16) continue;
        auto table = readModalityLut({descriptor[0], descriptor[1], descriptor[2]}, item.words(tag::kLutData),
                                     valuesAreSigned);
        if (!table) continue;
        tables.push_back(
            {std::move(table), int(descriptor[2]), item.text(kLutExplanation).value_or(std::string())});
    }
    return tables;
}

bool UltrasoundRegion::holds(double column, double row) const {
    return column >= left && row >= top && column <= right + 1.0 && row <= bottom + 1.0;
}

Result<PlanarHeader> readPlanarHeader(const std::filesystem::path& file, int frame) {
    const HeaderFile read = readHeader(file);
    if (!read.header)
        return Error{ErrorCode::inputNotUsable, Text("The image cannot be read."), file.string(),
                     Text("Check that the file or disc is still there.")};
    const Dataset header = read.header->frame(frame);
    PlanarHeader planar;
    planar.isOfFrame = read.header->has(tag::kPerFrameFunctionalGroups);
    planar.isLowBright = isLowBright(header);
    planar.tables = tablesOf(header);
    planar.isByPlane = header.integer({0x0028, 0x0006}).value_or(0) == 1;
    if (header.text(tag::kPhotometricInterpretation) == "PALETTE COLOR") {
        if (auto palette =
                readPalette(*read.header, header.integer(tag::kPixelRepresentation).value_or(0) == 1))
            planar.palette = std::make_shared<const ColourPalette>(*std::move(palette));
    }
    planar.regions = regionsOf(header);
    planar.pixelSize = planar.regions.empty() ? pixelSizeOf(header) : pixelSizeOf(planar.regions);
    planar.pixelHeightOverWidth = heightOverWidth(header, planar.pixelSize);
    planar.cine = cineOf(*read.header);
    planar.shutter = readDisplayShutter(header);
    planar.overlays = readOverlayPlanes(header);
    const std::vector<std::string> towards = header.texts(tag::kPatientOrientation);
    if (towards.size() == 2 && std::ranges::all_of(towards, isDirection))
        planar.towards = {towards[0], towards[1]};
    planar.laterality = header.text(kImageLaterality).value_or(header.text(kLaterality).value_or(""));
    planar.viewPosition = header.text(kViewPosition).value_or("");
    planar.bodyPart = header.text(kBodyPartExamined).value_or("");
    return planar;
}

}  // namespace macula::dicom
