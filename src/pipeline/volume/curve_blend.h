// How a curve leads from one of its points to the next: the rule of vtkPiecewiseFunction and
// vtkColorTransferFunction, which files of 3D Slicer, ParaView and MITK share. `u` is the position between
// the values of both points, from 0 to 1.
#pragma once

namespace macula {

// Maps `u` so that the midpoint lies at 0.5, then pushes it away from there by the power 1 + 10 sharpness.
// The result is 0 to 1. Below a sharpness of 0.01 nothing is pushed; above 0.99 the result is 0 or 1.
double warpedFraction(double u, double midpoint, double sharpness);

// The position between the heights of both points: a cubic Hermite curve over warpedFraction whose tangents
// flatten as the sharpness grows, and a line below a sharpness of 0.01. 0 to 1, and 0.5 at the midpoint.
double blendedFraction(double u, double midpoint, double sharpness);

}  // namespace macula
