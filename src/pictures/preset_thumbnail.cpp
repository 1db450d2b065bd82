#include "pictures/preset_thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <optional>
#include <utility>

#include "base/srgb.h"
#include "pipeline/volume/volume_fit.h"
#include "scene/camera/usual_view.h"

namespace macula::pictures {

namespace {

using Fit = TransferFunction::Fit;

constexpr int kMostVoxelsPerSide = 4;   // whose mean a cell has
constexpr std::size_t kEntries = 4096;  // entries of the lookup table of the curves
constexpr double kStepCells = 0.5;
constexpr double kFovDeg = 30.0;
constexpr double kOpaque = 1.0 / 255.0;  // transmittance below this ends a ray
constexpr double kLeastShaded = 1e-3;    // with less opacity, shading costs more than it shows

Error cancelled() {
    return {ErrorCode::cancelled, Text("The small picture was not drawn."), {}, {}};
}

Error noMemory() {
    return {ErrorCode::outOfMemory,
            Text("There is not enough memory for small pictures of presets."),
            {},
            Text("Close other programs.")};
}

// The voxels along one axis whose mean a cell has.
std::vector<int> voxelsOf(int cell, int cells, int voxels) {
    const int first = int(std::int64_t(cell) * voxels / cells);
    const int end = std::max(first + 1, int(std::int64_t(cell + 1) * voxels / cells));
    const int taken = std::min(end - first, kMostVoxelsPerSide);
    std::vector<int> places;
    for (int n = 0; n < taken; ++n) places.push_back(first + int((n + 0.5) * (end - first) / taken));
    return places;
}

double airOf(const Volume& volume) {
    if (volume.format() == VoxelFormat::float32) return volume.valueRange()->low;
    return volume.unitsFromStored()(volume.airStored());
}

double encoded(double linear) {
    return encodedSrgb(std::clamp(linear, 0.0, 1.0));
}

// A lookup table of the curves over the range of values, so that samples need not evaluate them.
class Optics {
  public:
    Optics(const TransferFunction& function, const ValueRange& values) : low_(values.low) {
        const double range = std::max(values.high - values.low, 1e-12);
        entriesPerUnit_ = double(kEntries - 1) / range;
        for (std::size_t i = 0; i < kEntries; ++i) {
            const double value = values.low + range * double(i) / double(kEntries - 1);
            const glm::dvec3 colour = colourAt(function, value);
            entries_.push_back({extinctionPerMm(function, value),
                                function.albedo * glm::dvec3(decodedSrgb(colour.r), decodedSrgb(colour.g),
                                                             decodedSrgb(colour.b))});
        }
    }

    struct Entry {
        double extinctionPerMm;
        glm::dvec3 colour;  // linear
    };
    const Entry& at(double value) const {
        const double place = (value - low_) * entriesPerUnit_ + 0.5;
        return entries_[std::size_t(std::clamp(place, 0.0, double(kEntries - 1)))];
    }

  private:
    double low_;
    double entriesPerUnit_;
    std::vector<Entry> entries_;
};

// The part of a ray that lies in the volume. The ray is in cells; distances are multiples of `along`.
struct Stretch {
    double from = 0.0;
    double to = 0.0;
};
Stretch within(const glm::ivec3& size, const glm::dvec3& from, const glm::dvec3& along) {
    Stretch stretch{0.0, 1e30};
    for (int axis = 0; axis < 3; ++axis) {
        const double low = -0.5;
        const double high = size[axis] - 0.5;
        if (std::abs(along[axis]) < 1e-12) {
            if (from[axis] < low || from[axis] > high) return {};
            continue;
        }
        const double a = (low - from[axis]) / along[axis];
        const double b = (high - from[axis]) / along[axis];
        stretch.from = std::max(stretch.from, std::min(a, b));
        stretch.to = std::min(stretch.to, std::max(a, b));
    }
    return stretch;
}

struct March {
    const CoarseVolume& coarse;
    const Optics& optics;
    const Optics* steep;  // null: all matter has one pair of curves
    double steepPerMm;    // gradient between cells at which half of the matter is steep
    const Lighting& lighting;
    const Clip* clip;  // null: nothing is hidden
    double longestStepMm;

