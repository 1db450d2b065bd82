#include "scene/drawing/drawing_of.h"

#include <string>
#include <utility>
#include <vector>

#include "scene/clip/eye_cut.h"
#include "scene/transfer/own_copy.h"

namespace macula::scene {

namespace {

template <class Of>
Text numberText(const ParameterOf<Of>& p, const Of& of) {
    const Text label = Text::of(p.label, {});
    return p.unit.empty() ? Text("{} {:g}", label, p.get(of))
                          : Text("{} {:g} {}", label, p.get(of), Text::of(p.unit, {}));
}

// Adds a remark on each number of matter in which an edited preset differs from the preset that it was copied
// from. A preset that is not a copy gets no remark: its numbers are its own.
void addMatter(std::vector<Text>& remarks, const TransferFunction& preset, const Catalogue& catalogue) {
    const std::string from = copiedFrom(preset);
    if (from.empty()) return;
    const Result<std::shared_ptr<const TransferFunction>> original = findPreset(catalogue, from);
    if (!original) return;
    for (const MatterParameter& p : matterParameters()) {
        if (p.unit == "per mm") continue;  // widening the curves changes a gradient too
        if (p.get(preset) != p.get(**original)) remarks.push_back(numberText(p, preset));
    }
}

}  // namespace

trace::Settings settingsOf(const StudyState& state, const SeriesWindows& seriesWindows,
                           const Volume* volume) {
    trace::Settings settings = state.settings;
    const bool isShaded = settings.look == trace::Look::dvr && state.preset && state.preset->lighting.shade &&
                          settings.shading == trace::Shading::headlight;
    settings.shading = isShaded ? trace::Shading::headlight : trace::Shading::none;
    if (trace::isProjection(settings.look) && volume != nullptr) {
        const auto& set = state.windows.at(std::size_t(settings.look));
        settings.window = set ? *set : seriesWindows.of(settings.look, *volume);
    }
    return settings;
}

Drawing drawingOf(const StudyState& state, const Catalogue& catalogue, const SeriesWindows& seriesWindows,
                  const std::shared_ptr<const Volume>& volume, std::shared_ptr<const Clip> clip) {
    const trace::Look look = state.settings.look;
    Drawing drawing{.transferFunction = state.preset,
                    .lights = state.lights ? state.lights : defaultLights(catalogue, look),
                    .clip = std::move(clip),
                    .settings = settingsOf(state, seriesWindows, volume.get()),
                    .background = state.background};
    std::vector<Text> remarks;
    if (drawing.settings.shading == trace::Shading::headlight) remarks.push_back(Text("shaded"));
    if (trace::isProjection(look) && volume)
        remarks.push_back(Text::verbatim(windowText(*drawing.settings.window, volume->unitName())));
    for (const Parameter& p : parameters()) {
        if (p.get(state.settings) != p.fallback()) remarks.push_back(numberText(p, state.settings));
    }
    if (state.settings.toneMap == trace::ToneMap::hue && !trace::isProjection(look))
        remarks.push_back(Text("hues kept"));
    if (state.preset && trace::isPathTraced(look)) addMatter(remarks, *state.preset, catalogue);
    if (drawing.clip && drawing.clip->mask)
        remarks.push_back(drawing.clip->mask->remark.empty() ? Text("masked") : drawing.clip->mask->remark);
    if (drawing.clip && drawing.clip->hasShape()) remarks.push_back(Text("clipped"));
    drawing.remarks = Text::joined(std::move(remarks), ", ");
    return drawing;
}

Text remarkOf(const Additions& additions, trace::Look look) {
    return trace::isProjection(look) ? Text() : additions.remark;
}

void setAdditions(Drawing& drawing, std::shared_ptr<const Additions> additions) {
    drawing.additions = std::move(additions);
    if (!drawing.additions) return;
    drawing.remarks =
        Text::joined({std::move(drawing.remarks), remarkOf(*drawing.additions, drawing.settings.look)}, ", ");
}

std::shared_ptr<const Clip> clipOf(const StudyState& state, const Volume& volume, std::optional<Mask> mask) {
    Clip clip = clipFor(state.clip, state.cuts, volume);
    clip.mask = std::move(mask);
    return clip.isNothing() ? nullptr : std::make_shared<const Clip>(std::move(clip));
}

}  // namespace macula::scene
