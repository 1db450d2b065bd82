#include "registration/rigid_registration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "base/is_finite.h"
#include "registration/comparison.h"
#include "registration/intensity_bins.h"
#include "registration/pattern_search.h"
#include "registration/rival.h"
#include "registration/scalar_grid.h"

namespace macula::registration {

namespace {

// Cell sizes of the levels, in mm: fine enough for half a voxel of a slice for reading, and fast.
constexpr std::array kCellsMm{2.0, 4.0, 8.0};
constexpr std::size_t kFine = 0;
constexpr std::size_t kMiddle = 1;
constexpr std::size_t kCoarse = 2;

constexpr std::size_t kCoarsePoints = 4000;
constexpr std::size_t kMiddlePoints = 16000;
constexpr std::size_t kFinePoints = 40000;
constexpr std::size_t kLeastPoints = 200;  // a volume also needs this many cells
constexpr double kLeastPointsMet = 100.0;  // fewer may be alike by chance

constexpr double kLeastOverlap = 0.3;    // share of the smaller volume
constexpr double kSweepStepMm = 24.0;    // of the starts along the patient: scans begin at different heights
constexpr double kSweepReachMm = 480.0;  // to each side
constexpr std::size_t kStartsFollowed = 4;
constexpr double kSamePlaceMm = 10.0;  // nearer results of the coarse level count as one
constexpr double kApartMm = 3.0;       // between the two starts of the middle and fine levels
constexpr SearchRange kCoarseRange{.firstStep = 8.0, .lastStep = 1.0};
constexpr SearchRange kMiddleRange{.firstStep = 3.0, .lastStep = 0.3};
constexpr SearchRange kRivalRange{.firstStep = 3.0, .lastStep = 0.6, .mostCalls = 200};
constexpr SearchRange kFineRange{.firstStep = 1.0, .lastStep = 0.06};

constexpr std::uint64_t kSeed = 20031;

constexpr double kDoubtfulMm = 3.0;
constexpr double kDoubtfulInformation = 0.05;  // nats: about that of volumes of two different bodies
constexpr double kDoubtfulOverlap = 0.1;
// Repetitive spines have 0.7 or more at one vertebra off or farther, other anatomy 0.36 or less.
constexpr double kDoubtfulRival = 0.5;

constexpr std::size_t kProgressSteps = 12;

Error cancelled() {
    return {ErrorCode::cancelled, Text("Registration was cancelled."), {}, {}};
}

Error notUsable(Text sentence) {
    return {ErrorCode::inputNotUsable,
            std::move(sentence),
            {},
            Text("Link the volumes by hand, or choose another series.")};
}

// A volume at increasingly coarse levels.
struct Pyramid {
    std::array<ScalarGrid, kCellsMm.size()> levels;  // the index is kFine, kMiddle or kCoarse
};

Pyramid pyramidOf(const Volume& volume, const CancelToken& token) {
    Pyramid pyramid;
    pyramid.levels[kFine] = gridOf(volume, kCellsMm[kFine], token);
    for (const std::size_t level : {kMiddle, kCoarse})
        pyramid.levels[level] = coarser(pyramid.levels[level - 1], kCellsMm[level]);
    return pyramid;
}

// The extent of a volume's values.
struct Extent {
    Box box{glm::dvec3(std::numeric_limits<double>::max()),
            glm::dvec3(std::numeric_limits<double>::lowest())};
    glm::dvec3 middleMm{0.0};  // centroid of the cells with a value
    std::size_t cells = 0;
    double volumeMl = 0.0;
};

Extent extentOf(const ScalarGrid& grid) {
    Extent extent;
    glm::dvec3 sum(0.0);
    for (int k = 0; k < grid.size.z; ++k) {
        for (int j = 0; j < grid.size.y; ++j) {
            for (int i = 0; i < grid.size.x; ++i) {
                if (std::isnan(grid.values[grid.index(i, j, k)])) continue;
                const glm::dvec3 mm = transformPoint(grid.worldFromGrid, glm::dvec3(i, j, k));
                extent.box.low = glm::min(extent.box.low, mm);
                extent.box.high = glm::max(extent.box.high, mm);
                sum += mm;
                ++extent.cells;
            }
        }
    }
    if (extent.cells > 0) extent.middleMm = sum / double(extent.cells);
    extent.volumeMl =
        double(extent.cells) * std::abs(glm::determinant(glm::dmat3(grid.worldFromGrid))) / 1000.0;
    return extent;
}

glm::dvec3 shiftOf(const Parameters& p) {
    return {p[3], p[4], p[5]};
}

class RigidSearch {
  public:
    RigidSearch(const Volume& fixed, const Volume& moving, Progress& progress)
        : progress_(progress),
          fixed_(pyramidOf(fixed, progress.token())),
          moving_((progress.advance(), pyramidOf(moving, progress.token()))),
          fixedBins_(fixed_.levels[kMiddle], fixed.unit()),
          movingBins_(moving_.levels[kMiddle], moving.unit()),
          fixedExtent_(extentOf(fixed_.levels[kMiddle])),
          movingExtent_(extentOf(moving_.levels[kMiddle])) {
        progress.advance();
    }

