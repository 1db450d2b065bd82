
#include <algorithm>
#include <cmath>
#include <new>
#include <string_view>
#include <utility>

#include "base/sha256.h"
#include "dicom/messages/messages.h"
#include "dicom/presentation/palette_tables.h"
#include "dicom/presentation/presentation_state.h"
#include "dicom/presentation/srgb_profile.h"
#include "dicom/read/dataset.h"
#include "dicom/read/presentation_tags.h"
#include "dicom/read/referenced_frames.h"
#include "dicom/read/sop_class.h"
#include "dicom/write/uid.h"

namespace macula::dicom {

namespace fs = std::filesystem;
namespace tags = presentation_tag;

namespace {

// Reads one object, and notes what a VolumePresentation cannot hold.
class Reader {
  public:
    Reader(const Dataset& file, std::string where) : file_(file), where_(std::move(where)) {}

    Result<PresentationState> read() {
        VolumePresentation& p = state_.presentation;
        p.label = file_.text(tags::kContentLabel).value_or("");
        p.description = file_.text(tags::kContentDescription).value_or("");
        p.creationDate = file_.text(tags::kCreationDate).value_or("");
        p.creationTime = file_.text(tags::kCreationTime).value_or("");
        MACULA_TRY_VOID(readStream());
        MACULA_TRY_VOID(readInput());
        MACULA_TRY(p.view, view());
        MACULA_TRY_VOID(readMethod());
        MACULA_TRY(p.palette, palette());
        MACULA_TRY_VOID(readCropping());
        readShading();
        noteTheRest();
        readOwnState();
        return std::move(state_);
    }

  private:
    Error notUsable(Text message) const {
        return {ErrorCode::inputNotUsable, std::move(message), where_,
                Text("Copy the file again from its source, or choose another presentation state.")};
    }
    void leftOut(Text what) {
        state_.messages.push_back(message(key::kPresentationLeftOut, {{"what", std::move(what)}}));
    }
    void approximated(Text what, Text how) {
        state_.messages.push_back(
            message(key::kPresentationApproximated, {{"what", std::move(what)}, {"how", std::move(how)}}));
    }

    // Reads the first of several streams.
    Result<void> readStream() {
        const std::vector<Dataset> streams = file_.items(tags::kVolumeStreams);
        if (streams.empty()) return notUsable(Text("The presentation state does not say in which colours."));
        stream_ = streams.front();
        const std::vector<Dataset> components = stream_->items(tags::kClassification);
        if (components.empty())
            return notUsable(Text("The presentation state does not say in which colours."));
        component_ = components.front();
        if (streams.size() > 1 || !file_.items(tags::kCompositor).empty() ||
            !stream_->items(tags::kCompositor).empty())
            leftOut(Text("several volumes blended into one picture"));
        const std::vector<Dataset> inputs = component_->items(tags::kComponentInputs);
        if (components.size() > 1 || inputs.size() > 1) leftOut(Text("colours of more than one input"));
        if (!inputs.empty()) inputNumber_ = inputs.front().integer(tags::kInputIndex);
        return {};
    }

    Result<void> readInput() {
        const std::vector<Dataset> inputs = file_.items(tags::kInputs);
        if (inputs.empty())
            return notUsable(Text("The presentation state does not say which images it is of."));
        if (inputs.size() > 1) leftOut(Text("more than one input"));
        const auto meant = std::ranges::find_if(inputs, [&](const Dataset& input) {
            return inputNumber_ && input.integer(tags::kInputNumber) == inputNumber_;
        });
        input_ = meant != inputs.end() ? *meant : inputs.front();
        const std::vector<Dataset> sets = file_.items(tags::kInputSets);
        const auto uid = input_->text(tags::kInputSetUid);
        const auto set = std::ranges::find_if(
            sets, [&](const Dataset& s) { return uid && s.text(tags::kInputSetUid) == uid; });
        if (set == sets.end())
            return notUsable(Text("The presentation state does not say which images it is of."));
        if (set->text(tags::kInputType) != "VOLUME")
            return notUsable(Text("The presentation state is of something that is no volume."));
        if (sets.size() > 1 && inputs.size() == 1) leftOut(Text("more than one set of images"));
        if (!set->items(tags::kReferencedRegistration).empty())
            leftOut(Text("a registration to another frame of reference"));
        if (input_->has(tags::kInputSequencePositionIndex)) leftOut(Text("a sequence of volumes in time"));
        return readSeries(*set);
    }

