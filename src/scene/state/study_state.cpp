#include "scene/state/study_state.h"

#include <algorithm>

#include "scene/second/second_curve.h"
#include "scene/transfer/same_transfer.h"

namespace macula::scene {

namespace {

// Whether two pointers, either of which may be null, point to the same value.
template <class T, class Same>
bool sameValue(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b, const Same& same) {
    return a == b || (a && b && same(*a, *b));
}
bool samePreset(const StudyState& a, const StudyState& b) {
    return sameValue(a.preset, b.preset,
                     [](const TransferFunction& x, const TransferFunction& y) { return isSame(x, y); });
}
bool sameLights(const StudyState& a, const StudyState& b) {
    return sameValue(a.lights, b.lights, std::equal_to<trace::LightRig>());
}

// The part of the second volume's state that affects the 3D picture; nothing if it is not shown there.
std::optional<SecondVolumeState> secondIn3dOf(const StudyState& state) {
    if (!state.secondVolume || !isSecondIn3d(*state.secondVolume)) return std::nullopt;
    return secondPartIn3d(*state.secondVolume);
}

// The settings with defaults for all parameters(), and for fields that are not part of a state.
trace::Settings withoutParameters(trace::Settings settings) {
    const trace::Settings usual;
    for (const Parameter& p : parameters()) p.set(settings, p.fallback());
    settings.seed = usual.seed;
    settings.errorThreshold = usual.errorThreshold;
    settings.window = usual.window;
    settings.denoising = usual.denoising;
    settings.toneMap = usual.toneMap;
    return settings;
}

Stale staleAfter(const trace::Settings& before, const trace::Settings& after) {
    Stale stale = Stale::nothing;
    for (const Parameter& p : parameters()) {
        if (p.get(before) != p.get(after)) stale = std::max(stale, p.stale);
    }
    if (before.denoising != after.denoising || before.toneMap != after.toneMap)
        stale = std::max(stale, Stale::display);
    if (!(withoutParameters(before) == withoutParameters(after))) stale = std::max(stale, Stale::light);
    return stale;
}

constexpr double kSamePlaceMm = 0.01;

}  // namespace

bool SecondVolumeState::operator==(const SecondVolumeState& b) const {
    return seriesDigest == b.seriesDigest && volume == b.volume && volumeKey == b.volumeKey &&
           pair == b.pair && link == b.link && secondFromStudy == b.secondFromStudy && boundMm == b.boundMm &&
           isDoubtful == b.isDoubtful && rivalMm == b.rivalMm && view == b.view && window == b.window &&
           linksWindow == b.linksWindow && opacity == b.opacity && colours == b.colours && in3d == b.in3d &&
           isodoses == b.isodoses &&
           sameValue(preset, b.preset,
                     [](const TransferFunction& x, const TransferFunction& y) { return isSame(x, y); });
}

bool StudyState::operator==(const StudyState& b) const {
    return seriesDigest == b.seriesDigest && grid == b.grid && samePreset(*this, b) && clip == b.clip &&
           leavesTableOut == b.leavesTableOut && sameLights(*this, b) && settings == b.settings &&
           windows == b.windows && camera == b.camera && showsMarks == b.showsMarks &&
           background == b.background && layout == b.layout && slices == b.slices &&
           measurements == b.measurements && cuts == b.cuts && namedClips == b.namedClips &&
           segmentations == b.segmentations && secondVolume == b.secondVolume && otherKeys == b.otherKeys;
}

Stale staleAfter(const StudyState& before, const StudyState& after) {
    if (before.seriesDigest != after.seriesDigest) return Stale::volume;
    if (!samePreset(before, after) || before.clip != after.clip || before.cuts != after.cuts ||
        before.leavesTableOut != after.leavesTableOut ||
        in3dOf(before.segmentations) != in3dOf(after.segmentations) ||
        colouredIn3dOf(before.segmentations) != colouredIn3dOf(after.segmentations) ||
        secondIn3dOf(before) != secondIn3dOf(after))
        return Stale::matter;
    Stale stale = staleAfter(before.settings, after.settings);
    if (!sameLights(before, after)) stale = std::max(stale, Stale::light);
    if (before.camera != after.camera) stale = std::max(stale, Stale::camera);
    if (before.windows != after.windows || before.background != after.background)
        stale = std::max(stale, Stale::display);
    return stale;
}

Result<void> checkSeries(const StudyState& state, std::string_view seriesDigest, const Volume& volume,
                         const std::string& where) {
    if (state.seriesDigest.empty()) return {};
    if (state.seriesDigest != seriesDigest)
        return Error{ErrorCode::inputNotUsable, Text("The view was saved of another series."), where,
                     Text("Open that series, or choose another view.")};
    if (state.grid && !liesAt(volume, *state.grid))
        return Error{ErrorCode::inputNotUsable,
                     Text("The view was saved when the images lay in other places, or of another volume of "
                          "the series."),
                     where,
                     Text("Make it anew; or choose the volume that it is of. Without \"grid\" in the file it "
                          "is taken as it is.")};
    return {};
}

SavedGrid savedGridOf(const Volume& volume) {
    return {.size = volume.size(), .worldFromVoxel = volume.worldFromVoxel()};
}

bool liesAt(const Volume& volume, const SavedGrid& grid) {
    if (volume.size() != grid.size) return false;
    // Both maps are affine: what agrees at four corners agrees between them.
    const glm::dvec3 last(grid.size - 1);
    for (const glm::dvec3& corner :
         {glm::dvec3(0.0), glm::dvec3(last.x, 0, 0), glm::dvec3(0, last.y, 0), glm::dvec3(0, 0, last.z)}) {
        const glm::dvec3 apart =
            transformPoint(volume.worldFromVoxel(), corner) - transformPoint(grid.worldFromVoxel, corner);
        if (!(glm::length(apart) <= kSamePlaceMm)) return false;
    }
    return true;
}

}  // namespace macula::scene