    Result<RigidRegistration> found() {
        if (progress_.cancelled()) return cancelled();
        MACULA_TRY_VOID(checkInput());
        const Comparison coarse = comparison(kCoarse, kCoarsePoints, 0);
        if (coarse.pointCount() < kLeastPoints || movingExtent_.cells < kLeastPoints)
            return notUsable(Text("One of the volumes has too few voxels to be registered."));
        const std::vector<Highest> places = placesOf(coarse);
        if (progress_.cancelled()) return cancelled();
        if (places.empty())
            return notUsable(
                Text("The volumes do not show enough of the same part of the body to be registered."));
        progress_.advance(2);
        std::vector<Parameters> others;
        for (std::size_t n = 1; n < places.size(); ++n) others.push_back(places[n].at);
        const Comparison judge = comparison(kFine, kFinePoints, 2);
        Answer answer = refined(places.front().at, judge);
        if (progress_.cancelled()) return cancelled();
        progress_.advance(6);
        const Comparison middle = comparison(kMiddle, kMiddlePoints, 2);
        std::optional<Rival> rival = rivalOf(answer, others, middle);
        if (rival && rival->share >= 1.0 && !progress_.cancelled()) {  // fits even better on the middle level
            const Answer second = refined(rival->place.at, judge);
            if (second.score > answer.score && !progress_.cancelled()) {
                others.insert(others.begin(), answer.at);
                answer = second;
                rival = rivalOf(answer, others, middle);
            }
        }
        if (progress_.cancelled()) return cancelled();
        progress_.advance(2);
        return told(answer, rival, judge);
    }

  private:
    // The better result of two searches, which began on both sides of a place.
    struct Answer {
        std::array<Highest, 2> ends{};
        Parameters at{};
        double score = 0.0;  // on the judge's finer points
    };

    Comparison comparison(std::size_t level, std::size_t points, std::uint64_t run) const {
        const double smaller = std::min(1.0, movingExtent_.volumeMl / fixedExtent_.volumeMl);
        std::vector<SamplePoint> drawn =
            samplePoints(fixed_.levels[level], fixedBins_, points, kSeed + 10 * run + level);
        const double least = std::max(kLeastOverlap * smaller,
                                      kLeastPointsMet / double(std::max<std::size_t>(drawn.size(), 1)));
        return {std::move(drawn), moving_.levels[level], movingBins_, fixedExtent_.middleMm, least};
    }

    Result<void> checkInput() const {
        for (const Pyramid* volume : {&fixed_, &moving_}) {
            const glm::ivec3& size = volume->levels[kFine].size;
            if (size.x < 3 || size.y < 3 || size.z < 3)
                return notUsable(
                    Text("A volume of fewer than three slices, rows or columns cannot be registered."));
        }
        if (fixedExtent_.volumeMl <= 0.0 || movingExtent_.volumeMl <= 0.0)
            return notUsable(Text("One of the volumes has no values: there is nothing to register by."));
        if (!fixedBins_.areUsable() || !movingBins_.areUsable())
            return notUsable(
                Text("One of the volumes has the same value everywhere: there is nothing to register by."));
        return {};
    }

