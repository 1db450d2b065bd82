// The points of a plotted transfer function and their edits, without a widget.
#include <gtest/gtest.h>

#include "viewer/transfer/transfer_edits.h"
#include "viewer/transfer/transfer_plot.h"

namespace macula::viewer {
namespace {

using Curve = PointId::Curve;

class TransferPlotTest : public testing::Test {
  protected:
    TransferPlotTest() {
        TransferFunction function;
        function.opacity = {{.value = 0.0, .opacity = 0.0}, {.value = 100.0, .opacity = 1.0}};
        function.colour = {{.value = 50.0, .colour = {1.0, 0.0, 0.0}}};
        plot_.setFunction(function, {.scale = 2.0, .offset = 10.0}, QStringLiteral("HU"));
        plot_.fitAxis();
    }
    // As the panel does it.
    void accept() {
        for (const auto signal : {&TransferEdits::edited, &TransferEdits::dragged})
            QObject::connect(&edits_, signal, [this](const TransferFunction& wanted) {
                plot_.setFunction(wanted, plot_.map(), plot_.unit());
            });
    }

    TransferPlot plot_{[] {
        return TransferLayout{.plot = {20.0, 10.0, 200.0, 100.0},
                              .strip = {20.0, 120.0, 200.0, 20.0},
                              .axis = {0.0, 140.0, 230.0, 20.0}};
    }};
    TransferEdits edits_{plot_};
};

TEST_F(TransferPlotTest, APointIsFoundWhereItIs) {
    for (const PointId point :
         {PointId{Curve::opacity, 0}, PointId{Curve::opacity, 1}, PointId{Curve::colour, 0}}) {
        const QPointF place = plot_.placeOf(point);
        EXPECT_EQ(plot_.pointAt(place), point);
        EXPECT_EQ(plot_.pointAt(place + QPointF(3.0, -3.0)), point);
        EXPECT_NEAR(plot_.map().shownFrom(plot_.presetValueAt(place.x())), plot_.valueOf(point), 1e-9);
    }
    EXPECT_EQ(plot_.placeOf({Curve::opacity, 1}).y(), 10.0);
    EXPECT_EQ(plot_.opacityAt(plot_.placeOf({Curve::opacity, 0}).y()), 0.0);
    EXPECT_FALSE(plot_.pointAt({20.0, 15.0}));
    EXPECT_EQ(plot_.valueOf({Curve::opacity, 1}), 210.0) << "of the volume";
}

TEST_F(TransferPlotTest, AnAxisThatWasMovedIsNotFitted) {
    int changes = 0;
    QObject::connect(&plot_, &TransferPlot::scalesChanged, [&] { ++changes; });
    EXPECT_TRUE(plot_.isAxisFitted());
    plot_.setAxis(plot_.axis().panned(1000.0));
    EXPECT_FALSE(plot_.isAxisFitted());
    EXPECT_FALSE(plot_.axis().contains(210.0));
    plot_.reveal({Curve::opacity, 1});
    EXPECT_TRUE(plot_.axis().contains(210.0));
    plot_.fitAxis();
    EXPECT_TRUE(plot_.isAxisFitted());
    EXPECT_EQ(changes, 3);
}

TEST_F(TransferPlotTest, TabGoesThroughOpacityThenColour) {
    EXPECT_TRUE(edits_.selectNext(true));
    EXPECT_EQ(edits_.selected(), (PointId{Curve::opacity, 0}));
    EXPECT_TRUE(edits_.selectNext(true));
    EXPECT_TRUE(edits_.selectNext(true));
    EXPECT_EQ(edits_.selected(), (PointId{Curve::colour, 0}));
    EXPECT_FALSE(edits_.selectNext(true));
    EXPECT_FALSE(edits_.selected());
    EXPECT_TRUE(edits_.selectNext(false));
    EXPECT_EQ(edits_.selected(), (PointId{Curve::colour, 0}));
}

TEST_F(TransferPlotTest, AnEditThatNobodyWantsChangesNothing) {
    edits_.select(PointId{Curve::opacity, 0});
    edits_.addBesideSelected();
    EXPECT_EQ(plot_.pointCount(), 3u);
    EXPECT_EQ(edits_.selected(), (PointId{Curve::opacity, 0}));
}

TEST_F(TransferPlotTest, ANewPointLiesHalfwayAndGoesAgain) {
    accept();
    edits_.select(PointId{Curve::opacity, 0});
    edits_.addBesideSelected();
    ASSERT_EQ(plot_.pointCount(), 4u);
    EXPECT_EQ(edits_.selected(), (PointId{Curve::opacity, 1}));
    EXPECT_NEAR(plot_.valueOf({Curve::opacity, 1}), 110.0, 1e-9);
    EXPECT_NEAR(plot_.function().opacity[1].opacity, 0.5, 1e-9);
    edits_.removeSelected();
    EXPECT_EQ(plot_.pointCount(), 3u);
    EXPECT_EQ(edits_.selected(), (PointId{Curve::opacity, 1})) << "the one that has taken its place";
    edits_.select(PointId{Curve::colour, 0});
    edits_.removeSelected();
    EXPECT_EQ(plot_.pointCount(), 3u) << "a curve keeps its only point";
}

}  // namespace
}  // namespace macula::viewer