    // The gradient of the values, per cell.
    glm::dvec3 gradientAt(const glm::dvec3& cell) const {
        glm::dvec3 gradient(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 step(0.0);
            step[axis] = 1.0;
            gradient[axis] = 0.5 * (coarse.valueAt(cell + step) - coarse.valueAt(cell - step));
        }
        return gradient;
    }
    // A gradient in cells is a covector: its length in mm follows from the transposed transform.
    double perMm(const glm::dvec3& gradient) const {
        return glm::length(glm::transpose(glm::dmat3(coarse.cellFromWorld())) * gradient);
    }

    Optics::Entry matterAt(const glm::dvec3& cell) const {
        const double value = coarse.valueAt(cell);
        const Optics::Entry& flat = optics.at(value);
        if (steep == nullptr) return flat;
        const Optics::Entry& other = steep->at(value);
        if (!(flat.extinctionPerMm > 0.0 || other.extinctionPerMm > 0.0)) return flat;
        const double ratio = perMm(gradientAt(cell)) / steepPerMm;
        const double part = ratio * ratio / (1.0 + ratio * ratio);
        const double extinction = std::lerp(flat.extinctionPerMm, other.extinctionPerMm, part);
        if (!(extinction > 0.0)) return flat;
        return {extinction, glm::mix(flat.colour, other.colour, part * other.extinctionPerMm / extinction)};
    }

    // The share of a headlight that comes back: Lambert, the same from behind. The dot product of a gradient
    // in cells and `alongCells` is the change of the value per mm along the ray.
    double shade(const glm::dvec3& cell, const glm::dvec3& alongCells) const {
        if (!lighting.shade) return 1.0;
        const glm::dvec3 gradient = gradientAt(cell);
        const double length = perMm(gradient);
        const double cosine = length > 0.0 ? std::abs(glm::dot(gradient, alongCells)) / length : 1.0;
        return lighting.ambient + lighting.diffuse * std::min(cosine, 1.0);
    }

