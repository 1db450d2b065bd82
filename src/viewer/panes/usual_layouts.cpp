#include "viewer/panes/usual_layouts.h"

#include <algorithm>

#include "base/sha256.h"
#include "viewer/settings/settings_controller.h"

namespace macula::viewer {

namespace {

constexpr int kMostKinds = 500;
constexpr std::size_t kDigits = 16;

QString kindOf(const Volume& volume) {
    const std::string kind = volume.modality() + "/" + volume.bodyPart();
    return QString::fromStdString(sha256Hex("kind " + kind).substr(0, kDigits));
}

}  // namespace

UsualLayouts::UsualLayouts(StudyEditor& session, SettingsController& settings, QObject* parent)
    : QObject(parent), session_(session), settings_(settings) {
    connect(&session_, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        if (session_.state().layout != before.layout) note(session_.state().layout);
    });
}

std::optional<scene::Layout> UsualLayouts::of(const Volume& volume) const {
    const std::string name = settings_.settings().layouts.value(kindOf(volume)).toStdString();
    const auto isNamed = [&](scene::Layout layout) { return scene::nameOf(layout) == name; };
    const auto* found = std::ranges::find_if(scene::kLayouts, isNamed);
    return found == scene::kLayouts.end() ? std::nullopt : std::optional(*found);
}

void UsualLayouts::note(scene::Layout layout) {
    if (!session_.hasStudy()) return;
    QMap<QString, QString> layouts = settings_.settings().layouts;
    const QString kind = kindOf(*session_.study().volume);
    if (!layouts.contains(kind) && layouts.size() >= kMostKinds) layouts.erase(layouts.begin());
    layouts[kind] = QString::fromLatin1(scene::nameOf(layout).data());
    settings_.keepLayouts(layouts);
}

}  // namespace macula::viewer
