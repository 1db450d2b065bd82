#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "base/parsing.h"
#include "dicom/presentation/presentation_state.h"
#include "dicom/presentation/srgb_profile.h"
#include "dicom/read/presentation_tags.h"
#include "dicom/read/sop_class.h"
#include "dicom/write/decimal_string.h"
#include "dicom/write/item_writer.h"
#include "dicom/write/object_file.h"
#include "dicom/write/object_owner.h"
#include "dicom/write/uid.h"

namespace macula::dicom {

namespace fs = std::filesystem;
namespace tags = presentation_tag;

namespace {

constexpr std::size_t kLongestOwnState = 200000;  // readers accept at most 256 KiB
constexpr std::size_t kMostEntries = 65536;
constexpr double kUnitLength = 1e-6;
constexpr double kFarthestMm = 1e9;

bool isPoint(const glm::dvec3& p) {
    return std::abs(p.x) <= kFarthestMm && std::abs(p.y) <= kFarthestMm && std::abs(p.z) <= kFarthestMm;
}
bool isUnitVector(const glm::dvec3& v) {
    return std::abs(glm::length(v) - 1.0) <= kUnitLength;
}
bool isPart(double part) {
    return part >= 0.0 && part <= 1.0;
}

Result<void> checkTexts(const VolumePresentation& p) {
    if (!isCodeString(p.label))
        return refusedObject(Text("The label of the presentation state is not usable."),
                             Text("Take 1 to 16 capital letters, digits, blanks and underscores."));
    if (!isPlain(p.description)) return textRefused();
    if (p.ownState.size() > kLongestOwnState ||
        !std::ranges::all_of(p.ownState, [](char c) { return (c >= ' ' && c <= '~') || c == '\n'; }))
        return refusedObject(Text("The view is too large for a presentation state."),
                             Text("Save it as a view, or remove measurements and large presets from it."));
    return {};
}

Result<void> checkPalette(const Palette& palette) {
    const std::size_t colours = palette.red.size();
    const std::size_t entries = std::max(colours, palette.alpha.size());
    const auto fits = [&](const std::vector<std::uint16_t>& table) {
        return table.empty() || (table.size() == entries && table.size() >= 2 && entries <= kMostEntries);
    };
    const bool isTable = palette.green.size() == colours && palette.blue.size() == colours &&
                         fits(palette.red) && fits(palette.alpha);
    const bool isRange = std::abs(palette.values.low) <= kFarthestMm &&
                         std::abs(palette.values.high) <= kFarthestMm &&
                         palette.values.low < palette.values.high;
    if (isTable && isRange) return {};
    return refusedObject(Text("The colours of the presentation state are not usable."),
                         Text("Choose another preset, or a window above 0."));
}

Result<void> checkGeometry(const VolumePresentation& p) {
    const PresentedView& view = p.view;
    const FieldOfView& f = view.field;
    const bool isField = f.leftMm < f.rightMm && f.bottomMm < f.topMm && f.nearMm > 0.0 &&
                         f.nearMm < f.farMm && std::isfinite(f.leftMm) && std::isfinite(f.rightMm) &&
                         std::isfinite(f.topMm) && std::isfinite(f.bottomMm) && std::isfinite(f.farMm);
    const bool looks = isPoint(view.positionMm) && isPoint(view.lookAtMm) && isPoint(view.up) &&
                       view.positionMm != view.lookAtMm && view.up != glm::dvec3(0.0);
    if (!isField || !looks)
        return refusedObject(Text("The camera of the presentation state is not usable."),
                             Text("Choose another view."));
    for (const Box& box : p.cropping.boxes) {
        if (!isPoint(box.low) || !isPoint(box.high))
            return refusedObject(Text("The clip of the presentation state is not usable."),
                                 Text("Choose another clip."));
    }
    for (const CroppingPlane& plane : p.cropping.planes) {
        if (!isUnitVector(plane.outward) || !(std::abs(plane.offsetMm) <= kFarthestMm))
            return refusedObject(Text("The clip of the presentation state is not usable."),
                                 Text("Choose another clip."));
    }
    if (p.samplingStepMm && !(*p.samplingStepMm > 0.0 && *p.samplingStepMm <= kFarthestMm))
        return refusedObject(Text("The opacities of the presentation state are not usable."),
                             Text("Choose another preset."));
    if (!p.shading) return {};
    const PresentedShading& s = *p.shading;
    if (isPart(s.ambient) && isPart(s.diffuse) && isPart(s.specular) && isPart(s.shininess.value_or(0.0)) &&
        isUnitVector(s.lightDirection))
        return {};
    return refusedObject(Text("The shading of the presentation state is not usable."),
                         Text("Choose another preset."));
}

Result<void> check(const VolumePresentation& p, const NewObject& object) {
    MACULA_TRY_VOID(checkTexts(p));
    MACULA_TRY_VOID(checkPalette(p.palette));
    MACULA_TRY_VOID(checkGeometry(p));
    const PresentedSeries& series = p.series;
    if (series.images.empty() || !isUid(series.seriesInstanceUid) || !isUid(series.frameOfReferenceUid) ||
        !areUids(series.images))
        return refusedObject(
            Text("A presentation state refers to DICOM images with a frame of reference, and this "
                 "volume has none."),
            Text("Save it as a view."));
    return checkOwner(object, Text("Write the presentation state without patient and study."));
}

void point(ItemWriter to, Tag tag, const glm::dvec3& p) {
    to.numbers(tag, {p.x, p.y, p.z});
}

void writeOwnBlock(ItemWriter to, const std::string& state, const std::string& digest) {
    const auto tagOf = [](Tag tag) { return DcmTag(tag.group, tag.element, EVR_LO); };
    to.note(to.dcmtk().putAndInsertString(tagOf(tags::kPrivateBlock), tags::kPrivateCreator));
    std::vector<std::uint8_t> json(state.begin(), state.end());
    if (json.size() % 2 != 0) json.push_back(' ');
    to.bytes(tags::kOwnState, json);
    to.note(to.dcmtk().putAndInsertString(tagOf(tags::kOwnStateDigest), digest.c_str()));
}

void writeIdentification(ItemWriter to, const VolumePresentation& p) {
    const Now now;
    to.text(DCM_FrameOfReferenceUID, p.series.frameOfReferenceUid);
    to.text(DCM_PositionReferenceIndicator, "");
    to.text(tags::kContentLabel, p.label);
    to.text(tags::kContentDescription, p.description);
    to.text(tags::kContentCreatorName, "");
    const bool isDated = !p.creationDate.empty();
    to.text(tags::kCreationDate, isDated ? p.creationDate : now.date);
    to.text(tags::kCreationTime, isDated ? p.creationTime : now.time);
}

// PS3.3 C.11.23 and C.12.2.
void writeRelationship(ItemWriter to, const VolumePresentation& p) {
    const std::string inputSet = newUid();
    ItemWriter set = to.item(tags::kInputSets, 0);
    set.text(tags::kInputSetUid, inputSet);
    set.text(tags::kInputType, "VOLUME");
    ItemWriter series = to.item(tag::kReferencedSeries, 0);
    series.text(tag::kSeriesInstanceUid, p.series.seriesInstanceUid);
    for (std::size_t i = 0; i < p.series.images.size(); ++i) {
        const ReferencedImage& image = p.series.images[i];
        for (ItemWriter item :
             {set.item(tags::kReferencedImages, i), series.item(tags::kReferencedInstances, i)}) {
            item.text(tags::kReferencedSopClassUid, image.sopClassUid);
            item.text(tags::kReferencedSopInstanceUid, image.sopInstanceUid);
            if (!image.frames.empty())
                item.text(tags::kReferencedFrameNumber, fmt::format("{}", fmt::join(image.frames, "\\")));
        }
    }
    ItemWriter input = to.item(tags::kInputs, 0);
    input.word(tags::kInputNumber, 1);
    input.text(tags::kInputSetUid, inputSet);
    const ValueRange& values = p.palette.values;
    input.text(tags::kWindowCenter, decimalString(0.5 * (values.low + values.high)));
    input.text(tags::kWindowWidth, decimalString(values.high - values.low));
    input.text(tags::kVoiLutFunction, "LINEAR_EXACT");
    input.text(tags::kCrop, "NO");
    // The palette of a volume stream.
    ItemWriter stream = to.item(tags::kVolumeStreams, 0);
    stream.text(tags::kInputSetUid, inputSet);
}

// C.11.24: each box is a specification of its own, all planes are one.
void writeCropping(ItemWriter to, const Cropping& cropping) {
    to.text(tags::kGlobalCrop, cropping.isNothing() ? "NO" : "YES");
    if (cropping.isNothing()) return;
    std::vector<std::uint16_t> numbers;
    const auto next = [&](const char* method) {
        ItemWriter item = to.item(tags::kVolumeCropping, numbers.size());
        numbers.push_back(std::uint16_t(numbers.size() + 1));
        item.word(tags::kCroppingNumber, numbers.back());
        item.text(tags::kCroppingMethod, method);
        return item;
    };
    for (const Box& box : cropping.boxes) {
        const glm::dvec3& a = box.low;
        const glm::dvec3& b = box.high;
        next("BOUNDING_BOX").numbers(tags::kBoundingBoxCrop, {a.x, a.y, a.z, b.x, b.y, b.z});
    }
    if (!cropping.planes.empty()) {
        ItemWriter item = next("OBLIQUE_PLANES");
        for (std::size_t i = 0; i < cropping.planes.size(); ++i) {
            const CroppingPlane& plane = cropping.planes[i];
            const glm::dvec3& n = plane.outward;
            ItemWriter made = item.item(tags::kObliquePlanes, i);
            made.numbers(tags::kPlane, {n.x, n.y, n.z, -plane.offsetMm});
            point(made, tags::kPlaneNormal, n);
        }
    }
    to.words(tags::kGlobalCroppingIndex, ItemWriter::WordVr::us, numbers);
}

// C.11.28: the side of the patient that the camera is on, or oblique. Codes of SNOMED CT.
void writeViewDescription(ItemWriter to, const PresentedView& view) {
    struct Side {
        glm::dvec3 from;
        const char* code;
        const char* meaning;
    };
    static const std::array<Side, 6> kSides{{{{0, -1, 0}, "255549009", "Anterior"},
                                             {{0, 1, 0}, "255551008", "Posterior"},
                                             {{1, 0, 0}, "7771000", "Left"},
                                             {{-1, 0, 0}, "24028007", "Right"},
                                             {{0, 0, 1}, "264217000", "Superior"},
                                             {{0, 0, -1}, "261089000", "Inferior"}}};
    constexpr double kAligned = 0.9998;  // the cosine of a degree
    const glm::dvec3 from = glm::normalize(view.positionMm - view.lookAtMm);
    const auto side =
        std::ranges::find_if(kSides, [&](const Side& s) { return glm::dot(s.from, from) > kAligned; });
    ItemWriter code = to.item(tags::kViewCode, 0);
    code.text(tag::kCodeValue, side != kSides.end() ? side->code : "21114003");
    code.text(DCM_CodingSchemeDesignator, "SCT");
    code.text(DCM_CodeMeaning, side != kSides.end() ? side->meaning : "Oblique");
}

const char* nameOf(RenderingMethod method) {
    switch (method) {
        case RenderingMethod::volumeRendered:
            return "VOLUME_RENDERED";
        case RenderingMethod::maximum:
            return "MAXIMUM_IP";
        case RenderingMethod::minimum:
            return "MINIMUM_IP";
    }
    std::abort();
}

// C.11.30 and C.11.31.
void writeRendering(ItemWriter to, const VolumePresentation& p) {
    const PresentedView& view = p.view;
    to.text(tags::kRenderProjection,
            view.projection == Projection::perspective ? "PERSPECTIVE" : "ORTHOGRAPHIC");
    point(to, tags::kViewpointPosition, view.positionMm);
    point(to, tags::kViewpointLookAt, view.lookAtMm);
    point(to, tags::kViewpointUp, view.up);
    const FieldOfView& f = view.field;
    to.numbers(tags::kRenderFieldOfView, {f.leftMm, f.rightMm, f.topMm, f.bottomMm, f.nearMm, f.farMm});
    to.text(tags::kRenderingMethod, nameOf(p.method));
    if (p.samplingStepMm) to.numbers(tags::kSamplingStepSize, {*p.samplingStepMm});
    if (!p.shading) return;
    const PresentedShading& s = *p.shading;
    to.text(tags::kShadingStyle, s.isDoubleSided ? "DOUBLESIDED" : "SINGLESIDED");
    to.numbers(tags::kAmbient, {s.ambient});
    point(to, tags::kLightDirection, s.lightDirection);
    to.numbers(tags::kDiffuse, {s.diffuse});
    to.numbers(tags::kSpecular, {s.specular});
    if (s.shininess) to.numbers(tags::kShininess, {*s.shininess});
}

// C.11.32.
void writeDisplay(ItemWriter to, const Palette& palette) {
    to.text(tags::kPixelPresentation, "TRUE_COLOR");
    ItemWriter component = to.item(tags::kVolumeStreams, 0).item(tags::kClassification, 0);
    component.text(tags::kComponentType, "ONE_TO_RGBA");
    component.item(tags::kComponentInputs, 0).word(tags::kInputIndex, 1);
    const auto table = [&](Tag descriptor, Tag data, const std::vector<std::uint16_t>& entries) {
        const std::array<std::uint16_t, 3> format{
            std::uint16_t(entries.size() == kMostEntries ? 0 : entries.size()), 0, 16};
        component.words(descriptor, ItemWriter::WordVr::us, format);
        component.words(data, ItemWriter::WordVr::ow, entries);
    };
    component.text(tags::kRgbLutTransferFunction, palette.red.empty() ? "EQUAL_RGB" : "TABLE");
    if (!palette.red.empty()) {
        table(tags::kRedDescriptor, tags::kRedData, palette.red);
        table(tags::kGreenDescriptor, tags::kGreenData, palette.green);
        table(tags::kBlueDescriptor, tags::kBlueData, palette.blue);
    }
    component.text(tags::kAlphaLutTransferFunction, palette.alpha.empty() ? "IDENTITY" : "TABLE");
    if (!palette.alpha.empty()) table(tags::kAlphaDescriptor, tags::kAlphaData, palette.alpha);
    to.bytes(tags::kIccProfile, srgbProfile());
    to.text(tags::kColorSpace, "SRGB");
}

// The range as it is read back from the text of its window.
ValueRange asWritten(const ValueRange& values) {
    const auto centre = parseNumber<double>(decimalString(0.5 * (values.low + values.high)));
    const auto width = parseNumber<double>(decimalString(values.high - values.low));
    if (!centre || !width) return values;  // cannot happen: check() refuses numbers that are not finite
    return {*centre - 0.5 * *width, *centre + 0.5 * *width};
}

}  // namespace

Result<void> writePresentationState(const fs::path& path, const VolumePresentation& presentation,
                                    const NewObject& object) {
    MACULA_TRY_VOID(check(presentation, object));
    const ObjectKind kind{.modality = "PR",
                          .sopClassUid = sop_class::kVolumePresentationState,
                          .seriesNumber = 9100,
                          .seriesDescription = "3D views",
                          .needsUtf8 = false};
    return writeObject(path, object, kind, [&](ItemWriter to, const InstallationKey* standIns) {
        VolumePresentation written = presentation;
        written.palette.values = asWritten(presentation.palette.values);
        if (standIns != nullptr) written.series = withStandIns(std::move(written.series), *standIns);
        writeIdentification(to, written);
        writeRelationship(to, written);
        writeCropping(to, written.cropping);
        writeViewDescription(to, written.view);
        writeRendering(to, written);
        writeDisplay(to, written.palette);
        if (!written.ownState.empty()) writeOwnBlock(to, written.ownState, digestOf(written));
    });
}

}  // namespace macula::dicom
