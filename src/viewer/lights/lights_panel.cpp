#include "viewer/lights/lights_panel.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QIcon>
#include <QPixmap>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "base/srgb.h"
#include "pipeline/trace/light_rig_json.h"
#include "scene/state/parameters.h"
#include "viewer/clip/wheel_guard.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/status/say.h"
#include "viewer/status/status_texts.h"
#include "viewer/transfer/encoded_colour.h"

namespace macula::viewer {

namespace {

constexpr int kSwatchPx = 16;
constexpr int kGainDecimals = 6;  // enough for the smallest exposure

// Scales the colour to the brightest that the screen shows: another field has the strength.
QColor shownColour(const glm::dvec3& linear) {
    const double most = std::max({linear.r, linear.g, linear.b, 1e-6});
    return colourOf(
        {encodedSrgb(linear.r / most), encodedSrgb(linear.g / most), encodedSrgb(linear.b / most)});
}

glm::dvec3 linearOf(const QColor& colour) {
    const glm::dvec3 shown = encodedFrom(colour);
    return {decodedSrgb(shown.r), decodedSrgb(shown.g), decodedSrgb(shown.b)};
}

void put(QDoubleSpinBox& box, double value) {
    const QSignalBlocker quiet(box);
    box.setValue(value);
}

}  // namespace

LightsPanel::LightsPanel(StudyEditor& session, LightsEditing& editing, QWidget* parent)
    : QWidget(parent), session_(session), editing_(editing), trouble_(new QLabel(this)) {
    makePlain(*trouble_, "lights-trouble");
    auto* column = new QVBoxLayout(this);
    column->addWidget(makeRig());
    column->addWidget(makeLight());
    column->addWidget(makeAll());
    column->addWidget(trouble_);
    column->addStretch(1);
    say(*trouble_, {});
    connect(&editing_, &LightsEditing::changed, this, &LightsPanel::showState);
    showState();
}

// A spin box that is destroyed while it has the focus still emits its signals.
LightsPanel::~LightsPanel() {
    dropDialog();
    for (QDoubleSpinBox* box : findChildren<QDoubleSpinBox*>()) box->disconnect(this);
}

QDoubleSpinBox* LightsPanel::makeNumber(const char* name, const QString& title, const QString& suffix,
                                        const QString& does) {
    auto* box = new QDoubleSpinBox(this);
    describe(*box, name, title, does);
    box->setSuffix(suffix);
    box->setDecimals(suffix.isEmpty() ? 2 : 1);
    box->setKeyboardTracking(false);  // a half-typed number changes nothing
    (new WheelGuard(box))->watch(*box);
    connect(box, &QDoubleSpinBox::editingFinished, &session_, &StudyEditor::endDrag);
    return box;
}

QWidget* LightsPanel::makeRig() {
    auto* part = new QWidget(this);
    rigs_ = new QComboBox(part);
    describe(*rigs_, "lights-rig", tr("Rig of lights"), tr("Where the light comes from"));
    rigs_->setPlaceholderText(tr("Own"));
    for (const auto& rig : session_.catalogue().lights) rigs_->addItem(titleOr(rig->title, rig->name));
    connect(rigs_, &QComboBox::activated, this, [this](int index) {
        say(*trouble_, {});
        editing_.use(session_.catalogue().lights.at(std::size_t(index)));
    });
    auto* open = new QPushButton(tr("Open…"), part);
    describe(*open, "lights-open", tr("Open lights of a file"),
             tr("Lights that were saved here, or a light rig of your own (JSON)"));
    auto* save = new QPushButton(tr("Save…"), part);
    describe(*save, "lights-save", tr("Save the lights to a file"),
             tr("For other studies, and for --lights"));
    connect(open, &QPushButton::clicked, this, &LightsPanel::openAsked);
    connect(save, &QPushButton::clicked, this, &LightsPanel::saveAsked);
    auto* row = new QHBoxLayout(part);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(rigs_, 1);
    row->addWidget(open);
    row->addWidget(save);
    return part;
}

QWidget* LightsPanel::makeLight() {
    auto* group = new QGroupBox(tr("One light: drag it in the picture"), this);
    auto* form = new QFormLayout(group);
    lights_ = new QComboBox(group);
    describe(*lights_, "lights-light", tr("Which light"), tr("The light that the numbers below are of"));
    connect(lights_, &QComboBox::activated, this, [this](int index) { editing_.choose(std::size_t(index)); });
    add_ = new QPushButton(tr("Add"), group);
    describe(*add_, "lights-add", tr("Add a light"),
             tr("One more light, from above the viewer's left shoulder"));
    remove_ = new QPushButton(tr("Remove"), group);
    describe(*remove_, "lights-remove", tr("Remove this light"), tr("Take the chosen light out of the rig"));
    connect(add_, &QPushButton::clicked, this, [this] {
        Q_EMIT lookedAt();
        tryTo(editing_.add());
    });
    connect(remove_, &QPushButton::clicked, this, [this] { tryTo(editing_.remove()); });
    auto* which = new QHBoxLayout;
    which->addWidget(lights_, 1);
    which->addWidget(add_);
    which->addWidget(remove_);
    form->addRow(which);

    azimuth_ = makeNumber("lights-azimuth", tr("Azimuth"), tr("°"),
                          tr("In °: 0 is anterior, or the viewer; positive to the patient's left, or to the "
                             "right of the picture"));
    azimuth_->setRange(-180.0, 180.0);
    azimuth_->setWrapping(true);
    azimuth_->setSingleStep(5.0);
    elevation_ = makeNumber("lights-elevation", tr("Elevation"), tr("°"),
                            tr("In °: positive is superior, or up in the picture"));
    elevation_->setRange(-90.0, 90.0);
    elevation_->setSingleStep(5.0);
    size_ = makeNumber(
        "lights-size", tr("Radius"), tr("°"),
        tr("Of the disc on the sky, in °: smaller is harder, with sharper shadows and highlights"));
    size_->setRange(trace::kLeastLightRadiusDeg, trace::kMostLightRadiusDeg);
    strength_ = makeNumber("lights-strength", tr("Strength"), {},
                           tr("Radiance of the disc; in the picture Shift and the wheel"));
    strength_->setRange(0.0, trace::kMostRadiance);
    strength_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    using Light = trace::SoftLight;
    const auto connectTo = [this](QDoubleSpinBox& box, double Light::*number) {
        connect(&box, &QDoubleSpinBox::valueChanged, this,
                [this, number](double value) { changeLight([&](Light& light) { light.*number = value; }); });
    };
    connectTo(*azimuth_, &Light::azimuthDeg);
    connectTo(*elevation_, &Light::elevationDeg);
    connectTo(*size_, &Light::angularRadiusDeg);
    connectTo(*strength_, &Light::radiance);
    colour_ = new QPushButton(tr("Colour…"), group);
    describe(*colour_, "lights-colour", tr("Colour of this light"),
             tr("Choose the colour of this light (sRGB); its strength is a number of its own"));
    connect(colour_, &QPushButton::clicked, this, &LightsPanel::askColour);
    form->addRow(tr("Azimuth"), azimuth_);
    form->addRow(tr("Elevation"), elevation_);
    form->addRow(tr("Radius"), size_);
    form->addRow(tr("Strength"), strength_);
    form->addRow(colour_);
    return group;
}

QWidget* LightsPanel::makeAll() {
    auto* group = new QGroupBox(tr("All lights"), this);
    auto* form = new QFormLayout(group);
    frames_ = new QComboBox(group);
    frames_->setObjectName(QStringLiteral("lights-frame"));
    frames_->setAccessibleName(tr("What the lights keep to"));
    frames_->addItems({tr("the patient"), tr("the camera")});
    frames_->setToolTip(tr("Lights that keep to the camera leave the preview in motion without a model"));
    connect(frames_, &QComboBox::activated, this, [this](int index) {
        Q_EMIT lookedAt();
        tryTo(editing_.keepTo(index == 1 ? trace::LightFrame::camera : trace::LightFrame::patient));
    });
    sky_ = makeNumber("lights-sky", tr("Sky"), {},
                      tr("Light from everywhere: less shows more relief, more shows what lies in shadow"));
    sky_->setRange(0.0, trace::kMostRadiance);
    sky_->setSingleStep(0.05);
    connect(sky_, &QDoubleSpinBox::valueChanged, this,
            [this](double value) { tryTo(editing_.setSky(value)); });
    const auto parameterBox = [this](const char* name, const QString& title, const char* id,
                                     const QString& suffix, const QString& does) {
        QDoubleSpinBox* box = makeNumber(name, title, suffix, does);
        if (suffix.isEmpty()) {
            box->setDecimals(kGainDecimals);
            box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        }
        box->setRange(scene::parameter(id).low, scene::parameter(id).high);
        connect(box, &QDoubleSpinBox::valueChanged, this,
                [this, id](double value) { setParameter(id, value); });
        return box;
    };
    turned_ = parameterBox("lights-turned", tr("Turned"), "lightRotationDeg", tr("°"),
                           tr("All lights about the vertical, in °; positive to the patient's left"));
    turned_->setSingleStep(5.0);
    allStrength_ = parameterBox("lights-all-strength", tr("Strength of all"), "lightStrength", {},
                                tr("Multiplies all lights and the sky"));
    exposure_ = parameterBox("lights-exposure", tr("Exposure"), "exposure", {},
                             tr("Multiplies the picture before the tone map"));
    meter_ = new QPushButton(tr("Automatic"), group);
    describe(*meter_, "lights-meter", tr("Find the exposure"),
             tr("Once, for what is seen now, as a camera does; it stays until it is changed"));
    connect(meter_, &QPushButton::clicked, this, &LightsPanel::meteringAsked);
    auto* exposure = new QHBoxLayout;
    exposure->addWidget(exposure_, 1);
    exposure->addWidget(meter_);
    form->addRow(tr("Keep to"), frames_);
    form->addRow(tr("Sky"), sky_);
    form->addRow(tr("Turned"), turned_);
    form->addRow(tr("Strength of all"), allStrength_);
    form->addRow(tr("Exposure"), exposure);
    return group;
}

void LightsPanel::tryTo(const Result<void>& done) {
    say(*trouble_, done ? QString() : inWindowsLanguage(done.error()));
    if (!done) showState();  // the controls return to the session's lights
}

void LightsPanel::tell(const Error& error) {
    say(*trouble_, inWindowsLanguage(error));
}

void LightsPanel::setMetering(bool isMetering) {
    isMetering_ = isMetering;
    showState();
}

void LightsPanel::changeLight(const std::function<void(trace::SoftLight&)>& edit) {
    const trace::SoftLight* light = editing_.light();
    if (light == nullptr) return;
    trace::SoftLight next = *light;
    edit(next);
    tryTo(editing_.drag(next));
}

void LightsPanel::setParameter(const char* id, double value) {
    if (!session_.hasStudy()) return;
    const scene::Parameter& parameter = scene::parameter(id);
    session_.drag(tr("Lights"), [&](scene::StudyState& next) {
        parameter.set(next.settings, std::clamp(value, parameter.low, parameter.high));
    });
}

void LightsPanel::askColour() {
    const trace::SoftLight* light = editing_.light();
    if (light == nullptr) return;
    if (dialog_) return dialog_->raise();
    const auto before = session_.state().lights;
    dialog_ = new QColorDialog(shownColour(light->colour), this);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    dialog_->setWindowTitle(tr("Colour of the light"));
    const auto paint = [this](const glm::dvec3& colour) {
        changeLight([&](trace::SoftLight& next) { next.colour = colour; });
    };
    connect(dialog_, &QColorDialog::currentColorChanged, this, [paint](const QColor& colour) {
        if (colour.isValid()) paint(linearOf(colour));
    });
    connect(dialog_, &QDialog::rejected, this, [this, before] { editing_.dragBack(before); });
    connect(dialog_, &QDialog::finished, &session_, &StudyEditor::endDrag);
    dialog_->open();
}

void LightsPanel::dropDialog() {
    if (!dialog_) return;
    dialog_->disconnect(this);
    dialog_->close();
}

void LightsPanel::showState() {
    const bool isUsable = editing_.isUsable();
    for (QWidget* part : findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
        if (part != trouble_) part->setEnabled(isUsable);
    const auto rig = editing_.rig();
    showRig(*rig);
    showLight(editing_.light());
    meter_->setEnabled(isUsable && !isMetering_);
    const trace::Settings& settings = session_.state().settings;
    put(*turned_, settings.lightRotationDeg);
    put(*allStrength_, settings.lightStrength);
    put(*exposure_, settings.exposure);
    put(*sky_, scene::skyOf(*rig));
}

void LightsPanel::showRig(const trace::LightRig& rig) {
    const auto& listed = session_.catalogue().lights;
    const auto found =
        std::find_if(listed.begin(), listed.end(), [&](const auto& item) { return *item == rig; });
    rigs_->setCurrentIndex(found == listed.end() ? -1 : int(found - listed.begin()));
    frames_->setCurrentIndex(rig.frame == trace::LightFrame::camera ? 1 : 0);
    lights_->clear();
    for (std::size_t i = 0; i < rig.lights.size(); ++i) lights_->addItem(tr("Light %1").arg(i + 1));
    lights_->setCurrentIndex(rig.lights.empty() ? -1 : int(editing_.chosen()));
    add_->setEnabled(editing_.isUsable() && rig.lights.size() < trace::kMostLights);
}

void LightsPanel::showLight(const trace::SoftLight* light) {
    const bool isThere = light != nullptr && editing_.isUsable();
    for (QWidget* part :
         {static_cast<QWidget*>(lights_), static_cast<QWidget*>(remove_), static_cast<QWidget*>(azimuth_),
          static_cast<QWidget*>(elevation_), static_cast<QWidget*>(size_), static_cast<QWidget*>(strength_),
          static_cast<QWidget*>(colour_)})
        part->setEnabled(isThere);
    const trace::SoftLight shown = light != nullptr ? *light : trace::SoftLight{.radiance = 0.0};
    put(*azimuth_, std::remainder(shown.azimuthDeg, 360.0));
    put(*elevation_, shown.elevationDeg);
    put(*size_, shown.angularRadiusDeg);
    put(*strength_, shown.radiance);
    QPixmap swatch(QSize(kSwatchPx, kSwatchPx));
    swatch.fill(shownColour(shown.colour));
    colour_->setIcon(QIcon(swatch));
}

}  // namespace macula::viewer
