// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/clump_drag.h"

#include <stdexcept>

namespace clay {

using Eigen::Vector3d;

ClumpDragKind clumpDragKind(const std::string& name)
{
  if (name == "sphereSum") return ClumpDragKind::sphereSum;
  if (name == "resistance") return ClumpDragKind::resistance;
  throw std::invalid_argument("'" + name + "'; it must be sphereSum or resistance");
}

const char* name(ClumpDragKind kind) { return kind == ClumpDragKind::sphereSum ? "sphereSum" : "resistance"; }

ClumpDrag::ClumpDrag(const Clump& clump, const Matrix6d& R, ShapeLaw law) : R_(R), law_(law), shape_(clump) {}

double ClumpDrag::stokes(const Vector3d& direction) const
{
  const double length2 = direction.squaredNorm();
  if (!(length2 > 0)) return R_.topLeftCorner<3, 3>().trace() / 3;
  return direction.dot(R_.topLeftCorner<3, 3>() * direction) / length2;
}

double ClumpDrag::growth(const Vector3d& direction, double Re) const
{
  if (!(Re > 0)) return 1;
  ShapeFactors shape = shape_.factors(direction);
  shape.stokes = stokes(direction) / (3 * 3.14159265358979323846 * diameter());
  return shapeDragFactor(law_, Re, shape);
}

}  // namespace clay
