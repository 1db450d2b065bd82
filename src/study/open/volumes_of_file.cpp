#include "study/open/volumes_of_file.h"

#include <cmath>
#include <optional>

namespace macula::study {

Text labelOf(const VolumesOfFile& volumes, std::size_t volume) {
    constexpr double kMsPerSecond = 1000.0;
    const std::optional<double> at = volumes.axis.at(volume);
    const std::string& unit = volumes.axis.unit;
    if (!at) return Text("the file does not say when");
    if (volumes.axis.isOfTimes()) {
        const bool isInSeconds =
            std::abs(volumes.axis.at(volumes.count - 1).value_or(*at)) >= 10.0 * kMsPerSecond;
        return isInSeconds ? Text("time {:.6g} s", *at / kMsPerSecond) : Text("time {:.6g} ms", *at);
    }
    if (unit.empty()) return Text("at {:.6g}, in a unit that the file does not name", *at);
    return Text("at {:.6g} {}, which is no time", *at, unit);
}

}  // namespace macula::study
