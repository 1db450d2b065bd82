#include "scene/presentation/state_of_presentation.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "dicom/write/uid.h"
#include "scene/presentation/cropping_clip.h"
#include "scene/presentation/palette_of_transfer.h"

namespace macula::scene {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kSmallest = 0.1;  // degrees, as base/camera.h
constexpr double kLargest = 170.0;
constexpr double kMostSpecularPower = 128.0;  // shininess 1

class Telling {
  public:
    Telling(const dicom::VolumePresentation& said, PresentedState& presented)
        : said_(said), presented_(presented) {}

    Result<void> tell(const std::string& where) {
        tellColours();
        const auto camera = cameraOf();
        if (!camera)
            return Error{ErrorCode::inputNotUsable,
                         Text("The camera of the presentation state is not usable."), where,
                         Text("Choose another presentation state.")};
        presented_.state.camera = *camera;
        return {};
    }

  private:
    void note(Text sentence) { presented_.notes.push_back(std::move(sentence)); }

    void tellColours() {
        StudyState& state = presented_.state;
        if (said_.method != dicom::RenderingMethod::volumeRendered) {
            const bool isMaximum = said_.method == dicom::RenderingMethod::maximum;
            state.settings.look = isMaximum ? trace::Look::mip : trace::Look::minip;
            const ValueRange& values = said_.palette.values;
            state.windows.at(std::size_t(state.settings.look)) =
                DisplayWindow{.center = 0.5 * (values.low + values.high),
                              .width = values.high - values.low,
                              .explanation = {},
                              .function = "LINEAR_EXACT"};
            if (!said_.palette.red.empty()) note(Text("The colours of this projection are shown as greys."));
            return;
        }
        state.settings.look = trace::Look::dvr;
        TransferFunction function = transferOf(said_.palette, said_.samplingStepMm.value_or(1.0));
        if (!said_.samplingStepMm)
            note(Text(
                "The presentation state does not say of which thickness its opacities are; 1 mm is taken."));
        function.name = "presentation-state";
        function.title = "Presentation state";
        tellShading(function);
        state.preset = std::make_shared<const TransferFunction>(std::move(function));
    }

    void tellShading(TransferFunction& function) {
        presented_.state.settings.shading = said_.shading ? trace::Shading::headlight : trace::Shading::none;
        function.lighting.shade = said_.shading.has_value();
        if (!said_.shading) return;
        const dicom::PresentedShading& shading = *said_.shading;
        function.lighting.ambient = shading.ambient;
        function.lighting.diffuse = shading.diffuse;
        function.lighting.specular = shading.specular;
        if (shading.shininess) function.lighting.specularPower = kMostSpecularPower * *shading.shininess;
        if (shading.specular > 0.0) note(Text("Highlights are not drawn."));
        if (!shading.isDoubleSided) note(Text("Surfaces are shaded from both sides."));
        const glm::dvec3 forward = said_.view.lookAtMm - said_.view.positionMm;
        const double along = glm::dot(forward, shading.lightDirection);
        if (shading.diffuse > 0.0 &&
            along < 0.9998 * glm::length(forward) * glm::length(shading.lightDirection))
            note(Text("Light comes from the viewer, and not from where the presentation state has it."));
    }