    Result<void> readSeries(const Dataset& set) {
        PresentedSeries& series = state_.presentation.series;
        bool isDamaged = false;
        for (const Dataset& item : set.items(tags::kReferencedImages)) {
            for (ReferencedFrames& image : referencedFrames({item})) {
                isDamaged = isDamaged || image.isDamaged;
                series.images.push_back({item.text(tags::kReferencedSopClassUid).value_or(""),
                                         std::move(image.sopInstanceUid), std::move(image.numbers)});
            }
        }
        if (isDamaged) leftOut(Text("an unreadable list of frames"));
        series.frameOfReferenceUid = file_.text(tag::kFrameOfReferenceUid).value_or("");
        std::vector<Dataset> all = file_.items(tag::kReferencedSeries);
        for (const Dataset& study : file_.items(tags::kStudiesContainingOtherInstances)) {
            for (const Dataset& item : study.items(tag::kReferencedSeries)) all.push_back(item);
        }
        if (series.images.empty() || all.empty())
            return notUsable(Text("The presentation state does not say which images it is of."));
        const auto holdsFirst = [&](const Dataset& item) {
            return std::ranges::any_of(item.items(tags::kReferencedInstances), [&](const Dataset& instance) {
                return instance.text(tags::kReferencedSopInstanceUid) == series.images.front().sopInstanceUid;
            });
        };
        const auto holder = std::ranges::find_if(all, holdsFirst);
        const Dataset& meant = holder != all.end() ? *holder : all.front();
        series.seriesInstanceUid = meant.text(tag::kSeriesInstanceUid).value_or("");
        if (series.seriesInstanceUid.empty())
            return notUsable(Text("The presentation state does not say which series it is of."));
        return {};
    }

    std::optional<glm::dvec3> point(const Dataset& from, Tag tag) const {
        const auto xyz = from.numbers(tag, 3);
        if (!xyz) return {};
        return glm::dvec3((*xyz)[0], (*xyz)[1], (*xyz)[2]);
    }

    Result<PresentedView> view() const {
        const Error missing = notUsable(Text("The presentation state does not say where it is looked from."));
        const auto position = point(file_, tags::kViewpointPosition);
        const auto lookAt = point(file_, tags::kViewpointLookAt);
        const auto up = point(file_, tags::kViewpointUp);
        const auto field = file_.numbers(tags::kRenderFieldOfView, 6);
        const auto projection = file_.text(tags::kRenderProjection);
        if (!position || !lookAt || !up || !field) return missing;
        if (projection != "PERSPECTIVE" && projection != "ORTHOGRAPHIC") return missing;
        const std::vector<double>& f = *field;
        if (!(f[0] < f[1]) || f[2] == f[3] || !(f[4] < f[5]) || !(f[5] > 0.0)) return missing;
        return PresentedView{
            .projection = projection == "PERSPECTIVE" ? Projection::perspective : Projection::orthographic,
            .positionMm = *position,
            .lookAtMm = *lookAt,
            .up = *up,
            // Some writers have y downwards.
            .field = {f[0], f[1], std::max(f[2], f[3]), std::min(f[2], f[3]), f[4], f[5]}};
    }

    Result<void> readMethod() {
        VolumePresentation& p = state_.presentation;
        const std::string method = file_.text(tags::kRenderingMethod).value_or("VOLUME_RENDERED");
        if (method == "MAXIMUM_IP") {
            p.method = RenderingMethod::maximum;
        } else if (method == "MINIMUM_IP") {
            p.method = RenderingMethod::minimum;
        } else if (method != "VOLUME_RENDERED") {
            return notUsable(Text("The presentation state is drawn by a method that Macula does not know."));
        }
        const auto step = file_.number(tags::kSamplingStepSize);
        if (step && *step > 0.0) p.samplingStepMm = *step;
        return {};
    }

    // The interval of the window, PS3.3 C.11.2.1.2 and C.11.2.1.3.2; nothing without one.
    std::optional<ValueRange> windowRange() {
        const std::vector<double> centres = input_->shortNumbers(tags::kWindowCenter);
        const std::vector<double> widths = input_->shortNumbers(tags::kWindowWidth);
        if (centres.empty() || widths.empty()) return {};
        double centre = centres.front();
        double width = widths.front();
        const std::string function = input_->text(tags::kVoiLutFunction).value_or("LINEAR");
        if (function == "LINEAR") {
            centre -= 0.5;
            width -= 1.0;
        } else if (function != "LINEAR_EXACT") {
            approximated(Text("a window that is no straight line"), Text("a straight one is shown"));
        }
        const ValueRange range{centre - 0.5 * width, centre + 0.5 * width};
        return range.low < range.high ? std::optional(range) : std::nullopt;
    }

