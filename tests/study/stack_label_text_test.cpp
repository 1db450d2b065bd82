#include "study/open/stack_label_text.h"

#include <gtest/gtest.h>

namespace macula::study {
namespace {

std::string said(const char* attribute, const char* value) {
    return textOf({.attribute = attribute, .value = value}).english();
}

TEST(StackLabelText, ATimeIsThatOfAClock) {
    EXPECT_EQ(said("ContentTime", "19910520100530"), "at 10:05:30");
    EXPECT_EQ(said("AcquisitionTime", "20240131100530.250000"), "at 10:05:30.25");
    EXPECT_EQ(said("AcquisitionTime", "20240131235959.999+0100"), "at 24:00:00") << "rounded up";
    EXPECT_EQ(said("ContentTime", "0905"), "at 09:05:00");
}

TEST(StackLabelText, AnOrientationIsThePlaneThatItIsNearestTo) {
    EXPECT_EQ(said("ImageOrientationPatient", "1\\0\\0\\0\\1\\0"), "axial");
    EXPECT_EQ(said("ImageOrientationPatient", "1\\0\\0\\0\\0\\-1"), "coronal");
    EXPECT_EQ(said("ImageOrientationPatient", "0.0349\\0.9994\\0\\0\\0\\-1"), "oblique sagittal");
    EXPECT_EQ(said("ImageOrientationPatient", "1\\0\\0\\0\\0.999962\\0.008727"), "axial") << "half a degree";
    EXPECT_EQ(said("ImageOrientationPatient", "1\\0\\0\\0\\0.9397\\0.3420"), "oblique axial");
}

TEST(StackLabelText, NumbersHaveTheirUnit) {
    EXPECT_EQ(said("EchoTime", "4.6"), "TE 4.6 ms");
    EXPECT_EQ(said("KVP", "120"), "120 kV");
    EXPECT_EQ(said("DiffusionBValue", "1000"), "b 1000 s/mm²");
    EXPECT_EQ(said("PixelSpacing", "0.703125\\0.703125"), "pixels 0.7031 × 0.7031 mm");
    EXPECT_EQ(said("ImageType", "ORIGINAL\\PRIMARY\\AXIAL"), "image type ORIGINAL, PRIMARY, AXIAL");
}

TEST(StackLabelText, OfAUidTheEndIsTold) {
    EXPECT_EQ(said("FrameOfReferenceUID", "1.2.840.113619.2.1.1.322987881.621.736170080.681"),
              "frame of reference UID …21.736170080.681");
    EXPECT_EQ(said("SOPClassUID", "1.2.3"), "SOP class UID 1.2.3");
}

// Nothing is made up of what cannot be read.
TEST(StackLabelText, WhatCannotBeReadStandsAsItIs) {
    EXPECT_EQ(said("ContentTime", "yesterday"), "content time yesterday");
    EXPECT_EQ(said("ContentTime", "20240131"), "content time 20240131") << "a date has no time";
    EXPECT_EQ(said("ImageOrientationPatient", "1\\0\\0"), "image orientation patient 1, 0, 0");
    EXPECT_EQ(said("ImageOrientationPatient", "0\\0\\0\\0\\0\\0"),
              "image orientation patient 0, 0, 0, 0, 0, 0");
    EXPECT_EQ(said("ConvolutionKernel", ""), "no convolution kernel");
    EXPECT_EQ(said("RRIntervalVector", "2"), "RR interval vector 2");
    EXPECT_EQ(said("Repetition", "2"), "repetition 2");
}

}  // namespace
}  // namespace macula::study