    std::optional<Camera> cameraOf() {
        const dicom::PresentedView& view = said_.view;
        const dicom::FieldOfView& field = view.field;
        Camera camera{.positionMm = view.positionMm, .targetMm = view.lookAtMm, .up = view.up};
        const auto axes = basis(camera);
        if (!axes) return {};
        if (view.projection == dicom::Projection::perspective) {
            const double half = std::max(field.topMm, -field.bottomMm);
            camera.verticalFovDeg = 2.0 * std::atan2(half, field.farMm) / kDegree;
            constexpr double kOff = 1e-6;
            presented_.widthOverHeight = std::max(field.rightMm, -field.leftMm) / half;
            if (std::abs(field.topMm + field.bottomMm) > kOff * half ||
                std::abs(field.leftMm + field.rightMm) > kOff * half)
                note(Text(
                    "The picture is larger than that of the presentation state, whose middle is not where it "
                    "looks at."));
        } else {
            camera.parallelHeightMm = field.topMm - field.bottomMm;
            presented_.widthOverHeight = (field.rightMm - field.leftMm) / camera.parallelHeightMm;
            const glm::dvec3 aside = 0.5 * (field.leftMm + field.rightMm) * axes->right +
                                     0.5 * (field.topMm + field.bottomMm) * axes->up;
            camera.targetMm += aside;
            camera.positionMm += aside;
        }
        if (!(camera.verticalFovDeg >= kSmallest && camera.verticalFovDeg <= kLargest)) return {};
        if (!basis(camera)) return {};
        return camera;
    }

    const dicom::VolumePresentation& said_;
    PresentedState& presented_;
};

// Whether the camera's near and far planes cut off a part of the volume, which Macula shows.
bool cutsByDepth(const dicom::PresentedView& view, const Volume& volume) {
    constexpr double kToleranceMm = 0.5;
    const glm::dvec3 forward = glm::normalize(view.lookAtMm - view.positionMm);
    return std::ranges::any_of(cornersOf(volume.worldBox()), [&](const glm::dvec3& corner) {
        const double depth = glm::dot(corner - view.positionMm, forward);
        // In perspective, nothing behind the eye is seen anyway.
        const bool isBefore = depth < view.field.nearMm - kToleranceMm &&
                              (depth > kToleranceMm || view.projection == dicom::Projection::orthographic);
        return isBefore || depth > view.field.farMm + kToleranceMm;
    });
}

enum class ImagesShown { all, some, none };

// How many of the images that the presentation refers to are in the open volume, even if one of both is
// deidentified.
ImagesShown imagesShown(const std::vector<dicom::ReferencedImage>& referenced,
                        std::span<const dicom::ReferencedFrames> images) {
    if (referenced.empty() || images.empty()) return ImagesShown::all;
    std::vector<dicom::ReferencedFrames> wanted;
    for (const dicom::ReferencedImage& image : referenced)
        wanted.push_back({.sopInstanceUid = image.sopInstanceUid, .numbers = image.frames});
    wanted = dicom::byImage(std::move(wanted));
    const auto find = [&](const std::string& uid) {
        const auto found =
            std::ranges::lower_bound(wanted, uid, {}, &dicom::ReferencedFrames::sopInstanceUid);
        return found != wanted.end() && found->sopInstanceUid == uid ? found : wanted.end();
    };
    const dicom::StandInUids standIns;
    std::size_t both = 0;
    bool areSame = true;
    for (const dicom::ReferencedFrames& image : images) {
        auto found = find(image.sopInstanceUid);
        if (found == wanted.end()) {
            for (const std::string& uid : standIns.of(image.sopInstanceUid))
                if (found == wanted.end()) found = find(uid);
        }
        // A single-frame file has frame 1.
        const std::vector<int> own = image.numbers.empty() ? std::vector{1} : image.numbers;
        const auto isMeant = [&](int number) { return found->holds(number - 1); };
        if (found == wanted.end() || std::ranges::none_of(own, isMeant)) {
            areSame = false;
            continue;
        }
        ++both;
        areSame = areSame && (found->numbers.empty() || found->numbers == own);
    }
    if (both == 0) return ImagesShown::none;
    return areSame && both == wanted.size() ? ImagesShown::all : ImagesShown::some;
}

}  // namespace

