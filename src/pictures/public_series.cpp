#include "pictures/public_series.h"

#include "base/installation_key.h"
#include "base/log.h"

namespace macula::pictures {

std::string publicSeries(const std::string& seriesDigest) {
    if (seriesDigest.empty() || seriesDigest == "phantom") return seriesDigest;
    const auto key = InstallationKey::ofUser();
    if (key) return key->digestOf(seriesDigest);
    log::warning("Pictures do not say of which series they are: {}", key.error().message.english());
    return "unknown";
}

}  // namespace macula::pictures
