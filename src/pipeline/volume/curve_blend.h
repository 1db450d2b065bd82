// How a curve goes from one of its points to the next: the rule of vtkPiecewiseFunction and
// vtkColorTransferFunction, which 3D Slicer's, ParaView's and MITK's files share. `u` is how far in value,
// from 0 to 1.
#pragma once

namespace macula {

// Straightens `u` so that the midpoint comes to lie at 0.5, then pushes it away from there by the power 1 +
// 10 sharpness. 0 to 1. Below a sharpness of 0.01 nothing is pushed; above 0.99 it is 0 or 1.
double warpedFraction(double u, double midpoint, double sharpness);

// How far in height: a cubic Hermite curve over warpedFraction whose tangents flatten as the sharpness grows,
// and a line below a sharpness of 0.01. 0 to 1, and 0.5 at the midpoint.
double blendedFraction(double u, double midpoint, double sharpness);

}  // namespace macula
