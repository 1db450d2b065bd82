// How many pixels a picture may have while it moves.
#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/trace/look.h"

namespace macula::app {

// Learns what a pixel costs on this device with this study, and says by how much to divide the width and
// height of the window so that a picture in motion stays within the budget.
class MotionScale {
  public:
    // `nsPerPixelGuess` holds until the first observation.
    explicit MotionScale(double budgetMs, double nsPerPixelGuess);

    // What a frame took: tracing, which grows with the pixels, and all the rest, which does not. Kept apart,
    // as the rest would make the pixels of a small picture look dear, and the picture would never grow again.
    void observe(int width, int height, double traceMs, double otherMs);

    // One of 1, 2, 3, 4, 5, 6, 8, 10, 12, 16. A finer one than before only when it would leave a quarter of
    // the budget free, so that the picture does not flicker between two sharpnesses.
    int choose(int windowWidth, int windowHeight);

    double nsPerPixel() const { return nsPerPixel_; }

  private:
    double budgetMs_;
    double nsPerPixel_;
    double otherMs_ = 0.0;
    int last_ = 0;  // 0: none yet
};

// One for each look: what a pixel of one costs says nothing about another, and a projection after light paths
// would begin with the few pixels of these.
class MotionScales {
  public:
    // The arguments are those of MotionScale.
    MotionScales(double budgetMs, double nsPerPixelGuess) : ofLooks_(filled(budgetMs, nsPerPixelGuess)) {}

    MotionScale& of(trace::Look look) { return ofLooks_.at(std::size_t(look)); }

  private:
    static std::vector<MotionScale> filled(double budgetMs, double nsPerPixelGuess) {
        return std::vector(trace::kLooks.size(), MotionScale(budgetMs, nsPerPixelGuess));
    }

    std::vector<MotionScale> ofLooks_;
};

// Pixels of an edge of the window divided by `scale`, rounded up, at least 1.
int scaledEdge(int windowEdge, int scale);

}  // namespace macula::app
