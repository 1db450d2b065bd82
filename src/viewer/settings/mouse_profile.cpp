#include "viewer/settings/mouse_profile.h"

#include <algorithm>

namespace macula::viewer {

namespace {

const MouseProfile* used = &kMouseProfiles.front();

}  // namespace

const MouseProfile& mouseProfile() {
    return *used;
}

void useMouseProfile(const QString& name) {
    const auto* found = std::ranges::find_if(
        kMouseProfiles, [&](const MouseProfile& each) { return name == QLatin1String(each.name); });
    used = found == kMouseProfiles.end() ? &kMouseProfiles.front() : found;
}

}  // namespace macula::viewer
