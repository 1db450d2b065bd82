// The numbers of a preset's matter in the window: what is typed there is in the session's preset.
#include "viewer/transfer/matter_fields.h"

#include <QPushButton>
#include <QTest>
#include <memory>
#include <optional>
#include <vector>

#include "base/phantom.h"
#include "pipeline/volume/volume_fit.h"
#include "scene/choice/catalogue.h"
#include "viewer/offscreen.h"
#include "viewer/transfer/transfer_function_editor.h"

namespace macula::viewer {
namespace {

class MatterFieldsTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        auto catalogue = scene::builtInCatalogue();
        ASSERT_TRUE(catalogue.ok());
        session_.emplace(*std::move(catalogue));
        editor_.emplace(*session_);
        editor_->resize(420, 520);
        editor_->show();
    }
    void TearDown() override {
        editor_.reset();
        session_.reset();
        OffscreenTest::TearDown();
    }

    std::shared_ptr<const TransferFunction> preset(const char* name) const {
        return *scene::findPreset(session_->catalogue(), name);
    }
    void show(Volume volume, const char* name) {
        scene::StudyState state;
        state.preset = preset(name);
        session_->show({.volume = std::make_shared<const Volume>(std::move(volume))}, state);
        ASSERT_TRUE(waitUntil([&] { return !editor_->isCounting(); }));
    }
    void showPhantom(const char* name) { show(phantom::make({.size = {16, 16, 16}}), name); }
    QDoubleSpinBox& field(const char* id) {
        return *editor_->findChild<QDoubleSpinBox*>(QStringLiteral("matter-") + QString::fromLatin1(id));
    }
    QPushButton& button(const char* name) {
        return *editor_->findChild<QPushButton*>(QString::fromLatin1(name));
    }
    const TransferFunction& now() const { return *session_->state().preset; }
    static void type(QDoubleSpinBox& field, const char* number) {
        field.selectAll();
        QTest::keyClicks(&field, QString::fromLatin1(number));
        QTest::keyClick(&field, Qt::Key_Enter);
    }

    std::optional<StudyEditor> session_;
    std::optional<TransferFunctionEditor> editor_;
};

TEST_F(MatterFieldsTest, AreThereForEachNumberAndFoldedAtFirst) {
    for (const scene::MatterParameter& p : scene::matterParameters()) {
        const QDoubleSpinBox& each = field(std::string(p.id).c_str());
        EXPECT_FALSE(each.isEnabled()) << p.id << ": there is no study";
        EXPECT_FALSE(each.isVisible()) << p.id;
        EXPECT_FALSE(each.accessibleName().isEmpty() || each.toolTip().isEmpty()) << p.id;
    }
    showPhantom("cinematic-bone");
    const QPoint place = button("transfer-matter").pos();
    const int curve = editor_->curve().height();
    QTest::mouseClick(&button("transfer-matter"), Qt::LeftButton);
    settle();
    EXPECT_TRUE(field("roughness").isVisible());
    EXPECT_TRUE(field("roughness").isEnabled());
    EXPECT_EQ(button("transfer-matter").pos(), place) << "the same click folds them again";
    EXPECT_LT(editor_->curve().height(), curve);
    QTest::mouseClick(&button("transfer-matter"), Qt::LeftButton);
    EXPECT_FALSE(field("roughness").isVisible());
}

TEST_F(MatterFieldsTest, ShowWhatThePresetHas) {
    showPhantom("cinematic-bone");
    const Surface& surface = now().surface;
    EXPECT_NEAR(field("surfaceWeight").value(), surface.weight, 1e-3);
    EXPECT_NEAR(field("surfaceGradientPerMm").value(), surface.gradientPerMm, 1e-2);
    EXPECT_EQ(field("surfaceGradientPerMm").suffix(), " HU/mm");
    EXPECT_NEAR(field("roughness").value(), surface.roughness, 1e-3);
    EXPECT_NEAR(field("reflectance").value(), surface.reflectance, 1e-3);
    EXPECT_NEAR(field("anisotropy").value(), now().anisotropy, 1e-3);
    EXPECT_FALSE(session_->canUndo()) << "what is shown is rounded, what is kept is not";
}

