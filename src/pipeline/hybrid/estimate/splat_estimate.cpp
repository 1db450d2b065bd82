#include "pipeline/hybrid/estimate/splat_estimate.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "base/parallel.h"
#include "base/timeline.h"
#include "pipeline/splat/model/constant_colour.h"

namespace macula::hybrid {

namespace {

constexpr float kLeastExtinction = 1e-4f;  // per mm: 100 mm of it hide a hundredth
constexpr float kLeastOpacity = 0.01f;     // of a splat worth drawing
constexpr float kMostOpacity = 0.98f;
constexpr float kMostLearntOpacity = 0.9999f;
// A splat of haze gets no denser than this: where haze has become a surface, cells get splats of their own.
constexpr float kMostDenser = 8.0f;
// A surface that fills part of a cell hides what lies behind the whole of it.
constexpr float kDenser = 1.3f;
// A cell that receives less than this share of the light outside counts as invisible.
constexpr float kLeastOpenness = 0.03f;
// A cell is known if the model, when it learnt, saw more than this share of what is visible of it now.
constexpr float kKnownShare = 0.75f;
// A cell that the model's splats cover this far gets no new splat.
constexpr float kWhollyCovered = 0.75f;
// Below kDark, a splat's learnt colour does not count; above kBright, only it does.
constexpr float kDark = 0.02f;
constexpr float kBright = 0.2f;
// Limits of the factor by which the light of a splat changes.
constexpr float kLeastLight = 0.25f;
constexpr float kMostLight = 4.0f;
// Standard deviations of a cell's splat, in cell edges: along its surface, where neighbours overlap enough to
// cover it evenly, and across.
constexpr double kAlong = 0.55;
constexpr double kAcross = 0.3;

float opacityOf(float logit) {
    return 1.0f / (1.0f + std::exp(-logit));
}

float logitOf(float opacity) {
    return std::log(opacity / (1.0f - opacity));
}

glm::vec3 colourOf(const splat::Splats& splats, std::size_t i) {
    return glm::max(splat::colourOfDc(splats.dc[i]), glm::vec3(0.0f));
}

// The area that a splat covers, seen along its shortest axis.
float broadSideMm2(const splat::Splats& splats, std::size_t i) {
    constexpr float kTwoPi = 6.2831853f;
    const glm::vec3 scale = splats.logScale[i];
    const float smallest = std::min({scale.x, scale.y, scale.z});
    return kTwoPi * std::exp(std::min(scale.x + scale.y + scale.z - smallest, splat::kMaxLogScale));
}

glm::mat3 axesOf(const splat::Splats& splats, std::size_t i) {
    const glm::vec4 q = splats.rotation[i];
    return glm::mat3_cast(glm::normalize(glm::quat(q[0], q[1], q[2], q[3])));
}

// Turns the third axis onto a direction.
glm::vec4 rotationOnto(const glm::dvec3& direction) {
    const glm::dvec3 from{0.0, 0.0, 1.0};
    const double cosine = glm::dot(from, direction);
    glm::dquat turn{1.0, 0.0, 0.0, 0.0};
    if (cosine < -0.999999) {
        turn = glm::dquat(0.0, 1.0, 0.0, 0.0);
    } else {
        const glm::dvec3 axis = glm::cross(from, direction);
        turn = glm::normalize(glm::dquat(1.0 + cosine, axis.x, axis.y, axis.z));
    }
    return {float(turn.w), float(turn.x), float(turn.y), float(turn.z)};
}

struct Lit {
    glm::vec3 reflectance;
    glm::vec3 light;
};

// Gives a splat the colour of its present matter and light. The learnt colour of dark matter says little
// about how bright it would be: the darker it was, the more its new colour follows from matter and light.
void recolour(splat::Splats& splats, std::size_t i, const Lit& before, const Lit& now) {
    const std::size_t count = splat::shCount(splats.shDegree);
    glm::vec3 colour = splat::colourOfDc(splats.dc[i]);
    // One factor for all channels: the hue of dim light is mostly noise.
    const float lightBefore = before.light.r + before.light.g + before.light.b;
    const float lightNow = now.light.r + now.light.g + now.light.b;
    const float brighter =
        lightBefore > 0.0f ? std::clamp(lightNow / lightBefore, kLeastLight, kMostLight) : 1.0f;
    for (int c = 0; c < 3; ++c) {
        if (before.reflectance[c] == now.reflectance[c] && brighter == 1.0f) continue;
        const float factor = brighter * now.reflectance[c] / std::max(before.reflectance[c], kDark);
        const float known = std::clamp((before.reflectance[c] - kDark) / (kBright - kDark), 0.0f, 1.0f);
        colour[c] = known * factor * colour[c] + (1.0f - known) * now.reflectance[c] * now.light[c];
        for (std::size_t k = 0; k < count; ++k) splats.sh[i * count + k][c] *= known * factor;
    }
    splats.dc[i] = splat::dcOfColour(colour);
}

void appendAll(const splat::Splats& from, splat::Splats& to) {
    const auto add = [](const auto& some, auto& all) { all.insert(all.end(), some.begin(), some.end()); };
    add(from.position, to.position);
    add(from.logScale, to.logScale);
    add(from.rotation, to.rotation);
    add(from.opacityLogit, to.opacityLogit);
    add(from.dc, to.dc);
    add(from.sh, to.sh);
}

// Calls body(i, part) for each i below `count` on all cores; each part begins as `empty`. Then calls
// take(part) for each part in the order of i, whichever was finished first.
template <typename Part, typename Body, typename Take>
void inParts(std::size_t count, const Part& empty, const Body& body, const Take& take) {
    constexpr std::size_t kOfPart = 4096;
    std::vector<Part> parts((count + kOfPart - 1) / kOfPart, empty);
    parallelFor(parts.size(), [&](std::size_t p) {
        for (std::size_t i = p * kOfPart; i < std::min((p + 1) * kOfPart, count); ++i) body(i, parts[p]);
    });
    for (const Part& part : parts) take(part);
}

}  // namespace

SplatEstimate::SplatEstimate(std::shared_ptr<const CoarseMatter> matter,
                             std::shared_ptr<const splat::Splats> model, ShownMatter learntOf,
                             const trace::Environment& environment, const SplatEstimateOptions& options)
    : matter_(std::move(matter)),
      model_(std::move(model)),
      learntOf_(std::move(learntOf)),
      options_(options),
      voxelFromWorld_(glm::inverse(matter_->volume().worldFromVoxel())) {
    if (model_->size() == 0) {
        std::fill(learntOf_.optics.begin(), learntOf_.optics.end(), glm::vec4(0.0f));
        learntOf_.steep.clear();
    }
    const Volume& volume = matter_->volume();
    const EntryMap& map = matter_->entryMap();
    places_.resize(model_->size());
    for (std::size_t i = 0; i < model_->size(); ++i) {
        const glm::dvec3 middle = model_->originMm + glm::dvec3(model_->position[i]);
        const glm::dmat3 axes(axesOf(*model_, i));
        const glm::dvec3 deviation = glm::exp(glm::dvec3(glm::min(model_->logScale[i], splat::kMaxLogScale)));
        for (std::size_t k = 0; k < kPlaces; ++k) {
            glm::dvec3 at = middle;
            if (k > 0) at += (k % 2 == 0 ? -1.0 : 1.0) * deviation[int(k - 1) / 2] * axes[int(k - 1) / 2];
            const glm::dvec3 voxel = transformPoint(voxelFromWorld_, at);
            const glm::ivec3 nearest(
                glm::clamp(glm::round(voxel), glm::dvec3(0.0), glm::dvec3(volume.size() - 1)));
            places_[i].entries[k] = map.entryOf(volume.stored(nearest.x, nearest.y, nearest.z));
            if (k > 0) continue;
            places_[i].voxel = glm::vec3(voxel);
            places_[i].cell = std::uint32_t(matter_->cellOf(voxel));
        }
    }
    learntLit_ = litMatter(*matter_, learntOf_);
    wasFace_.resize(matter_->cellCount());
    for (const FacePlace& place : facePlaces(*matter_, learntOf_)) wasFace_[place.cell] = true;
    std::vector<LitSample> samples;
    learntMatter_.resize(places_.size());
    for (std::size_t i = 0; i < places_.size(); ++i) {
        learntMatter_[i] = matterAt(places_[i], learntOf_);
        const Matter& of = learntMatter_[i];
        if (of.extinction < kLeastExtinction) continue;
        samples.push_back({.light = lightOn(*matter_, learntLit_, places_[i].cell),
                           .reflectance = of.reflectance,
                           .radiance = colourOf(*model_, i),
                           .weight = opacityOf(model_->opacityLogit[i])});
    }
    light_ = fittedLight(samples, lightOf(environment, glm::dmat3(volume.worldFromVoxel())));
}

SplatEstimate::Matter SplatEstimate::matterAt(const Place& place, const ShownMatter& shown) const {
    Matter sum;
    glm::vec3 albedo{0.0f};
    // The gradient at its middle stands for the whole splat.
    const glm::ivec3 voxel(
        glm::clamp(glm::round(place.voxel), glm::vec3(0.0f), glm::vec3(matter_->volume().size() - 1)));
    for (const std::uint16_t entry : place.entries) {
        const glm::vec4 optics = shown.opticsAt(*matter_, entry, voxel);
        sum.extinction += optics.w;
        albedo += optics.w * glm::vec3(optics);
    }
    if (sum.extinction > 0.0f) sum.reflectance = reflectanceOf(albedo / sum.extinction);
    sum.extinction /= float(kPlaces);
    return sum;
}

splat::Splats SplatEstimate::none() const {
    return {.originMm = model_->originMm,
            .axes = model_->axes,
            .colourSpace = model_->colourSpace,
            .lowPass = model_->lowPass,
            .shDegree = model_->shDegree};
}

splat::Splats SplatEstimate::under(const ShownMatter& shown) const {
    const LitMatter lit = litMatter(*matter_, shown);
    const TimelineStage stage("splats of estimate");
    const bool hasOtherFaces =
        model_->size() == 0 || shown.clip != learntOf_.clip || shown.faces != learntOf_.faces;
    std::vector<bool> isFace(matter_->cellCount());
    const std::vector<FacePlace> faces = facePlaces(*matter_, shown);
    for (const FacePlace& place : faces) isFace[place.cell] = true;
    Part all{.splats = none(), .covers = {}};
    const auto take = [&all](const Part& part) {
        appendAll(part.splats, all.splats);
        all.covers.insert(all.covers.end(), part.covers.begin(), part.covers.end());
    };
    inParts<Part>(
        places_.size(), {.splats = none(), .covers = {}},
        [&](std::size_t i, Part& part) {
            // Splats that learnt one face do not show another, and would hide it.
            const bool isOfFace = isFace[places_[i].cell] || wasFace_[places_[i].cell];
            if (hasOtherFaces && isOfFace) return;
            if (shown.shows(matter_->volume(), glm::dvec3(places_[i].voxel))) addChanged(i, shown, lit, part);
        },
        take);
    std::vector<float> covered(matter_->cellCount(), 0.0f);
    for (const auto& [cell, share] : all.covers) covered[cell] += share;
    for (const FacePlace& place : faces) {
        covered[place.cell] = 1.0f;
        if (hasOtherFaces) addFace(place, all.splats);
    }
    const std::vector<std::uint32_t> cells = cellsWithout(lit, covered);
    inParts<Part>(
        cells.size(), {.splats = none(), .covers = {}},
        [&](std::size_t i, Part& part) { addSplatOf(cells[i], shown, lit, covered[cells[i]], part.splats); },
        take);
    return std::move(all.splats);
}

void SplatEstimate::addChanged(std::size_t i, const ShownMatter& shown, const LitMatter& lit,
                               Part& part) const {
    splat::Splats& splats = part.splats;
    const Place& place = places_[i];
    const Matter& before = learntMatter_[i];
    const Matter now = matterAt(place, shown);
    float denser = 1.0f;
    if (before.extinction >= kLeastExtinction) {
        denser = std::min(now.extinction / before.extinction, kMostDenser);
    } else if (const float cell = learntLit_.extinctionPerMm[place.cell]; cell > kLeastExtinction) {
        denser = std::min(lit.extinctionPerMm[place.cell] / cell,
                          kMostDenser);  // the splat lies beside the matter that it stands for
    }
    const float learnt = std::min(opacityOf(model_->opacityLogit[i]), kMostLearntOpacity);
    const float opacity = denser == 1.0f ? learnt : -std::expm1(denser * std::log1p(-learnt));
    if (opacity < kLeastOpacity && opacity < learnt) return;
    splats.append(*model_, i);
    const std::size_t last = splats.size() - 1;
    splats.opacityLogit[last] = logitOf(std::clamp(opacity, 1e-4f, kMostLearntOpacity));
    recolour(splats, last, {before.reflectance, light_.at(lightOn(*matter_, learntLit_, place.cell))},
             {now.reflectance, light_.at(lightOn(*matter_, lit, place.cell))});
    part.covers.emplace_back(
        place.cell,
        opacity * std::min(broadSideMm2(*model_, i) / float(matter_->edgeMm() * matter_->edgeMm()), 4.0f));
}

void SplatEstimate::addFace(const FacePlace& place, splat::Splats& splats) const {
    // Samples lie at centres of voxels, so in thick slices they are farther apart than half a cell.
    const glm::dvec3 spacing = matter_->volume().spacingMm();
    const glm::dvec3 between = glm::ceil(0.5 * matter_->cellMm() / spacing) * spacing;
    const double apart = std::max({between.x, between.y, between.z});
    const glm::dvec3 middle = transformPoint(matter_->volume().worldFromVoxel(), place.voxel);
    splats.position.emplace_back(middle - splats.originMm);
    splats.logScale.emplace_back(std::log(kAlong * apart), std::log(kAlong * apart),
                                 std::log(kAcross * apart));
    splats.rotation.push_back(rotationOnto(place.outwards));
    splats.opacityLogit.push_back(logitOf(kMostOpacity));
    splats.dc.push_back(splat::dcOfColour(glm::vec3(place.radiance)));
    splats.sh.insert(splats.sh.end(), splat::shCount(splats.shDegree), glm::vec3(0.0f));
}

std::vector<std::uint32_t> SplatEstimate::cellsWithout(const LitMatter& lit,
                                                       const std::vector<float>& covered) const {
    struct Wanted {
        std::uint32_t cell;
        float worth;
    };
    // How much of a cell is visible from outside.
    const auto worthOf = [&](const LitMatter& of, std::size_t cell) {
        return opacityOfCell(of, cell) * of.openness(cell);
    };
    std::vector<Wanted> wanted;
    inParts<std::vector<Wanted>>(
        matter_->cellCount(), {},
        [&](std::size_t cell, std::vector<Wanted>& part) {
            if (!(lit.opacity[cell] > 0.0f) || covered[cell] >= kWhollyCovered ||
                opacityOfCell(lit, cell) < kLeastOpacity || lit.openness(cell) < kLeastOpenness)
                return;
            const float worth = worthOf(lit, cell);
            // The model knows what it has seen: where it has no splats, none are needed.
            if (!wasFace_[cell] && worthOf(learntLit_, cell) > kKnownShare * worth) return;
            part.push_back({std::uint32_t(cell), worth});
        },
        [&](const std::vector<Wanted>& part) { wanted.insert(wanted.end(), part.begin(), part.end()); });
    if (wanted.size() > options_.mostNewSplats) {
        const auto last = wanted.begin() + std::ptrdiff_t(options_.mostNewSplats);
        std::nth_element(wanted.begin(), last, wanted.end(),
                         [](const Wanted& a, const Wanted& b) { return a.worth > b.worth; });
        wanted.erase(last, wanted.end());
    }
    std::vector<std::uint32_t> cells;
    for (const Wanted& one : wanted) cells.push_back(one.cell);
    return cells;
}

float SplatEstimate::opacityOfCell(const LitMatter& lit, std::size_t cell) const {
    return -std::expm1(-kDenser * float(matter_->edgeMm()) * lit.extinctionPerMm[cell]);
}

// The splat is as wide as the cell, and flat if the cell is part of a surface.
void SplatEstimate::addSplatOf(std::uint32_t cell, const ShownMatter& shown, const LitMatter& lit,
                               float covered, splat::Splats& splats) const {
    const Volume& volume = matter_->volume();
    const bool isClipped = shown.mask || shown.clip.hasShape();
    const auto entries = matter_->entriesOf(cell);
    glm::dvec3 voxel{0.0};
    glm::vec3 albedo{0.0f};
    float weight = 0.0f;
    for (std::size_t s = 0; s < CoarseMatter::kSamples; ++s) {
        const glm::ivec3 sampled = matter_->voxelOf(cell, s);
        const glm::vec4 optics = shown.opticsAt(*matter_, entries[s], sampled);
        const glm::dvec3 at(sampled);
        if (!(optics.w > 0.0f) || (isClipped && !shown.shows(volume, at))) continue;
        weight += optics.w;
        voxel += double(optics.w) * at;
        albedo += optics.w * glm::vec3(optics);
    }
    if (!(weight > 0.0f)) return;
    const double edge = matter_->edgeMm();
    const glm::dvec3 middle = transformPoint(volume.worldFromVoxel(), voxel / double(weight));
    // The inverse transpose turns a gradient over voxels into one in the world.
    const glm::dvec3 rise =
        glm::transpose(glm::dmat3(voxelFromWorld_)) *
        (glm::dvec3(riseAround(*matter_, lit, cell)) / matter_->cellMm() * volume.spacingMm());
    const bool isSurface = glm::length(rise) * edge > kSurfaceRise;
    splats.position.emplace_back(middle - splats.originMm);
    splats.logScale.emplace_back(std::log(kAlong * edge), std::log(kAlong * edge),
                                 std::log((isSurface ? kAcross : kAlong) * edge));
    splats.rotation.push_back(isSurface ? rotationOnto(glm::normalize(rise))
                                        : glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
    const float opacity = opacityOfCell(lit, cell) * (1.0f - std::min(covered, 1.0f));
    splats.opacityLogit.push_back(logitOf(std::clamp(opacity, 0.005f, kMostOpacity)));
    splats.dc.push_back(
        splat::dcOfColour(reflectanceOf(albedo / weight) * light_.at(lightOn(*matter_, lit, cell))));
    splats.sh.insert(splats.sh.end(), splat::shCount(splats.shDegree), glm::vec3(0.0f));
}

}  // namespace macula::hybrid
