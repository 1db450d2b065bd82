#include "registration/pattern_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace macula::registration {

namespace {

constexpr std::size_t kCount = std::tuple_size_v<Parameters>;
constexpr int kRefinements = 3;
constexpr double kWideSteps = 4.0;      // times the last step: closer points differ only by rounding
constexpr double kFarthestSteps = 2.0;  // the paraboloid is not valid beyond

using Matrix = std::array<Parameters, kCount>;  // only the lower triangle is used

// Solves a x = b by Cholesky factorisation. Nothing unless a is positive definite.
std::optional<Parameters> solved(Matrix a, Parameters b) {
    for (std::size_t i = 0; i < kCount; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double rest = a[i][j];
            for (std::size_t k = 0; k < j; ++k) rest -= a[i][k] * a[j][k];
            if (i == j && !(rest > 0.0)) return std::nullopt;
            a[i][j] = i == j ? std::sqrt(rest) : rest / a[j][j];
        }
    }
    for (std::size_t i = 0; i < kCount; ++i) {
        for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
        b[i] /= a[i][i];
    }
    for (std::size_t i = kCount; i-- > 0;) {
        for (std::size_t k = i + 1; k < kCount; ++k) b[i] -= a[k][i] * b[k];
        b[i] /= a[i][i];
    }
    for (const double x : b)
        if (!std::isfinite(x)) return std::nullopt;
    return b;
}

class Search {
  public:
    Search(const std::function<double(const Parameters&)>& value, const SearchRange& range,
           const std::function<bool()>& cancelled)
        : value_(value), range_(range), cancelled_(cancelled) {}

    Highest from(const Parameters& start) {
        Highest best = evaluated(start);
        for (double step = range_.firstStep; step >= range_.lastStep && !ends(); step *= 0.5)
            climb(best, step);
        refine(best);
        return best;
    }

  private:
    bool ends() const { return calls_ >= range_.mostCalls || cancelled_(); }

    Highest evaluated(const Parameters& at) {
        ++calls_;
        return {at, value_(at)};
    }

    // Climbs as long as steps of this size lead up.
    void climb(Highest& best, double step) {
        while (!ends()) {
            const Highest before = best;
            explore(best, step);
            if (!(best.value > before.value)) return;
            follow(best, before, step);
        }
    }

    void explore(Highest& best, double step) {
        for (std::size_t n = 0; n < best.at.size() && !ends(); ++n) {
            for (const double by : {step, -step}) {
                Parameters next = best.at;
                next[n] += by;
                const Highest found = evaluated(next);
                if (!(found.value > best.value)) continue;
                best = found;
                break;
            }
        }
    }

    // Repeats the last move as long as it leads up.
    void follow(Highest& best, Highest before, double step) {
        while (!ends()) {
            Parameters ahead{};
            for (std::size_t n = 0; n < ahead.size(); ++n) ahead[n] = 2.0 * best.at[n] - before.at[n];
            Highest found = evaluated(ahead);
            explore(found, step);
            if (!(found.value > best.value)) return;
            before = best;
            best = found;
        }
    }

    // Moves to the top of a paraboloid through surrounding points: steps along the axes do not follow a
    // diagonal ridge.
    void refine(Highest& best) {
        for (int n = 0; n < kRefinements && !cancelled_(); ++n) {
            const std::optional<Parameters> top = topAround(best, kWideSteps * range_.lastStep);
            if (!top) return;
            const Highest found = evaluated(*top);
            if (!(found.value > best.value)) return;
            best = found;
        }
    }

    // Nothing if the paraboloid has no maximum.
    std::optional<Parameters> topAround(const Highest& middle, double h) {
        const auto at = [&](std::size_t i, double byI, std::size_t j, double byJ) {
            Parameters place = middle.at;
            place[i] += byI;
            place[j] += byJ;
            return evaluated(place).value;
        };
        Parameters slope{};
        Parameters above{};
        Matrix bend{};  // minus the Hessian
        for (std::size_t i = 0; i < kCount; ++i) {
            if (cancelled_()) return std::nullopt;
            above[i] = at(i, h, i, 0.0);
            const double below = at(i, -h, i, 0.0);
            slope[i] = 0.5 * (above[i] - below) / h;
            bend[i][i] = (2.0 * middle.value - above[i] - below) / (h * h);
            for (std::size_t j = 0; j < i; ++j)
                bend[i][j] = (above[i] + above[j] - at(i, h, j, h) - middle.value) / (h * h);
        }
        std::optional<Parameters> step = solved(bend, slope);
        if (!step) return std::nullopt;
        for (std::size_t i = 0; i < kCount; ++i)
            (*step)[i] = middle.at[i] + std::clamp((*step)[i], -kFarthestSteps * h, kFarthestSteps * h);
        return step;
    }

    const std::function<double(const Parameters&)>& value_;
    SearchRange range_;
    const std::function<bool()>& cancelled_;
    int calls_ = 0;
};

}  // namespace

Highest patternSearch(const std::function<double(const Parameters&)>& value, const Parameters& start,
                      const SearchRange& range, const std::function<bool()>& cancelled) {
    return Search(value, range, cancelled).from(start);
}

}  // namespace macula::registration