TEST_F(MatterFieldsTest, ANumberThatIsTypedIsOneStepAndMakesACopy) {
    showPhantom("cinematic-bone");
    const auto before = session_->state().preset;
    type(field("roughness"), "0.25");
    TransferFunction wanted = now();
    EXPECT_EQ(wanted.name, "cinematic-bone-edited");
    EXPECT_EQ(wanted.surface.roughness, 0.25);
    wanted.surface.roughness = before->surface.roughness;
    EXPECT_EQ(wanted.surface, before->surface);
    EXPECT_EQ(wanted.opacity, before->opacity);
    EXPECT_EQ(wanted.anisotropy, before->anisotropy);
    session_->undo();
    EXPECT_EQ(session_->state().preset, before);
    EXPECT_FALSE(session_->canUndo());
    EXPECT_NEAR(field("roughness").value(), before->surface.roughness, 1e-3);
    session_->redo();
    EXPECT_EQ(field("roughness").value(), 0.25);
}

// As a hand on the arrows does it: many values, then the focus goes.
TEST_F(MatterFieldsTest, StepsOfOneFieldAreOneStepOfUndo) {
    showPhantom("cinematic-bone");
    const auto before = session_->state().preset;
    for (int i = 0; i < 3; ++i) QTest::keyClick(&field("anisotropy"), Qt::Key_Up);
    QTest::keyClick(&field("anisotropy"), Qt::Key_Enter);
    EXPECT_NEAR(now().anisotropy, before->anisotropy + 0.15, 1e-9);
    type(field("reflectance"), "0.5");
    session_->undo();
    EXPECT_EQ(now().surface.reflectance, before->surface.reflectance);
    EXPECT_NEAR(now().anisotropy, before->anisotropy + 0.15, 1e-9);
    session_->undo();
    EXPECT_EQ(session_->state().preset, before);
    EXPECT_FALSE(session_->canUndo());
}

TEST_F(MatterFieldsTest, APresetWithoutSurfaceGetsOne) {
    showPhantom("ct-bone");
    ASSERT_EQ(now().surface, Surface{});
    type(field("surfaceWeight"), "0.8");
    EXPECT_EQ(now().surface.weight, 0.8);
    EXPECT_EQ(now().surface.roughness, Surface{}.roughness);
    EXPECT_TRUE(validate(now()).ok());
    QTest::mouseClick(&button("transfer-reset"), Qt::LeftButton);
    EXPECT_EQ(now().surface, Surface{});
    EXPECT_EQ(field("surfaceWeight").value(), 0.0);
}

TEST_F(MatterFieldsTest, NoNumberMakesAPresetThatIsNotValid) {
    showPhantom("ct-bone");
    for (const scene::MatterParameter& p : scene::matterParameters()) {
        for (const char* number : {"0", "-1e9", "9999999", "-0.5", "0.001"}) {
            type(field(std::string(p.id).c_str()), number);
            ASSERT_TRUE(validate(now()).ok()) << p.id << " " << number;
            EXPECT_GE(p.get(now()), p.low) << p.id << " " << number;
            EXPECT_LE(p.get(now()), p.high) << p.id << " " << number;
        }
    }
}

// Where a preset is stretched to the volume, a gradient is told in the volume's values, as the curve is.
TEST_F(MatterFieldsTest, AGradientIsThatOfTheVolume) {
    std::vector<std::uint16_t> voxels(20 * 20 * 20);
    for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = std::uint16_t((i * i) % 3001);
    const Volume volume =
        *Volume::create({.size = glm::ivec3(20), .unit = Unit::raw, .modality = "MR"}, voxels);
    show(volume, "cinematic-mr");
    auto& gradient = field("surfaceGradientPerMm");
    ASSERT_TRUE(gradient.isEnabled());
    const double drawn = fitted(now(), volume).surface.gradientPerMm;
    EXPECT_NE(drawn, now().surface.gradientPerMm);
    EXPECT_NEAR(gradient.value(), drawn, 1e-3);
    EXPECT_EQ(gradient.suffix(), " per mm");
    type(gradient, "250");
    EXPECT_NEAR(fitted(now(), volume).surface.gradientPerMm, 250.0, 1e-9);
    EXPECT_EQ(gradient.value(), 250.0);
}

}  // namespace
}  // namespace macula::viewer