    // Linear light. `alongMm` has length 1.
    glm::dvec3 light(const glm::dvec3& eyeMm, const glm::dvec3& alongMm) const {
        const glm::dvec3 from = transformPoint(coarse.cellFromWorld(), eyeMm);
        const glm::dvec3 along = transformVector(coarse.cellFromWorld(), alongMm);
        const Stretch stretch = within(coarse.size(), from, along);
        glm::dvec3 sum(0.0);
        if (!(stretch.from < stretch.to)) return sum;
        // The steps end exactly at the end of the volume, so that a thin slab absorbs what it should.
        const double lengthMm = stretch.to - stretch.from;
        const int steps = std::max(1, int(std::ceil(lengthMm / longestStepMm)));
        const double stepMm = lengthMm / steps;
        double transmittance = 1.0;
        for (int step = 0; step < steps && transmittance > kOpaque; ++step) {
            const double at = stretch.from + (step + 0.5) * stepMm;
            const glm::dvec3 cell = from + at * along;
            const Optics::Entry entry = matterAt(cell);
            if (!(entry.extinctionPerMm > 0.0)) continue;
            if (clip != nullptr && !shows(*clip, eyeMm + at * alongMm)) continue;
            const double opacity = -std::expm1(-entry.extinctionPerMm * stepMm);
            const double lit = transmittance * opacity > kLeastShaded ? shade(cell, along) : 1.0;
            sum += transmittance * opacity * lit * entry.colour;
            transmittance *= 1.0 - opacity;
        }
        return sum;
    }
};

// From the front, a short scan would be a band of a few rows.
ViewDirection directionOf(const Volume& volume) {
    return scene::isShort(volume) ? ViewDirection::oblique : ViewDirection::anterior;
}

double shortestOf(const glm::dvec3& edges) {
    return std::min({edges.x, edges.y, edges.z});
}

Result<PresetThumbnail> draw(const CoarseVolume& coarse, const TransferFunction& preset, const Clip* clip,
                             const CancelToken& token, int sizePx) {
    MACULA_CHECK(sizePx > 0);
    MACULA_TRY_VOID(validate(preset));
    const Volume& volume = coarse.volume();
    const TransferFunction function = coarse.fittedCurves(preset);
    ValueRange values = *volume.valueRange();
    values.low = std::min(values.low, airOf(volume));
    const Optics optics(function, values);
    const glm::dmat3 worldFromCell = glm::inverse(glm::dmat3(coarse.cellFromWorld()));
    const double shortestMm = shortestOf(
        {glm::length(worldFromCell[0]), glm::length(worldFromCell[1]), glm::length(worldFromCell[2])});
    // At most 4 kLongestCoarseSide steps along the diagonal: very flat cells must not cost many more.
    const double stepMm =
        std::max(kStepCells * shortestMm, volume.worldBox().diagonal() / (4.0 * kLongestCoarseSide));
    std::optional<Optics> steep;
    if (usesSteepCurves(function)) steep.emplace(withCurvesSwapped(function), values);
    // An edge in the body is about two voxels wide; longer cells make it less steep.
    const double widerBy = std::max(1.0, shortestMm / (2.0 * shortestOf(volume.spacingMm())));
    const March march{coarse,
                      optics,
                      steep ? &*steep : nullptr,
                      function.steep.gradientPerMm / widerBy,
                      function.lighting,
                      clip && clip->hasShape() ? clip : nullptr,
                      stepMm};

    const Camera camera = frameBox(volume.worldBox(), directionOf(volume), kFovDeg, 1.0);
    MACULA_TRY(const CameraBasis axes, basis(camera));
    const double halfHeight = std::tan(glm::radians(kFovDeg) / 2.0);
    PresetThumbnail picture{.sizePx = sizePx, .rgba = {}};
    picture.rgba.reserve(4 * std::size_t(sizePx) * std::size_t(sizePx));
    for (int y = 0; y < sizePx; ++y) {
        if (token.cancelled()) return cancelled();
        for (int x = 0; x < sizePx; ++x) {
            const double right = (2.0 * (x + 0.5) / sizePx - 1.0) * halfHeight;
            const double up = (1.0 - 2.0 * (y + 0.5) / sizePx) * halfHeight;
            const glm::dvec3 along = glm::normalize(axes.forward + right * axes.right + up * axes.up);
            const glm::dvec3 light = march.light(camera.positionMm, along);
            for (int c = 0; c < 3; ++c)
                picture.rgba.push_back(std::uint8_t(std::lround(255.0 * encoded(light[c]))));
            picture.rgba.push_back(255);
        }
    }
    return picture;
}

}  // namespace

Result<std::shared_ptr<const CoarseVolume>> CoarseVolume::of(std::shared_ptr<const Volume> volume,
                                                             const CancelToken& token) {
    if (!volume->valueRange())
        return Error{ErrorCode::inputNotUsable,
                     Text("Every voxel of the series is padding: there is nothing to draw."),
                     {},
                     Text("Open another series.")};
    try {
        std::shared_ptr<CoarseVolume> coarse(new CoarseVolume(std::move(volume)));
        const Volume& fine = *coarse->volume_;
        const glm::ivec3 voxels = fine.size();
        const glm::dvec3 spacing = fine.spacingMm();
        // Cells are as cubic as voxels allow: the longest side in mm has the most of them.
        const glm::dvec3 sidesMm = glm::dvec3(voxels) * spacing;
        const double cellMm = std::max({sidesMm.x, sidesMm.y, sidesMm.z}) / kLongestCoarseSide;
        std::array<std::vector<std::vector<int>>, 3> places;
        for (int axis = 0; axis < 3; ++axis) {
            const int cells = std::clamp(int(std::lround(sidesMm[axis] / cellMm)), 1,
                                         std::min(voxels[axis], kLongestCoarseSide));
            coarse->size_[axis] = cells;
            for (int cell = 0; cell < cells; ++cell)
                places.at(std::size_t(axis)).push_back(voxelsOf(cell, cells, voxels[axis]));
        }
        const double air = airOf(fine);
        for (const auto& ks : places[2]) {
            if (token.cancelled()) return cancelled();
            for (const auto& js : places[1]) {
                for (const auto& is : places[0]) {
                    double sum = 0.0;
                    for (const int k : ks)
                        for (const int j : js)
                            for (const int i : is) sum += fine.isPadding(i, j, k) ? air : fine.value(i, j, k);
                    coarse->values_.push_back(float(sum / double(ks.size() * js.size() * is.size())));
                }
            }
        }
        // The middle of cell c is that of its voxels: at (c + 1/2) n / N - 1/2.
        const glm::dvec3 voxelsPerCell = glm::dvec3(voxels) / glm::dvec3(coarse->size_);
        const glm::dmat4 voxelFromCell = affine({voxelsPerCell.x, 0, 0}, {0, voxelsPerCell.y, 0},
                                                {0, 0, voxelsPerCell.z}, 0.5 * voxelsPerCell - 0.5);
        coarse->cellFromWorld_ = glm::inverse(fine.worldFromVoxel() * voxelFromCell);
        return std::shared_ptr<const CoarseVolume>(std::move(coarse));
    } catch (const std::bad_alloc&) {
        return noMemory();
    }
}

double CoarseVolume::valueAt(const glm::dvec3& cell) const {
    const glm::dvec3 last = glm::dvec3(size_ - 1);
    const glm::dvec3 at = glm::clamp(cell, glm::dvec3(0.0), last);
    const glm::ivec3 low = glm::min(glm::ivec3(at), glm::max(size_ - 2, 0));
    const glm::ivec3 high = glm::min(low + 1, size_ - 1);
    const glm::dvec3 part = at - glm::dvec3(low);
    const auto value = [&](int i, int j, int k) {
        const std::size_t row = std::size_t(k) * std::size_t(size_.y) + std::size_t(j);
        return double{values_[row * std::size_t(size_.x) + std::size_t(i)]};
    };
    const auto along = [&](int j, int k) {
        return std::lerp(value(low.x, j, k), value(high.x, j, k), part.x);
    };
    return std::lerp(std::lerp(along(low.y, low.z), along(high.y, low.z), part.y),
                     std::lerp(along(low.y, high.z), along(high.y, high.z), part.y), part.z);
}

TransferFunction CoarseVolume::fittedCurves(const TransferFunction& preset) const {
    if (!preset.fitToVolume) return preset;
    TransferFunction toFit = preset;
    if (preset.fitToVolume->to == Fit::To::foreground) {
        std::call_once(foregroundOnce_, [this] {
            const TransferFunction any{.fitToVolume = Fit{.low = 0.0, .high = 1.0}};
            foreground_ = fitOf(any, *in16Bits(volume_))->volume;
        });
        const double scale =
            (foreground_.high - foreground_.low) / (preset.fitToVolume->high - preset.fitToVolume->low);
        const auto moved = [&](double value) {
            return foreground_.low + (value - preset.fitToVolume->low) * scale;
        };
        for (OpacityPoint& point : toFit.opacity) point.value = moved(point.value);
        for (ColourPoint& point : toFit.colour) point.value = moved(point.value);
        for (OpacityPoint& point : toFit.steep.opacity) point.value = moved(point.value);
        for (ColourPoint& point : toFit.steep.colour) point.value = moved(point.value);
        toFit.steep.gradientPerMm *= scale;
        toFit.fitToVolume.reset();
        return toFit;
    }
    return fitted(toFit, *volume_);
}

Result<PresetThumbnail> presetThumbnail(const CoarseVolume& coarse, const TransferFunction& preset,
                                        const Clip* clip, const CancelToken& token, int sizePx) {
    try {
        return draw(coarse, preset, clip, token, sizePx);
    } catch (const std::bad_alloc&) {
        return noMemory();
    }
}

}  // namespace macula::pictures
