#include <vtkAutoInit.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <chrono>
#include <cmath>

#include "base/elapsed.h"
#include "base/parallel.h"
#include "evaluate/vtk_cast.h"

VTK_MODULE_INIT(vtkRenderingOpenGL2)
VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2)

namespace macula::evaluate {

namespace {

using trace::Look;

// The refinement of rays and steps for the converged picture.
constexpr int kFiner = 3;

// Stores integers in VTK's fastest type for them, other values as float.
vtkNew<vtkImageData> imageOf(const Volume& volume) {
    const glm::ivec3 size = volume.size();
    const ValueRange range = {volume.unitsFromStored()(volume.storedRange().low),
                              volume.unitsFromStored()(volume.storedRange().high)};
    const UnitsFromStored units = volume.unitsFromStored();
    const bool whole = units.slope == 1.0 && units.intercept == std::floor(units.intercept) &&
                       range.low >= -32768.0 && range.high <= 32767.0;
    vtkNew<vtkImageData> image;
    image->SetDimensions(size.x, size.y, size.z);
    const glm::dmat4& m = volume.worldFromVoxel();
    image->SetSpacing(glm::length(glm::dvec3(m[0])), glm::length(glm::dvec3(m[1])),
                      glm::length(glm::dvec3(m[2])));
    image->AllocateScalars(whole ? VTK_SHORT : VTK_FLOAT, 1);
    parallelFor(static_cast<std::size_t>(size.z), [&](std::size_t k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                const double value = volume.value(i, j, static_cast<int>(k));
                void* cell = image->GetScalarPointer(i, j, static_cast<int>(k));
                if (whole)
                    *static_cast<short*>(cell) = static_cast<short>(value);
                else
                    *static_cast<float*>(cell) = static_cast<float>(value);
            }
        }
    });
    return image;
}

void setCurves(const VtkCastRequest& options, vtkVolumeProperty& property) {
    vtkNew<vtkPiecewiseFunction> opacity;
    vtkNew<vtkColorTransferFunction> colour;
    if (trace::isProjection(options.look)) {
        const double low = options.window.center - 0.5 * options.window.width;
        const double high = options.window.center + 0.5 * options.window.width;
        colour->AddRGBPoint(low, 0, 0, 0);
        colour->AddRGBPoint(high, 1, 1, 1);
        // A small opacity, because VTK stops a sum that is full.
        const double share = options.look == Look::average ? 1e-3 : 1.0;
        opacity->AddPoint(low, share);
        opacity->AddPoint(high, share);
    } else {
        for (const OpacityPoint& p : options.function.opacity)
            opacity->AddPoint(p.value, p.opacity, p.midpoint, p.sharpness);
        for (const ColourPoint& p : options.function.colour)
            colour->AddRGBPoint(p.value, p.colour.r, p.colour.g, p.colour.b, p.midpoint, p.sharpness);
        property.SetScalarOpacityUnitDistance(options.function.unitDistanceMm / options.function.density);
    }
    if (options.shading) {
        property.ShadeOn();
        property.SetAmbient(options.function.lighting.ambient);
        property.SetDiffuse(options.function.lighting.diffuse);
        property.SetSpecular(options.function.lighting.specular);
        property.SetSpecularPower(options.function.lighting.specularPower);
    }
    property.SetColor(colour);
    property.SetScalarOpacity(opacity);
    property.SetInterpolationTypeToLinear();
}

void setBlending(Look look, vtkFixedPointVolumeRayCastMapper& mapper) {
    if (look == Look::mip) mapper.SetBlendModeToMaximumIntensity();
    if (look == Look::minip) mapper.SetBlendModeToMinimumIntensity();
    if (look == Look::average) mapper.SetBlendModeToAdditive();
}

