// Finds where the sheet begins in each column of one slice, on one side of the body.
#pragma once

#include <optional>
#include <vector>

namespace macula::segment {

// First and last block of the body in one column; low > high where there is none.
struct SurfaceBody {
    int low = 0;
    int high = 0;
};

class SurfaceProfile {
  public:
    // `side` is 1 for the side of larger v, -1 for the other; `middle` divides them where there is no body.
    SurfaceProfile(double uMm, double vMm, int side, const std::vector<SurfaceBody>& body, double middle);

    void add(int u, int v);  // a block of a sheet; ignored when it lies on the other side
    double widthMm() const;  // width of the columns that have a sheet
    // Bridges gaps between two pieces of the sheet, where the body lies on the sheet, and removes columns in
    // which the body reaches through it.
    void bridgeGaps();

    std::optional<int> top(int u) const;  // the sheet's block nearest to the body
    bool touchesBody() const { return touchesBody_; }

  private:
    struct Run {
        int first = 0;
        int last = 0;
    };

    bool hasBody(int u) const;
    double bodyEnd(int u) const;
    std::vector<Run> runs() const;
    void dropWhatLiesBehind();
    void bridge(const Run& left, const Run& right);

    double uMm_;
    double vMm_;
    int side_;
    double middle_;
    const std::vector<SurfaceBody>& body_;
    std::vector<std::optional<double>> top_;  // times side: larger is farther from the body
    bool touchesBody_ = false;
};

}  // namespace macula::segment
