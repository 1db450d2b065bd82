// Plots of curves as SVG, for reports of benchmarks.
#pragma once

#include <string>
#include <vector>

namespace macula::evaluate {

struct Curve {
    std::string name;
    std::vector<double> x;  // as many as y; above 0 for a logarithmic axis
    std::vector<double> y;
    bool dashed = false;
};

struct Plot {
    std::string title;
    std::string xTitle;
    std::string yTitle;
    bool logarithmicX = false;
    bool logarithmicY = false;
    std::vector<Curve> curves;  // plots skip points that are not finite
};

// Draws plots one below the other.
std::string toSvg(const std::vector<Plot>& plots);

}  // namespace macula::evaluate
