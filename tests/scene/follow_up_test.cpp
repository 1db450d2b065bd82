// Tables of a follow-up against sums and percentages that were computed by hand.
#include "scene/followup/follow_up.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace macula::scene {
namespace {

using slices::Measurement;

// Both axes, along x and y.
Measurement lesion(const std::string& label, double longMm, double shortMm, bool isNode = false) {
    return {.label = label,
            .shape = slices::Bidirectional{.firstMm = {{{0, 0, 0}, {longMm, 0, 0}}},
                                           .secondMm = {{{0, 0, 0}, {0, shortMm, 0}}},
                                           .isNode = isNode}};
}

Measurement node(const std::string& label, double longMm, double shortMm) {
    return lesion(label, longMm, shortMm, true);
}

bool says(const FollowUp& table, std::string_view part) {
    return std::ranges::any_of(
        table.notes, [&](const Text& note) { return note.english().find(part) != std::string::npos; });
}

// Sums by hand: 50 + 20 + 18 (short axis of the node) = 88; 30 + 14 + 12 = 56, which is 36.4 % less; 42 + 18
// + 12 = 72, 28.6 % and 16 mm above 56.
TEST(FollowUpTest, SumsChangesAndCategoriesAreThoseOfTheNumbers) {
    const std::vector<FollowedExam> exams{
        {"20240101", {lesion("Liver", 50, 40), lesion("Lung 1", 20, 15), node("Axilla", 30, 18)}},
        {"20240401", {lesion("Liver", 30, 20), lesion("Lung 1", 14, 10), node("Axilla", 25, 12)}},
        {"20240701", {lesion("liver ", 42, 20), lesion("LUNG 1", 10, 18), node("Axilla", 40, 12)}}};
    const FollowUp table = followUp(exams, 0);
    ASSERT_EQ(table.lesions.size(), 3u);
    EXPECT_EQ(table.lesions[0].label, "Axilla");
    EXPECT_TRUE(table.lesions[0].isNode);
    EXPECT_EQ(table.lesions[1].label, "Liver");
    EXPECT_DOUBLE_EQ(table.lesions[2].sizes[2].mm, 18.0) << "the longer axis, whichever was drawn first";
    ASSERT_EQ(table.sums.size(), 3u);
    EXPECT_DOUBLE_EQ(*table.sums[0].sumMm, 88.0);
    EXPECT_EQ(table.sums[0].response, Response::baseline);
    EXPECT_FALSE(table.sums[0].fromBaseline);
    EXPECT_DOUBLE_EQ(*table.sums[1].sumMm, 56.0);
    EXPECT_NEAR(*table.sums[1].fromBaseline, -32.0 / 88.0, 1e-12);
    EXPECT_EQ(table.sums[1].response, Response::partial);
    EXPECT_DOUBLE_EQ(*table.sums[2].sumMm, 72.0);
    EXPECT_DOUBLE_EQ(*table.sums[2].nadirMm, 56.0);
    EXPECT_NEAR(*table.sums[2].fromNadir, 16.0 / 56.0, 1e-12);
    EXPECT_EQ(table.sums[2].response, Response::progress) << "although it is smaller than at the baseline";
    EXPECT_TRUE(table.notes.empty());
}

Response responseTo(double before, double now) {
    const std::vector<FollowedExam> exams{{"1", {lesion("A", before, 1)}}, {"2", {lesion("A", now, 1)}}};
    return followUp(exams, 0).sums[1].response;
}

TEST(FollowUpTest, LimitsBelongToTheCategory) {
    EXPECT_EQ(responseTo(45.0, 31.5), Response::partial) << "exactly 30 %";
    EXPECT_EQ(responseTo(45.0, 31.6), Response::stable);
    EXPECT_EQ(responseTo(50.0, 60.0), Response::progress) << "exactly 20 %";
    EXPECT_EQ(responseTo(50.0, 59.9), Response::stable);
    EXPECT_EQ(responseTo(20.0, 24.9), Response::stable) << "20 %, but below 5 mm";
    EXPECT_EQ(responseTo(20.0, 25.0), Response::progress) << "exactly 5 mm";
}

TEST(FollowUpTest, WhatIsNotMeasuredIsUnknownUntilAPersonCallsItGone) {
    const std::vector<FollowedExam> exams{{"20240101", {lesion("A", 40, 20), node("N", 30, 20)}},
                                          {"20240401", {node("N", 12, 9.9)}},
                                          {"20240701", {lesion("A", 6, 3), node("N", 12, 9)}}};
    const FollowUp unknown = followUp(exams, 0);
    EXPECT_EQ(unknown.lesions[0].sizes[1].is, LesionSize::Is::missing);
    EXPECT_FALSE(unknown.sums[1].sumMm);
    EXPECT_EQ(unknown.sums[1].response, Response::unknown);
    EXPECT_EQ(nameOf(unknown.sums[1].response), "NE");
    EXPECT_DOUBLE_EQ(*unknown.sums[2].nadirMm, 60.0) << "of the sums that are known";
    const FollowUp gone = followUp(exams, 0, {{"a", 1}});
    EXPECT_EQ(gone.lesions[0].sizes[1].is, LesionSize::Is::gone);
    EXPECT_DOUBLE_EQ(*gone.sums[1].sumMm, 9.9);
    EXPECT_EQ(gone.sums[1].response, Response::complete) << "the node is below 10 mm";
    EXPECT_EQ(gone.sums[2].response, Response::progress) << "15 mm is 5.1 mm and 52 % above 9.9 mm";
}

TEST(FollowUpTest, ANodeOfTenMillimetresIsNotNormal) {
    const auto to = [](double shortMm) {
        const std::vector<FollowedExam> exams{{"1", {node("N", 30, 20)}}, {"2", {node("N", 30, shortMm)}}};
        return followUp(exams, 0).sums[1].response;
    };
    EXPECT_EQ(to(9.99), Response::complete);
    EXPECT_EQ(to(10.0), Response::partial);
}

TEST(FollowUpTest, AfterNothingIsLeftAnySizeIsProgress) {
    const std::vector<FollowedExam> exams{
        {"1", {lesion("A", 40, 20)}}, {"2", {}}, {"3", {lesion("A", 4.9, 2)}}, {"4", {lesion("A", 5, 2)}}};
    const FollowUp table = followUp(exams, 0, {{"a", 1}});
    EXPECT_EQ(table.sums[1].response, Response::complete);
    EXPECT_EQ(table.sums[2].response, Response::progress) << "it is back";
    EXPECT_FALSE(table.sums[2].fromNadir) << "of nothing there is no part";
    EXPECT_EQ(table.sums[3].response, Response::progress);
}

TEST(FollowUpTest, NewLesionsAreListedAndInNoSum) {
    const std::vector<FollowedExam> exams{{"1", {lesion("A", 40, 20)}},
                                          {"2", {lesion("A", 40, 20), lesion("B", 30, 20)}}};
    const FollowUp table = followUp(exams, 0);
    ASSERT_EQ(table.lesions.size(), 2u);
    EXPECT_TRUE(table.lesions[1].isNew);
    EXPECT_DOUBLE_EQ(*table.sums[1].sumMm, 40.0);
    EXPECT_EQ(table.sums[1].response, Response::stable);
    EXPECT_TRUE(says(table, "A new lesion is progressive disease"));
    // With the second as the baseline the first is not compared, and lacks a lesion.
    const FollowUp later = followUp(exams, 1);
    EXPECT_EQ(later.sums[0].response, Response::before);
    EXPECT_DOUBLE_EQ(*later.sums[1].sumMm, 70.0);
    EXPECT_FALSE(later.lesions[1].isNew);
}

TEST(FollowUpTest, SaysWhatItAssumes) {
    const std::vector<FollowedExam> exams{
        {"1",
         {lesion("A", 9, 2), lesion("A", 8, 7), node("N", 20, 14), lesion("3", 30, 1), lesion("4", 30, 1),
          lesion("5", 30, 1), lesion("6", 30, 1)}},
        {"2", {{.label = "N", .shape = slices::Distance{{glm::dvec3(0.0), {7, 0, 0}}}}, lesion("3", 30, 1)}}};
    const FollowUp table = followUp(exams, 0);
    EXPECT_TRUE(says(table, "the longest counts"));
    EXPECT_TRUE(says(table, "counts as one in all"));
    EXPECT_TRUE(says(table, "no short axis"));
    EXPECT_TRUE(says(table, "these are 2"));
    EXPECT_TRUE(says(table, "here are 6"));
    EXPECT_EQ(table.sums[1].response, Response::unknown);
}

TEST(FollowUpTest, WhatIsNoLesionIsLeftOut) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<Measurement> others{{.label = "angle", .shape = slices::Angle{}},
                                    {.label = "arrow", .shape = slices::Arrow{}},
                                    {.label = "ellipse", .shape = slices::Ellipse{}},
                                    lesion("", 10, 5),
                                    lesion("   ", 10, 5),
                                    lesion("nan", nan, 5)};
    const std::vector<FollowedExam> exams{{"1", others}, {"2", {}}};
    const FollowUp table = followUp(exams, 0);
    EXPECT_TRUE(table.lesions.empty());
    EXPECT_FALSE(table.sums[0].sumMm) << "no lesion has no sum";
    EXPECT_EQ(table.sums[1].response, Response::unknown);
    std::vector<Measurement> many;
    for (int i = 0; i < 1000; ++i) many.push_back(lesion("L" + std::to_string(i), 10, 5));
    EXPECT_EQ(followUp(std::vector<FollowedExam>{{"1", many}}, 0).lesions.size(), kMostFollowedLesions);
}