// VTK's CPU mapper has no oriented grids, so the eye is transformed into the frame of the grid's axes.
Result<void> setCamera(const trace::View& view, const Volume& volume, vtkCamera& camera) {
    const glm::dmat4& m = volume.worldFromVoxel();
    const glm::dmat3 axes(glm::normalize(glm::dvec3(m[0])), glm::normalize(glm::dvec3(m[1])),
                          glm::normalize(glm::dvec3(m[2])));
    if (!(glm::determinant(axes) > 1.0 - 1e-6)) {
        return Error{ErrorCode::inputNotUsable,
                     Text("VTK's CPU mapper cannot show this grid."),
                     {},
                     Text("Choose a series without tilt.")};
    }
    const auto toGrid = [&](const glm::dvec3& direction) { return glm::transpose(axes) * direction; };
    const glm::dvec3 position = toGrid(view.camera.positionMm - glm::dvec3(m[3]));
    const glm::dvec3 target = toGrid(view.camera.targetMm - glm::dvec3(m[3]));
    const glm::dvec3 up = toGrid(view.camera.up);
    camera.SetPosition(position.x, position.y, position.z);
    camera.SetFocalPoint(target.x, target.y, target.z);
    camera.SetViewUp(up.x, up.y, up.z);
    camera.SetViewAngle(view.camera.verticalFovDeg);
    return {};
}

// Reads a window `finer` times as large, and averages its pixels.
image::Image pictureOf(vtkRenderWindow& window, const trace::View& view, int finer) {
    vtkNew<vtkUnsignedCharArray> bytes;
    const int width = view.width * finer;
    const int height = view.height * finer;
    window.GetPixelData(0, 0, width - 1, height - 1, 1, bytes);
    image::Image picture{
        .width = view.width,
        .height = view.height,
        .channels = 3,
        .encoding = image::Encoding::display,
        .pixels = std::vector<float>(std::size_t(view.width) * std::size_t(view.height) * 3)};
    const float weight = 1.0f / (255.0f * float(finer * finer));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t pixel =
                (std::size_t((height - 1 - y) / finer) * std::size_t(view.width) + std::size_t(x / finer)) *
                3;
            for (int c = 0; c < 3; ++c) {
                picture.pixels[pixel + std::size_t(c)] +=
                    weight * float(bytes->GetValue((vtkIdType(y) * width + x) * 3 + c));
            }
        }
    }
    return picture;
}

Result<VtkCast> cast(const VtkCastRequest& options, const std::function<void()>& afterTurn) {
    vtkObject::GlobalWarningDisplayOff();
    vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
    mapper->SetInputData(imageOf(*options.volume));
    mapper->SetNumberOfThreads(static_cast<int>(options.threads));
    mapper->AutoAdjustSampleDistancesOff();
    mapper->SetImageSampleDistance(1.0f);
    mapper->LockSampleDistanceToInputSpacingOn();
    setBlending(options.look, *mapper);
    vtkNew<vtkVolumeProperty> property;
    setCurves(options, *property);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    volume->SetProperty(property);
    vtkNew<vtkRenderer> renderer;
    renderer->AddVolume(volume);
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetSize(options.view.width, options.view.height);
    window->AddRenderer(renderer);
    window->SetDesiredUpdateRate(1e-4);
    MACULA_TRY_VOID(setCamera(options.view, *options.volume, *renderer->GetActiveCamera()));
    renderer->ResetCameraClippingRange();

    const auto seconds = [&] {
        renderer->GetActiveCamera()->Modified();
        const auto since = std::chrono::steady_clock::now();
        window->Render();
        return secondsSince(since);
    };
    VtkCast result;
    result.firstSeconds = seconds();
    for (int turn = 0; turn < options.turns; ++turn) {
        result.seconds.push_back(seconds());
        afterTurn();
    }
    result.picture = pictureOf(*window, options.view, 1);
    result.stepMm = mapper->GetSampleDistance();
    mapper->LockSampleDistanceToInputSpacingOff();
    mapper->SetSampleDistance(static_cast<float>(result.stepMm / kFiner));
    mapper->SetInteractiveSampleDistance(static_cast<float>(result.stepMm / kFiner));
    seconds();
    result.fineSeconds = seconds();
    result.fine = pictureOf(*window, options.view, 1);
    window->SetSize(options.view.width * kFiner, options.view.height * kFiner);
    window->Render();
    result.converged = pictureOf(*window, options.view, kFiner);
    return result;
}

}  // namespace

}  // namespace macula::evaluate

void maculaCastWithVtk(const macula::evaluate::VtkCastRequest& options,
                       const std::function<void()>& afterTurn,
                       macula::Result<macula::evaluate::VtkCast>& result) {
    result = macula::evaluate::cast(options, afterTurn);
}
