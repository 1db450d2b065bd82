#include "evaluate/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace macula::evaluate {

namespace {

constexpr double kWidth = 720.0;
constexpr double kHeight = 420.0;
constexpr double kLeft = 70.0;
constexpr double kRight = 220.0;  // for the names
constexpr double kTop = 40.0;
constexpr double kBottom = 50.0;
// Distinguishable with colour blindness, too (Okabe and Ito 2008).
constexpr std::array kColours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                              "#E69F00", "#56B4E9", "#000000", "#999999"};

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '&':
                result += "&amp;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

// Maps values to places between 0 and 1, and finds round numbers for labels.
class Axis {
  public:
    Axis(bool logarithmic, double low, double high) : logarithmic_(logarithmic) {
        if (!(low < high)) high = low + (logarithmic ? low : 1.0);
        low_ = logarithmic ? std::floor(std::log10(low)) : low;
        high_ = logarithmic ? std::ceil(std::log10(high)) : high;
        if (logarithmic) return;
        const double rough = (high - low) / 5.0;
        const double power = std::pow(10.0, std::floor(std::log10(rough)));
        for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
            step_ = factor * power;
            if (step_ >= rough) break;
        }
        low_ = std::floor(low / step_) * step_;
        high_ = std::ceil(high / step_) * step_;
    }

    double place(double value) const {
        return ((logarithmic_ ? std::log10(value) : value) - low_) / (high_ - low_);
    }
    std::vector<double> marks() const {
        std::vector<double> result;
        const double step = logarithmic_ ? 1.0 : step_;
        for (int i = 0; low_ + i * step <= high_ + 1e-9 * step; ++i)
            result.push_back(logarithmic_ ? std::pow(10.0, low_ + i) : low_ + i * step);
        return result;
    }

  private:
    bool logarithmic_;
    double low_ = 0.0;
    double high_ = 1.0;
    double step_ = 1.0;
};

bool isShown(const Plot& plot, double x, double y) {
    return std::isfinite(x) && std::isfinite(y) && (!plot.logarithmicX || x > 0.0) &&
           (!plot.logarithmicY || y > 0.0);
}

void draw(const Plot& plot, double offset, std::string& svg) {
    double lowX = std::numeric_limits<double>::max();
    double highX = std::numeric_limits<double>::lowest();
    double lowY = lowX;
    double highY = highX;
    for (const Curve& curve : plot.curves) {
        for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
            if (!isShown(plot, curve.x[i], curve.y[i])) continue;
            lowX = std::min(lowX, curve.x[i]);
            highX = std::max(highX, curve.x[i]);
            lowY = std::min(lowY, curve.y[i]);
            highY = std::max(highY, curve.y[i]);
        }
    }
    if (lowX > highX) return;
    const Axis xAxis(plot.logarithmicX, lowX, highX);
    const Axis yAxis(plot.logarithmicY, lowY, highY);
    const auto atX = [&](double x) { return kLeft + xAxis.place(x) * (kWidth - kLeft - kRight); };
    const auto atY = [&](double y) {
        return offset + kHeight - kBottom - yAxis.place(y) * (kHeight - kTop - kBottom);
    };
    svg += fmt::format("<text x=\"{}\" y=\"{}\" font-weight=\"bold\">{}</text>\n", kLeft, offset + 24,
                       escaped(plot.title));
    for (const double x : xAxis.marks()) {
        svg += fmt::format(
            "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\" stroke=\"#ddd\"/>"
            "<text x=\"{0:.1f}\" y=\"{3:.1f}\" text-anchor=\"middle\">{4:g}</text>\n",
            atX(x), offset + kTop, offset + kHeight - kBottom, offset + kHeight - kBottom + 16, x);
    }
    for (const double y : yAxis.marks()) {
        svg += fmt::format(
            "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#ddd\"/>"
            "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:g}</text>\n",
            kLeft, kWidth - kRight, atY(y), kLeft - 6, atY(y) + 4, y);
    }
    svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                       0.5 * (kLeft + kWidth - kRight), offset + kHeight - 12, escaped(plot.xTitle));
    svg += fmt::format("<text transform=\"translate(16 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                       offset + 0.5 * (kHeight + kTop - kBottom), escaped(plot.yTitle));
    for (std::size_t c = 0; c < plot.curves.size(); ++c) {
        const Curve& curve = plot.curves[c];
        const char* colour = kColours[c % kColours.size()];
        std::string points;
        for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
            if (!isShown(plot, curve.x[i], curve.y[i])) continue;
            points += fmt::format("{:.1f},{:.1f} ", atX(curve.x[i]), atY(curve.y[i]));
            svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", atX(curve.x[i]),
                               atY(curve.y[i]), colour);
        }
        const char* dashes = curve.dashed ? " stroke-dasharray=\"5 3\"" : "";
        svg += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"{}/>\n",
                           points, colour, dashes);
        const double y = offset + kTop + 18.0 * static_cast<double>(c);
        svg += fmt::format(
            "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2}\" y2=\"{2}\" stroke=\"{3}\" stroke-width=\"2\"{4}/>"
            "<text x=\"{5}\" y=\"{6}\">{7}</text>\n",
            kWidth - kRight + 12, kWidth - kRight + 36, y, colour, dashes, kWidth - kRight + 42, y + 4,
            escaped(curve.name));
    }
}

}  // namespace

std::string toSvg(const std::vector<Plot>& plots) {
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
        "fill=\"white\"/>\n",
        kWidth, kHeight * static_cast<double>(plots.size()));
    for (std::size_t i = 0; i < plots.size(); ++i) draw(plots[i], kHeight * static_cast<double>(i), svg);
    return svg + "</svg>\n";
}

}  // namespace macula::evaluate