TEST(FollowUpTest, TheTableForOtherProgramsHasEveryNumber) {
    const std::vector<FollowedExam> exams{{"20240101", {lesion("=A", 50, 20), node("N", 30, 20)}},
                                          {"20240401", {lesion("=A", 30, 20), lesion("B", 12, 3)}}};
    EXPECT_EQ(toCsv(followUp(exams, 0, {{"n", 1}})),
              "lesion,axis,at_baseline,20240101_mm,20240401_mm\r\n"
              "'=A,long,yes,50.000,30.000\r\n"
              "N,short (node),yes,20.000,0.000\r\n"
              "B,long,no,,12.000\r\n"
              "sum_mm,,,70.000,30.000\r\n"
              "nadir_before_mm,,,,70.000\r\n"
              "change_from_baseline_percent,,,,-57.1\r\n"
              "change_from_nadir_percent,,,,-57.1\r\n"
              "recist_1_1_of_these_numbers,,,baseline,PR\r\n"
              "new_lesions,,,,1\r\n");
}

TEST(FollowUpTest, OfANodeTheLongestShortAxisCounts) {
    const std::vector<FollowedExam> exams{
        {"20240101", {lesion("N", 25.0, 16.0, true)}},
        {"20240401", {lesion("N", 25.0, 8.0, true), lesion("N", 22.0, 14.0, true), lesion("N", 40.0, 1)}}};
    const FollowUp table = followUp(exams, 0);
    EXPECT_DOUBLE_EQ(table.lesions.at(0).sizes.at(1).mm, 14.0);
    EXPECT_EQ(table.sums.at(1).response, Response::stable);
}

TEST(FollowUpTest, ALesionThatIsBackAfterAllWereGoneIsProgress) {
    const std::vector<FollowedExam> exams{
        {"20240101", {lesion("A", 40.0, 1)}}, {"20240401", {}}, {"20240701", {lesion("A", 4.0, 1)}}};
    const FollowUp table = followUp(exams, 0, {{"a", 1}});
    EXPECT_EQ(table.sums.at(1).response, Response::complete);
    EXPECT_EQ(table.sums.at(2).response, Response::progress);
}

TEST(FollowUpTest, ALesionOfBeforeTheBaselineIsNotNew) {
    const std::vector<FollowedExam> exams{{"20230101", {lesion("Old", 20.0, 1)}},
                                          {"20240101", {lesion("A", 40.0, 1)}},
                                          {"20240401", {lesion("A", 40.0, 1), lesion("Old", 20.0, 1)}}};
    const FollowUp table = followUp(exams, 1);
    ASSERT_EQ(table.notes.size(), 1u);
    EXPECT_NE(table.notes.front().english().find("before the baseline"), std::string::npos);
    EXPECT_NE(toCsv(table).find("new_lesions,,,,,0"), std::string::npos);
}

}  // namespace
}  // namespace macula::scene
