#include "pipeline/trace/quality.h"

#include <algorithm>
#include <cmath>

#include "pipeline/volume/json_reader.h"

namespace macula::trace {

namespace {

double whole(const JsonNode& node, double low, double high) {
    const double number = node.number({low, high});
    if (number != std::floor(number)) node.fail(Text("a whole number"));
    return number;
}

}  // namespace

Result<Quality> qualityFromJson(std::string_view text, const std::string& where) {
    const JsonDocument document(text, where);
    MACULA_TRY_VOID(document.status());
    const JsonNode root = document.root();
    root.allowOnly({"version", "name", "title", "samplesPerPixel", "bounces", "filter", "denoise"});
    if (root["version"].number() != 1.0)
        root["version"].fail(Text("version 1; newer ones need a newer Macula"));
    const std::string filter = root["filter"].text();
    const auto known =
        std::find_if(kFilters.begin(), kFilters.end(), [&](Filter one) { return nameOf(one) == filter; });
    if (known == kFilters.end())
        root["filter"].fail(Text("\"trilinear\", \"stochastic\", \"smooth\" or \"sharp\""));
    const Quality quality{
        .name = root["name"].text(),
        .title = root["title"].text(),
        .samplesPerPixel = static_cast<std::uint32_t>(whole(root["samplesPerPixel"], 1, 1 << 20)),
        .bounces = static_cast<int>(whole(root["bounces"], 1, kMaxBounces)),
        .filter = known == kFilters.end() ? Filter::trilinear : *known,
        .denoising = root["denoise"].boolean() ? Denoising::on : Denoising::off};
    MACULA_TRY_VOID(document.status());
    return quality;
}

}  // namespace macula::trace