Result<PresentedState> stateOf(const dicom::PresentationState& read, StudyState usual,
                               const std::string& where) {
    PresentedState presented;
    for (const Message& message : read.messages) presented.notes.push_back(message.sentence);
    const dicom::VolumePresentation& said = read.presentation;
    if (!said.ownState.empty()) {
        if (auto own = studyStateFromJson(said.ownState, where)) {
            presented.state = *std::move(own);
            presented.isOwn = true;
            return presented;
        }
        presented.notes.push_back(
            Text("What a newer Macula has written cannot be read; the picture is as others show it."));
    }
    presented.state = std::move(usual);
    presented.state.clip.reset();
    presented.state.cuts = {};
    // Nothing that hides voxels in `usual` is part of the presentation.
    presented.state.leavesTableOut = false;
    presented.state.segmentations = onSlicesAlone(presented.state.segmentations);
    presented.state.seriesDigest.clear();
    MACULA_TRY_VOID(Telling(said, presented).tell(where));
    return presented;
}

Result<void> completeFor(PresentedState& presented, const dicom::PresentationState& read,
                         const Volume& volume, std::string_view seriesDigest,
                         std::span<const dicom::ReferencedFrames> images, const std::string& where) {
    const dicom::VolumePresentation& said = read.presentation;
    if (!isSeries(said.series, seriesDigest))
        return Error{ErrorCode::inputNotUsable, Text("The presentation state is of another series."), where,
                     Text("Open that series, or choose another presentation state.")};
    const auto shown = imagesShown(said.series.images, images);
    if (shown == ImagesShown::none)
        return Error{ErrorCode::inputNotUsable,
                     Text("The presentation state is of other images of this series, such as another phase."),
                     where, Text("Choose the volume of these images, or another presentation state.")};
    if (shown == ImagesShown::some)
        presented.notes.push_back(Text(
            "The presentation state is of other images of this series, too, or of a part of these alone."));
    StudyState& state = presented.state;
    state.seriesDigest = std::string(seriesDigest);
    if (presented.isOwn) return {};
    if (volume.unit() == Unit::suvBodyWeight)
        return Error{
            ErrorCode::inputNotUsable,
            Text("The presentation state is of the values of the images, and this PET is shown in SUV."),
            where, Text("Choose a preset or a window in SUV.")};
    if (said.method == dicom::RenderingMethod::volumeRendered) {
        TransferFunction function = *state.preset;
        function.unit = volume.unit();
        function.modalities = {volume.modality()};
        state.preset = std::make_shared<const TransferFunction>(std::move(function));
    }
    MACULA_TRY(state.clip, clipOf(said.cropping, volume, where));
    if (cutsByDepth(said.view, volume))
        presented.notes.push_back(Text("What lies before or behind the depth of its view is shown, too."));
    return {};
}

void widenFor(PresentedState& presented, double aspectWidthOverHeight) {
    auto& camera = presented.state.camera;
    if (presented.isOwn || !camera || !(aspectWidthOverHeight > 0.0)) return;
    const double wider = presented.widthOverHeight / aspectWidthOverHeight;
    constexpr double kAsWide = 1.0 + 1e-6;
    if (!std::isfinite(wider) || !(wider > kAsWide)) return;
    if (isParallel(*camera)) {
        camera->parallelHeightMm = std::min(wider * camera->parallelHeightMm, kMostParallelMm);
    } else {
        const double half = std::tan(0.5 * camera->verticalFovDeg * kDegree);
        camera->verticalFovDeg = std::min(2.0 * std::atan(wider * half) / kDegree, kLargest);
    }
}

Result<PresentedState> openPresentation(const std::filesystem::path& path, const Volume& volume,
                                        std::string_view seriesDigest,
                                        std::span<const dicom::ReferencedFrames> images, StudyState usual) {
    MACULA_TRY(const dicom::PresentationState read, dicom::readPresentationState(path));
    MACULA_TRY(PresentedState presented, stateOf(read, std::move(usual), path.string()));
    MACULA_TRY_VOID(completeFor(presented, read, volume, seriesDigest, images, path.string()));
    return presented;
}

}  // namespace macula::scene