    Result<Palette> palette() {
        const Error damaged = notUsable(Text("The colours of the presentation state are damaged."));
        const std::string colours = component_->text(tags::kRgbLutTransferFunction).value_or("");
        const std::string alphas = component_->text(tags::kAlphaLutTransferFunction).value_or("");
        Palette palette;
        int first = 0;
        const auto read = [&](Tag descriptor, Tag data, Tag segmented, std::vector<std::uint16_t>& into) {
            auto table = readPaletteTable(*component_, descriptor, data, segmented);
            if (!table) return false;
            first = table->firstValue;
            into = std::move(table->values);
            return true;
        };
        if (colours == "TABLE") {
            if (!read(tags::kRedDescriptor, tags::kRedData, tags::kSegmentedRed, palette.red) ||
                !read(tags::kGreenDescriptor, tags::kGreenData, tags::kSegmentedGreen, palette.green) ||
                !read(tags::kBlueDescriptor, tags::kBlueData, tags::kSegmentedBlue, palette.blue))
                return damaged;
        } else if (colours != "EQUAL_RGB") {
            return damaged;
        }
        if (alphas == "TABLE") {
            if (!read(tags::kAlphaDescriptor, tags::kAlphaData, tags::kSegmentedAlpha, palette.alpha))
                return damaged;
        } else if (alphas == "NONE") {
            palette.alpha.assign(std::max<std::size_t>(palette.red.size(), 2), 65535);
        } else if (alphas != "IDENTITY") {
            return damaged;
        }
        const std::size_t entries = std::max(palette.red.size(), palette.alpha.size());
        if (palette.red.size() != palette.green.size() || palette.red.size() != palette.blue.size() ||
            (!palette.red.empty() && !palette.alpha.empty() && palette.red.size() != palette.alpha.size()))
            return damaged;
        if (!input_->items(tags::kVoiLutSequence).empty())
            return notUsable(
                Text("The presentation state has a table of values (VOI LUT) before its colours, "
                     "which Macula does not know."));
        if (const auto range = windowRange()) {
            palette.values = *range;
        } else if (entries >= 2 && alphas != "NONE") {
            palette.values = {double(first), double(first) + double(entries - 1)};
        } else {
            return notUsable(Text("The presentation state does not say which values its colours are of."));
        }
        noteColourSpace();
        return palette;
    }

    void noteColourSpace() {
        const auto space = file_.text(tags::kColorSpace);
        if (space == "SRGB") return;
        const std::vector<std::uint16_t> profile = file_.words(tags::kIccProfile);
        if (space || !profile.empty())
            approximated(Text("colours of another space"), Text("they are shown as sRGB"));
    }

    Result<void> readCropping() {
        std::vector<double> wanted;
        if (file_.text(tags::kGlobalCrop) == "YES") wanted = file_.shortNumbers(tags::kGlobalCroppingIndex);
        if (input_->text(tags::kCrop) == "YES") {
            for (const double number : input_->shortNumbers(tags::kCroppingIndex)) wanted.push_back(number);
        }
        const std::vector<Dataset> items = file_.items(tags::kVolumeCropping);
        for (const double number : wanted) {
            const auto item = std::ranges::find_if(
                items, [&](const Dataset& i) { return i.number(tags::kCroppingNumber) == number; });
            if (item == items.end())
                return notUsable(Text("A clip of the presentation state is missing in the file."));
            MACULA_TRY_VOID(readCrop(*item));
        }
        return {};
    }

    Result<void> readCrop(const Dataset& item) {
        const Error damaged = notUsable(Text("A clip of the presentation state is damaged."));
        Cropping& cropping = state_.presentation.cropping;
        const std::string method = item.text(tags::kCroppingMethod).value_or("");
        if (method == "BOUNDING_BOX") {
            const auto corners = item.numbers(tags::kBoundingBoxCrop, 6);
            if (!corners) return damaged;
            const std::vector<double>& c = *corners;
            cropping.boxes.push_back({{c[0], c[1], c[2]}, {c[3], c[4], c[5]}});
            return {};
        }
        if (method == "INCLUDE_SEG" || method == "EXCLUDE_SEG") {
            leftOut(Text("a clip by a segmentation"));
            return {};
        }
        const std::vector<Dataset> planes = item.items(tags::kObliquePlanes);
        if (!method.starts_with("OBLIQUE") || planes.empty()) return damaged;
        for (const Dataset& plane : planes) {
            const auto read = planeOf(plane);
            if (!read) return damaged;
            cropping.planes.push_back(*read);
        }
        return {};
    }

