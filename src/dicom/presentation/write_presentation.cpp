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

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/parsing.h"
#include "dicom/presentation/presentation_state.h"
#include "dicom/presentation/srgb_profile.h"
#include "dicom/read/presentation_tags.h"
#include "dicom/read/sop_class.h"
#include "dicom/stack/examination.h"
#include "dicom/write/decimal_string.h"
#include "dicom/write/item_writer.h"
#include "dicom/write/object_owner.h"
#include "dicom/write/uid.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::dicom {

namespace fs = std::filesystem;
namespace tags = presentation_tag;

namespace {

constexpr std::size_t kLongestLabel = 16;         // VR CS
constexpr std::size_t kLongestDescription = 64;   // VR LO
constexpr std::size_t kLongestOwnState = 200000;  // readers accept at most 256 KiB
constexpr std::size_t kMostEntries = 65536;
constexpr double kUnitLength = 1e-6;
constexpr double kFarthestMm = 1e9;

Error refused(Text message, Text hint) {
    return {ErrorCode::usage, std::move(message), {}, std::move(hint)};
}

bool isPlain(const std::string& text, std::size_t longest) {
    return text.size() <= longest &&
           std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~' && c != '\\'; });
}

bool isPoint(const glm::dvec3& p) {
    return std::abs(p.x) <= kFarthestMm && std::abs(p.y) <= kFarthestMm && std::abs(p.z) <= kFarthestMm;
}
bool isUnitVector(const glm::dvec3& v) {
    return std::abs(glm::length(v) - 1.0) <= kUnitLength;
}
bool isPart(double part) {
    return part >= 0.0 && part <= 1.0;
}

Result<void> checkTexts(const VolumePresentation& p, const PresentationOwner& owner) {
    const bool isLabel =
        !p.label.empty() && p.label.size() <= kLongestLabel && std::ranges::all_of(p.label, [](char c) {
            return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' || c == '_';
        });
    if (!isLabel)
        return refused(Text("The label of the presentation state is not usable."),
                       Text("Take 1 to 16 capital letters, digits, blanks and underscores."));
    if (!isPlain(p.description, kLongestDescription) ||
        !isPlain(owner.seriesDescription, kLongestDescription) || owner.softwareVersion.empty() ||
        !isPlain(owner.softwareVersion, kLongestDescription))
        return refused(Text("The description is too long, or has characters that it may not have."),
                       Text("Take at most 64 letters, digits and signs, without a backslash."));
    if (p.ownState.size() > kLongestOwnState ||
        !std::ranges::all_of(p.ownState, [](char c) { return (c >= ' ' && c <= '~') || c == '\n'; }))
        return refused(Text("The view is too large for a presentation state."),
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
    return refused(Text("The colours of the presentation state are not usable."),
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
        return refused(Text("The camera of the presentation state is not usable."),
                       Text("Choose another view."));
    for (const Box& box : p.cropping.boxes) {
        if (!isPoint(box.low) || !isPoint(box.high))
            return refused(Text("The clip of the presentation state is not usable."),
                           Text("Choose another clip."));
    }
    for (const CroppingPlane& plane : p.cropping.planes) {
        if (!isUnitVector(plane.outward) || !(std::abs(plane.offsetMm) <= kFarthestMm))
            return refused(Text("The clip of the presentation state is not usable."),
                           Text("Choose another clip."));
    }
    if (p.samplingStepMm && !(*p.samplingStepMm > 0.0 && *p.samplingStepMm <= kFarthestMm))
        return refused(Text("The opacities of the presentation state are not usable."),
                       Text("Choose another preset."));
    if (!p.shading) return {};
    const PresentedShading& s = *p.shading;
    if (isPart(s.ambient) && isPart(s.diffuse) && isPart(s.specular) && isPart(s.shininess.value_or(0.0)) &&
        isUnitVector(s.lightDirection))
        return {};
    return refused(Text("The shading of the presentation state is not usable."),
                   Text("Choose another preset."));
}

Result<void> check(const VolumePresentation& p, const PresentationOwner& owner) {
    MACULA_TRY_VOID(checkTexts(p, owner));
    MACULA_TRY_VOID(checkPalette(p.palette));
    MACULA_TRY_VOID(checkGeometry(p));
    const auto isUid = [](const std::string& uid) {
        return !uid.empty() && uid.size() <= 64 && uid.find_first_not_of("0123456789.") == std::string::npos;
    };
    const PresentedSeries& series = p.series;
    if (series.images.empty() || !isUid(series.seriesInstanceUid) || !isUid(series.frameOfReferenceUid) ||
        !std::ranges::all_of(series.images, [&](const ReferencedImage& image) {
            return isUid(image.sopClassUid) && isUid(image.sopInstanceUid);
        }))
        return refused(Text("A presentation state refers to DICOM images with a frame of reference, and this "
                            "volume has none."),
                       Text("Save it as a view."));
    if (!owner.image && !owner.isDeidentified)
        return refused(Text("The files of this study do not say which patient and which study it is."),
                       Text("Write the presentation state without patient and study."));
    return {};
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

void writeSeries(ItemWriter to, const VolumePresentation& p, const PresentationOwner& owner) {
    to.text(DCM_Modality, "PR");
    to.text(DCM_SeriesInstanceUID, newUid());
    to.text(DCM_SeriesNumber, std::to_string(owner.seriesNumber));
    to.text(DCM_SeriesDescription, owner.seriesDescription);
    to.text(DCM_FrameOfReferenceUID, p.series.frameOfReferenceUid);
    to.text(DCM_PositionReferenceIndicator, "");
    to.text(DCM_Manufacturer, "Macula");
    to.text(DCM_ManufacturerModelName, "Macula");
    to.text(DCM_DeviceSerialNumber, "0");  // a program has none
    to.text(DCM_SoftwareVersions, owner.softwareVersion);
}

void writeIdentification(ItemWriter to, const VolumePresentation& p) {
    const Now now;
    to.text(DCM_SOPClassUID, std::string(sop_class::kVolumePresentationState));
    to.text(DCM_SOPInstanceUID, newUid());
    to.text(DCM_InstanceCreationDate, now.date);
    to.text(DCM_InstanceCreationTime, now.time);
    to.text(DCM_InstanceNumber, "1");
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
                                    const PresentationOwner& owner) try {
    MACULA_TRY_VOID(check(presentation, owner));
    const QuietToolkit quiet;
    const Error failed{ErrorCode::outputNotWritable, Text("The DICOM file could not be written."),
                       path.string(), Text("Check free space and permissions.")};
    DcmFileFormat format;
    DcmDataset& dataset = *format.getDataset();
    VolumePresentation written = presentation;
    written.palette.values = asWritten(presentation.palette.values);
    bool ok = true;
    if (owner.isDeidentified) {
        MACULA_TRY(const InstallationKey key, InstallationKey::ofUser());
        ok = writePseudonym(dataset, owner.image).has_value();
        written.series = withStandIns(std::move(written.series), key);
    } else {
        if (const Result<Origin> origin = copyOwner(dataset, *owner.image); !origin) return origin.error();
    }
    ItemWriter to(dataset, ok);
    writeSeries(to, written, owner);
    writeIdentification(to, written);
    writeRelationship(to, written);
    writeCropping(to, written.cropping);
    writeViewDescription(to, written.view);
    writeRendering(to, written);
    writeDisplay(to, written.palette);
    if (!written.ownState.empty()) {
        writeOwnBlock(to, written.ownState, digestOf(written));
    }
    if (!ok) return failed;
    return writeAtomically(path, [&](const fs::path& draft) -> Result<void> {
        if (format.saveFile(draft.c_str(), EXS_LittleEndianExplicit).bad()) return failed;
        // DCMTK does not report that the last bytes are missing when the disk is full.
        if (examine(draft).state != FileState::complete) return failed;
        return {};
    });
} catch (const CheckFailure&) {
    throw;  // a bug in Macula, not a fault of the file
} catch (...) {
    return Error{ErrorCode::outputNotWritable, Text("The DICOM file could not be written."), path.string(),
                 Text("Check free space and memory.")};
}

}  // namespace macula::dicom