    Highest highest(const Comparison& on, const Parameters& start, const SearchRange& range) const {
        return patternSearch([&](const Parameters& p) { return on.score(p); }, start, range,
                             [this] { return progress_.cancelled(); });
    }

    // The starts: as the volumes lie, centred on each other, and from both of these along the patient.
    std::vector<Parameters> starts() const {
        const glm::dvec3 toMiddle = movingExtent_.middleMm - fixedExtent_.middleMm;
        std::vector<Parameters> all{{}, {0.0, 0.0, 0.0, toMiddle.x, toMiddle.y, toMiddle.z}};
        const auto reach = int(kSweepReachMm / kSweepStepMm);
        for (int n = -reach; n <= reach; ++n) {
            all.push_back({0.0, 0.0, 0.0, toMiddle.x, toMiddle.y, toMiddle.z + n * kSweepStepMm});
            all.push_back({0.0, 0.0, 0.0, 0.0, 0.0, n * kSweepStepMm});
        }
        return all;
    }

    // The places that the best starts lead to, best first, without duplicates.
    std::vector<Highest> placesOf(const Comparison& coarse) const {
        std::vector<Highest> all;
        for (const Parameters& start : starts()) {
            if (progress_.cancelled()) return {};
            all.push_back({start, coarse.score(start)});
        }
        std::ranges::stable_sort(all, std::ranges::greater(), &Highest::value);
        all.resize(kStartsFollowed);
        std::erase_if(all, [](const Highest& start) { return !std::isfinite(start.value); });
        for (Highest& place : all) place = highest(coarse, place.at, kCoarseRange);
        std::ranges::stable_sort(all, std::ranges::greater(), &Highest::value);
        std::vector<Highest> places;
        for (const Highest& place : all) {
            const bool isKnown = std::ranges::any_of(places, [&](const Highest& known) {
                return glm::length(shiftOf(known.at) - shiftOf(place.at)) < kSamePlaceMm;
            });
            if (!isKnown) places.push_back(place);
        }
        return places;
    }

    Answer refined(const Parameters& from, const Comparison& judge) const {
        Answer answer;
        for (std::size_t run = 0; run < answer.ends.size(); ++run) answer.ends[run] = refined(from, run);
        const std::array<double, 2> scores{judge.score(answer.ends[0].at), judge.score(answer.ends[1].at)};
        const std::size_t better = scores[1] > scores[0] ? 1 : 0;
        answer.at = answer.ends[better].at;
        answer.score = scores[better];
        return answer;
    }

    // Refines from one of two starts on both sides of the coarse level's answer.
    Highest refined(const Parameters& from, std::size_t run) const {
        Parameters start = from;
        const double away = run == 0 ? kApartMm : -kApartMm;
        for (std::size_t n = 0; n < start.size(); ++n) start[n] += n % 2 == 0 ? away : -away;
        const Highest middle = highest(comparison(kMiddle, kMiddlePoints, run), start, kMiddleRange);
        return highest(comparison(kFine, kFinePoints, run), middle.at, kFineRange);
    }

    std::optional<Rival> rivalOf(const Answer& answer, const std::vector<Parameters>& others,
                                 const Comparison& middle) const {
        return strongestRival(middle, answer.at, others,
                              [&](const Parameters& start) { return highest(middle, start, kRivalRange); });
    }

    RigidRegistration told(const Answer& answer, const std::optional<Rival>& rival,
                           const Comparison& judge) const {
        const Likeness after = judge.at(answer.at);
        RigidRegistration registration{.movingFromFixed = transformOf(answer.at, fixedExtent_.middleMm),
                                       .informationBefore = informationBefore(judge),
                                       .informationAfter = after.information,
                                       .overlap = after.overlap};
        registration.boundMm = kFineRange.lastStep + farthestApartMm(answer.ends);
        if (rival) {
            registration.rivalShare = rival->share;
            registration.rivalMm = rival->shiftMm;
        }
        return registration;
    }

