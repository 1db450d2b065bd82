// How many pixels a picture may have while it moves.
#pragma once

#include <cstddef>
#include <vector>

#include "pipeline/trace/look.h"

namespace macula::live {

// Learns the cost of a pixel on this device with this study. From it follows the divisor of the window's
// width and height that keeps a moving picture within the time budget.
class MotionScale {
  public:
    // `nsPerPixelGuess` holds until the first observation.
    explicit MotionScale(double budgetMs, double nsPerPixelGuess);

    // Reports the times of a frame: tracing, which grows with the pixels, and the rest. Counting the rest as
    // tracing would make pixels look costly, and a small picture would never grow again.
    void observe(int width, int height, double traceMs, double otherMs);

    // Returns the divisor: 1, 2, 3, 4, 5, 6, 8, 10, 12 or 16. Chooses a finer one than before only if that
    // leaves a quarter of the budget free, so that the picture does not flicker between two sharpnesses.
    int choose(int windowWidth, int windowHeight);

    double nsPerPixel() const { return nsPerPixel_; }

  private:
    double budgetMs_;
    double nsPerPixel_;
    double otherMs_ = 0.0;
    int last_ = 0;  // 0: none yet
};

// One MotionScale for each look: the pixel cost of one look says nothing about another. With a shared one, a
// projection shown after path tracing would begin with as few pixels.
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

}  // namespace macula::live
