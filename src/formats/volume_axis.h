// What lies along the fourth axis of a NIfTI or NRRD file: times, or what else tells its volumes apart.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace macula::formats {

struct VolumeAxis {
    // "ms" for times, whatever the file counts them in; of a spectrum "Hz", "ppm" or "rad/s"; empty: the file
    // names none.
    std::string unit;
    double first = 0.0;
    std::optional<double> step;  // not 0; nothing: the file does not tell how far apart the volumes are
    std::vector<double> listed;  // rising; one for each volume where the file lists them, otherwise empty

    bool isOfTimes() const { return unit == "ms"; }
    // Of a volume, from 0, in `unit`.
    std::optional<double> at(std::size_t volume) const {
        if (volume < listed.size()) return listed[volume];
        if (!step || !listed.empty()) return std::nullopt;
        const double value = first + *step * double(volume);
        return std::isfinite(value) ? std::optional(value) : std::nullopt;
    }
};

}  // namespace macula::formats
