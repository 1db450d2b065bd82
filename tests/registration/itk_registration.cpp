#include "registration/itk_registration.h"

#include <itkEuler3DTransform.h>
#include <itkImage.h>
#include <itkImageRegistrationMethodv4.h>
#include <itkMattesMutualInformationImageToImageMetricv4.h>
#include <itkRegistrationParameterScalesFromPhysicalShift.h>
#include <itkRegularStepGradientDescentOptimizerv4.h>

#include <cmath>

namespace macula::registration::test {

namespace {

constexpr int kBinsOfItk = 40;  // as many as registration/intensity_bins.h has
constexpr double kShareOfPoints = 0.2;
constexpr int kSeed = 20251125;
constexpr unsigned kMostIterations = 200;
constexpr unsigned kLevels = 3;

using Image = itk::Image<float, 3>;
using Transform = itk::Euler3DTransform<double>;
using Metric = itk::MattesMutualInformationImageToImageMetricv4<Image, Image>;
using Optimizer = itk::RegularStepGradientDescentOptimizerv4<double>;
using Method = itk::ImageRegistrationMethodv4<Image, Image, Transform>;

// Null for sheared voxels.
Image::Pointer imageOf(const Volume& volume) {
    const glm::dmat4& m = volume.worldFromVoxel();
    const glm::ivec3 size = volume.size();
    auto image = Image::New();
    Image::SizeType extent;
    Image::SpacingType spacing;
    Image::PointType origin;
    Image::DirectionType direction;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const glm::dvec3 step(m[int(axis)]);
        extent[axis] = Image::SizeValueType(size[int(axis)]);
        spacing[axis] = glm::length(step);
        origin[axis] = m[3][int(axis)];
        for (unsigned row = 0; row < 3; ++row) direction[row][axis] = step[int(row)] / spacing[axis];
        const glm::dvec3 next(m[int((axis + 1) % 3)]);
        if (std::abs(glm::dot(step, next)) > 1e-6 * glm::length(step) * glm::length(next)) return nullptr;
    }
    image->SetRegions(extent);
    image->SetSpacing(spacing);
    image->SetOrigin(origin);
    image->SetDirection(direction);
    image->Allocate();
    float* to = image->GetBufferPointer();
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) *to++ = float(volume.value(i, j, k));
    return image;
}

Transform::Pointer aboutTheMiddleOf(const Volume& volume) {
    auto transform = Transform::New();
    const glm::dvec3 middle = volume.worldBox().centre();
    Transform::InputPointType centre;
    for (unsigned axis = 0; axis < 3; ++axis) centre[axis] = middle[int(axis)];
    transform->SetCenter(centre);
    transform->SetIdentity();
    return transform;
}

glm::dmat4 matrixOf(const Transform& transform) {
    glm::dmat4 matrix(1.0);
    const auto& turn = transform.GetMatrix();
    const auto& shift = transform.GetOffset();
    for (unsigned row = 0; row < 3; ++row) {
        for (unsigned column = 0; column < 3; ++column) matrix[int(column)][int(row)] = turn[row][column];
        matrix[3][int(row)] = shift[row];
    }
    return matrix;
}

}  // namespace

Result<ItkRegistration> registerByItk(const Volume& fixed, const Volume& moving) try {
    const Image::Pointer fixedImage = imageOf(fixed);
    const Image::Pointer movingImage = imageOf(moving);
    if (fixedImage == nullptr || movingImage == nullptr)
        return Error{ErrorCode::inputNotUsable, Text("An image of ITK has no sheared voxels."), {}, {}};
    auto metric = Metric::New();
    metric->SetNumberOfHistogramBins(kBinsOfItk);
    auto scales = itk::RegistrationParameterScalesFromPhysicalShift<Metric>::New();
    scales->SetMetric(metric);
    auto optimizer = Optimizer::New();
    optimizer->SetScalesEstimator(scales);
    optimizer->SetDoEstimateLearningRateOnce(true);
    optimizer->SetNumberOfIterations(kMostIterations);
    optimizer->SetMinimumStepLength(1e-4);
    optimizer->SetRelaxationFactor(0.5);
    optimizer->SetGradientMagnitudeTolerance(1e-6);

    const Transform::Pointer transform = aboutTheMiddleOf(fixed);
    auto method = Method::New();
    method->SetFixedImage(fixedImage);
    method->SetMovingImage(movingImage);
    method->SetInitialTransform(transform);
    method->InPlaceOn();
    method->SetMetric(metric);
    method->SetOptimizer(optimizer);
    method->SetNumberOfLevels(kLevels);
    Method::ShrinkFactorsArrayType shrink(kLevels);
    Method::SmoothingSigmasArrayType sigmas(kLevels);
    for (unsigned level = 0; level < kLevels; ++level) {
        shrink[level] = std::size_t(1) << (kLevels - 1 - level);
        sigmas[level] = level + 1 == kLevels ? 0.0 : double(shrink[level]);
    }
    method->SetShrinkFactorsPerLevel(shrink);
    method->SetSmoothingSigmasPerLevel(sigmas);
    method->SetSmoothingSigmasAreSpecifiedInPhysicalUnits(true);
    method->SetMetricSamplingStrategy(Method::MetricSamplingStrategyEnum::RANDOM);
    method->SetMetricSamplingPercentage(kShareOfPoints);
    method->MetricSamplingReinitializeSeed(kSeed);
    method->Update();
    return ItkRegistration{.movingFromFixed = matrixOf(*transform),
                           .value = optimizer->GetValue(),
                           .iterations = std::size_t(optimizer->GetCurrentIteration())};
} catch (const itk::ExceptionObject& exception) {
    // Of made volumes: nothing in it names anybody.
    return Error{
        ErrorCode::inputNotUsable, Text::verbatim(std::string("ITK: ") + exception.GetDescription()), {}, {}};
}

}  // namespace macula::registration::test