    // Ax + By + Cz + D = 0, with any scale and sign, gives the place; the normal gives the side that is cut
    // off.
    std::optional<CroppingPlane> planeOf(const Dataset& item) const {
        const auto equation = item.numbers(tags::kPlane, 4);
        const auto normal = point(item, tags::kPlaneNormal);
        if (!equation || !normal) return {};
        const glm::dvec3 abc((*equation)[0], (*equation)[1], (*equation)[2]);
        const double d = (*equation)[3];
        if (abc == *normal && std::abs(glm::length(abc) - 1.0) <= 1e-6) return CroppingPlane{abc, -d};
        const double length = glm::length(abc);
        const double along = glm::dot(abc, *normal);
        if (!(length > 0.0) || along == 0.0 || !std::isfinite(length)) return {};
        const double scale = (along > 0.0 ? 1.0 : -1.0) / length;
        return CroppingPlane{abc * scale, -d * scale};
    }

    void readShading() {
        if (!file_.has(tags::kShadingStyle) && !file_.has(tags::kAmbient)) return;
        PresentedShading shading{.isDoubleSided = file_.text(tags::kShadingStyle) != "SINGLESIDED",
                                 .ambient = file_.number(tags::kAmbient).value_or(-1.0),
                                 .diffuse = file_.number(tags::kDiffuse).value_or(0.0),
                                 .specular = file_.number(tags::kSpecular).value_or(0.0),
                                 .shininess = file_.number(tags::kShininess)};
        if (const auto light = point(file_, tags::kLightDirection)) shading.lightDirection = *light;
        const auto isPart = [](double part) { return part >= 0.0 && part <= 1.0; };
        if (isPart(shading.ambient) && isPart(shading.diffuse) && isPart(shading.specular) &&
            isPart(shading.shininess.value_or(0.0)) && glm::length(shading.lightDirection) > 0.0) {
            state_.presentation.shading = shading;
        } else {
            leftOut(Text("shading with numbers that are not 0 to 1"));
        }
    }

    void noteTheRest() {
        if (file_.has(tags::kAnimationStyle)) leftOut(Text("an animation"));
        if (!file_.items(tags::kGraphicAnnotations).empty() ||
            !file_.items(tags::kVolumetricAnnotations).empty())
            leftOut(Text("drawings or texts over the picture"));
    }

    void readOwnState() {
        if (file_.text(tags::kPrivateBlock) != tags::kPrivateCreator) return;
        std::string own;
        for (const std::uint16_t two : file_.words(tags::kOwnState)) {
            own.push_back(static_cast<char>(two & 0xFFu));
            own.push_back(static_cast<char>(two >> 8));
        }
        own.erase(own.find_last_not_of(std::string_view(" \0", 2)) + 1);
        if (own.empty()) return;
        if (state_.messages.empty() && file_.text(tags::kOwnStateDigest) == digestOf(state_.presentation)) {
            state_.presentation.ownState = std::move(own);
            return;
        }
        state_.hasForeignChanges = true;
        state_.messages.push_back(message(key::kPresentationChanged));
    }

    const Dataset& file_;
    const std::string where_;
    PresentationState state_;
    std::optional<Dataset> stream_;
    std::optional<Dataset> component_;  // the first of stream_
    std::optional<Dataset> input_;      // the input that the component maps
    std::optional<int> inputNumber_;
};

}  // namespace

Result<PresentationState> readPresentationState(const fs::path& path) try {
    const HeaderFile read = readHeader(path);
    const auto notUsable = [&](Text message, Text hint) {
        return Error{ErrorCode::inputNotUsable, std::move(message), path.string(), std::move(hint)};
    };
    if (read.state == FileState::unreadable)
        return notUsable(Text("The file cannot be read."), Text("Check the path and its permissions."));
    if (read.state == FileState::notDicom)
        return notUsable(Text("The file is not a DICOM presentation state."),
                         Text("Choose a file of the kind Volume Rendering Volumetric Presentation State."));
    if (!read.header)
        return notUsable(Text("The presentation state cannot be read."),
                         Text("Copy the file again from its source."));
    if (read.header->text(tag::kSopClassUid) != sop_class::kVolumePresentationState)
        return notUsable(Text("The file is no presentation state of one rendered volume."),
                         Text("Choose a file of the kind Volume Rendering Volumetric Presentation State."));
    return Reader(*read.header, path.string()).read();
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, Text("There is not enough memory for the presentation state."),
                 path.string(), Text("Close other programs.")};
}

bool isSeries(const PresentedSeries& series, std::string_view seriesDigest) {
    constexpr std::size_t kDigits = 64;
    if (seriesDigest.size() != kDigits ||
        seriesDigest.find_first_not_of("0123456789abcdef") != std::string_view::npos)
        return false;
    if (sha256Hex(series.seriesInstanceUid) == seriesDigest) return true;
    const std::vector<std::string> standIns = StandInUids().ofDigest(seriesDigest);
    return std::ranges::find(standIns, series.seriesInstanceUid) != standIns.end();
}

}  // namespace macula::dicom
