// A plot of curves as SVG: what a benchmark shows a person.
#pragma once

#include <string>
#include <vector>

namespace macula::evaluate {

struct Curve {
    std::string name;
    std::vector<double> x;  // as many as y; for a logarithmic axis above 0
    std::vector<double> y;
    bool dashed = false;
};

struct Plot {
    std::string title;
    std::string xTitle;
    std::string yTitle;
    bool logarithmicX = false;
    bool logarithmicY = false;
    std::vector<Curve> curves;  // points that are not finite are left out
};

// One below the other.
std::string toSvg(const std::vector<Plot>& plots);

}  // namespace macula::evaluate