    double informationBefore(const Comparison& judge) const {
        const std::vector<Parameters> all = starts();
        const bool asTheyLie = std::isfinite(judge.score(all[0]));
        return judge.at(asTheyLie ? all[0] : all[1]).information;
    }

    // The largest distance at the corners of the volumes' overlap.
    double farthestApartMm(const std::array<Highest, 2>& ends) const {
        const glm::dmat4 first = transformOf(ends[0].at, fixedExtent_.middleMm);
        const glm::dmat4 second = transformOf(ends[1].at, fixedExtent_.middleMm);
        const glm::dmat4 back = glm::inverse(first);
        Box moving{glm::dvec3(std::numeric_limits<double>::max()),
                   glm::dvec3(std::numeric_limits<double>::lowest())};
        for (const glm::dvec3& corner : cornersOf(movingExtent_.box)) {
            moving.low = glm::min(moving.low, transformPoint(back, corner));
            moving.high = glm::max(moving.high, transformPoint(back, corner));
        }
        const Box both{glm::max(fixedExtent_.box.low, moving.low),
                       glm::min(fixedExtent_.box.high, moving.high)};
        double apartMm = 0.0;
        for (const glm::dvec3& corner : cornersOf(both)) {
            const glm::dvec3 from = transformPoint(first, corner);
            apartMm = std::max(apartMm, glm::length(from - transformPoint(second, corner)));
        }
        return apartMm;
    }

    Progress& progress_;
    Pyramid fixed_;
    Pyramid moving_;
    IntensityBins fixedBins_;
    IntensityBins movingBins_;
    Extent fixedExtent_;
    Extent movingExtent_;
};

}  // namespace

bool RigidRegistration::hasRival() const {
    return rivalShare >= kDoubtfulRival;
}

bool RigidRegistration::isDoubtful() const {
    return !(boundMm <= kDoubtfulMm) || informationAfter < kDoubtfulInformation ||
           informationAfter < informationBefore || overlap < kDoubtfulOverlap || hasRival();
}

Result<RigidRegistration> registerRigid(const Volume& fixed, const Volume& moving, Progress& progress) try {
    progress.beginStage(Text("Registering the second volume"), kProgressSteps);
    return RigidSearch(fixed, moving, progress).found();
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory,
                 Text("There is not enough memory to register the volumes."),
                 {},
                 Text("Close other programs, or link the volumes by hand.")};
}

double boxOverlap(const Volume& fixed, const Volume& moving, const glm::dmat4& movingFromFixed) {
    constexpr int kAlong = 12;  // points, evenly within the fixed volume
    const glm::dmat4 cellFromVoxel =
        glm::inverse(moving.worldFromVoxel()) * movingFromFixed * fixed.worldFromVoxel();
    int within = 0;
    for (int n = 0; n < kAlong * kAlong * kAlong; ++n) {
        const glm::dvec3 share =
            (glm::dvec3(n % kAlong, n / kAlong % kAlong, n / kAlong / kAlong) + 0.5) / double(kAlong);
        const glm::dvec3 at = transformPoint(cellFromVoxel, share * glm::dvec3(fixed.size()) - 0.5);
        const glm::dvec3 end = glm::dvec3(moving.size()) - 0.5;
        if (at.x >= -0.5 && at.y >= -0.5 && at.z >= -0.5 && at.x <= end.x && at.y <= end.y && at.z <= end.z)
            ++within;
    }
    return double(within) / (kAlong * kAlong * kAlong);
}

bool isRigid(const glm::dmat4& transform) {
    constexpr double kTolerance = 1e-3;
    if (!isFinite(transform)) return false;
    const glm::dmat3 turn(transform);
    const glm::dmat3 square = glm::transpose(turn) * turn;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (std::abs(square[column][row] - (column == row ? 1.0 : 0.0)) > kTolerance) return false;
    return glm::determinant(turn) > 0.0 && transform[0][3] == 0.0 && transform[1][3] == 0.0 &&
           transform[2][3] == 0.0 && transform[3][3] == 1.0;
}

}  // namespace macula::registration
